// SPDX-License-Identifier: MIT
// moveJ to a position, moveL 50 mm up, moveL_FK back down, and moveJ home.
#include <ur_rtde/rtde_control_interface.h>
#include <ur_rtde/rtde_receive_interface.h>

#include "common.h"

int main(int, char** argv) {
    RTDEControlInterface rtde_control(argv[1]);
    RTDEReceiveInterface rtde_receive(argv[1]);
    std::vector<double> there = kHome;
    there[0] += 0.3;
    require(rtde_control.moveJ(there, 1.05, 1.4), "moveJ");
    std::vector<double> pose = rtde_receive.getActualTCPPose();
    pose[2] += 0.05;
    require(rtde_control.moveL(pose, 0.25, 0.5), "moveL");
    require(rtde_control.moveL_FK(there), "moveL_FK");
    require(rtde_control.moveJ(kHome), "moveJ");
    require(isNear([&] { return rtde_receive.getActualQ(); }, kHome, 0.01), "the place");
    rtde_control.stopScript();
    return 0;
}
