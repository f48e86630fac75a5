// SPDX-License-Identifier: MIT
// Moves down until contact. A second thread of the simulation applies the force (see the test).
#include <ur_rtde/rtde_control_interface.h>

#include "common.h"

int main(int, char** argv) {
    RTDEControlInterface rtde_control(argv[1]);
    std::vector<double> speed = {0, 0, -0.02, 0, 0, 0};
    std::cout << "moving" << std::endl;
    require(rtde_control.moveUntilContact(speed), "moveUntilContact");
    rtde_control.stopScript();
    return 0;
}
