// SPDX-License-Identifier: MIT
// Moves several robots at the same time and waits for all of them.
#include <deque>
#include <iostream>

#include "robot/control/motions.h"

using namespace tiller;
using namespace std::chrono_literals;

int main(int argc, char** argv) {
    std::deque<control::Controller> robots;
    for (int i = 1; i < argc; ++i) {
        robots.emplace_back(control::ControllerOptions{.host = argv[i]})
            .takeControl(Deadline::after(5s))
            .value();
    }
    std::deque<control::Motion> moves;
    for (control::Controller& robot : robots) {
        JointPositions target(robot.status().q);
        target[5] += 0.3;
        moves.push_back(control::Motions(robot).moveJ(target).value());
    }
    for (const control::Motion& move : moves) {
        move.wait(Deadline::after(30s)).value();
        std::cout << "took " << move.plan()->duration.count() << " s" << std::endl;
    }
}
