// SPDX-License-Identifier: MIT
// Moves in joint space and then along a line, and waits for each move.
#include <iostream>

#include "robot/control/motions.h"

using namespace tiller;
using namespace std::chrono_literals;

int main(int, char** argv) {
    control::Controller controller({.host = argv[1]});
    if (auto taken = controller.takeControl(Deadline::after(5s)); !taken) {
        std::cerr << taken.error() << std::endl;  // the message contains port, register and suggested action
        return EXIT_FAILURE;
    }
    control::Motions motions(controller);
    auto move = motions.moveJ({-1.6, -1.7, -2.2, -0.8, 1.6, 0.3}, {.speed = 0.5});  // [rad], [rad/s]
    Result<void> reached = move ? move->wait(Deadline::after(30s)) : move.error();
    if (reached) {
        Pose up = Pose::fromArray(controller.status().tcpPose);
        up.position.z() += 0.05;
        auto line = motions.moveL(up, {.speed = 0.1});  // [m/s], at most the cap of 0.25 m/s
        reached = line ? line->wait(Deadline::after(30s)) : line.error();
    }
    std::cout << (reached ? "target reached" : reached.error().message()) << std::endl;
    return reached ? EXIT_SUCCESS : EXIT_FAILURE;
}
