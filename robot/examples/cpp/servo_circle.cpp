// SPDX-License-Identifier: MIT
// Moves the tool in a circle of 3 cm, with one target per packet.
#include <cmath>
#include <iostream>

#include "robot/control/packet_loop.h"

using namespace tiller;
using namespace std::chrono_literals;

int main(int, char** argv) {
    control::Controller controller({.host = argv[1]});
    controller.takeControl(Deadline::after(5s)).value();
    const Pose start = Pose::fromArray(controller.status().tcpPose);

    const auto circle = [&](const control::CycleState& cycle) -> std::optional<Pose> {
        const double angle = 3.14159265 * cycle.time;  // runs in the control thread: do not wait or allocate
        Pose target = start;
        target.position += 0.03 * Eigen::Vector3d(std::cos(angle) - 1, std::sin(angle), 0);
        // An empty result ends the loop, and the arm stops.
        return cycle.time < 2 ? std::optional(target) : std::nullopt;
    };
    control::CycleReport report;
    const auto done = control::PacketLoop(controller).servoL(circle, {}, Deadline::after(10s), &report);
    std::cout << report.cycles << " cycles, " << report.missed << " missed" << std::endl;
    done.value();
}
