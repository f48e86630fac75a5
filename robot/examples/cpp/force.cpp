// SPDX-License-Identifier: MIT
// Force mode: compliant along Z with a force of 5 N for one second.
#include <iostream>
#include <thread>

#include "robot/control/compliance.h"
#include "robot/control/tool_setup.h"

using namespace tiller;
using namespace std::chrono_literals;

int main(int, char** argv) {
    control::Controller controller({.host = argv[1]});
    controller.takeControl(Deadline::after(5s)).value();
    control::ToolSetup(controller).zeroForceSensor(Deadline::after(3s)).value();

    control::ForceMode push;
    push.compliant = {false, false, true, false, false, false};
    push.wrench.force.z() = -5;                       // [N]
    push.limits = {0.05, 0.05, 0.02, 0.2, 0.2, 0.2};  // Z: speed [m/s]; other axes: deviation [m, rad]
    control::Compliance compliance(controller);
    compliance.setForceMode(push, Deadline::after(3s)).value();
    const double before = controller.status().tcpPose[2];
    std::this_thread::sleep_for(1s);
    std::cout << "sank " << 1000 * (before - controller.status().tcpPose[2]) << " mm" << std::endl;
    compliance.endForceMode(Deadline::after(3s)).value();
}
