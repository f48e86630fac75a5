// SPDX-License-Identifier: MIT
// Moves down until the tool makes contact.
#include <iostream>

#include "robot/control/motions.h"

using namespace tiller;
using namespace std::chrono_literals;

int main(int, char** argv) {
    control::Controller controller({.host = argv[1]});
    controller.takeControl(Deadline::after(5s)).value();

    Twist down;
    down.linear.z() = -0.03;  // [m/s]
    // Holding::Free: the motion needs no refresh(). Without contact, it is stopped after 10 s.
    auto touch = control::Motions(controller)
                     .moveUntilContact(down, Deadline::after(3s), {.holding = control::Holding::Free});
    const Result<void> felt = touch ? touch->wait(Deadline::after(10s)) : touch.error();
    if (!felt) {
        controller.stop();
        std::cerr << felt.error() << std::endl;
        return EXIT_FAILURE;
    }
    std::cout << "contact at " << controller.status().tcpPose[2] << " m" << std::endl;
}
