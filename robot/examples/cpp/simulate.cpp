// SPDX-License-Identifier: MIT
// Needs no robot: moves a simulated robot in this process like a real robot, and triggers a fault.
#include <iostream>
#include <thread>

#include "robot/control/motions.h"
#include "robot/simulator/simulator.h"

using namespace tiller;
using namespace std::chrono_literals;

int main() {
    simulator::Simulator robot({.listenAddress = "127.0.0.9", .poweredOn = true, .fastTransitions = true});
    robot.start().value();
    control::Controller controller({.host = "127.0.0.9"});
    controller.takeControl(Deadline::after(5s)).value();
    auto move = control::Motions(controller).moveJ({0, -1.57, 1.57, -1.57, -1.57, 0});
    std::this_thread::sleep_for(500ms);
    robot.protectiveStop();
    const Result<void> reached = move->wait(Deadline::after(30s));
    std::cout << (reached ? "target reached" : reached.error().message()) << std::endl;  // "UnsafeState: ..."
}
