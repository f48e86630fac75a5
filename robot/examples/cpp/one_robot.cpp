// SPDX-License-Identifier: MIT
// One object for data, control, outputs and dashboard services, with callbacks for events.
#include <iostream>

#include "robot/api/robot.h"

using namespace tiller;
using namespace std::chrono_literals;

int main(int, char** argv) {
    RobotOptions options;
    options.onEvent = [](const RobotEvent& event) { std::cout << "event " << event.kind << std::endl; };
    Robot robot(argv[1], options);
    robot.connect(Deadline::after(5s)).value();
    robot.takeControl(Deadline::after(10s)).value();

    const receive::Sample sample = robot.latest();
    JointPositions target = receive::RobotState(sample).q();
    target[5] += 0.3;
    robot.motions().moveJ(target).value().wait(Deadline::after(30s)).value();
    robot.outputs().setDigitalOutput(0, true, Deadline::after(3s)).value();

    dashboard::RobotService* service = robot.service(Deadline::after(3s)).value();
    std::cout << "service " << service->kind() << std::endl;
}
