// SPDX-License-Identifier: MIT
// Increases the speed of the last joint in small steps.
#include <ur_rtde/rtde_control_interface.h>
#include <ur_rtde/rtde_receive_interface.h>

#include "common.h"

int main(int, char** argv) {
    RTDEControlInterface rtde_control(argv[1]);
    RTDEReceiveInterface rtde_receive(argv[1]);
    std::vector<double> joint_speed = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    rtde_control.moveJ(kHome);
    for (unsigned int i = 0; i < 100; i++) {
        steady_clock::time_point t_start = rtde_control.initPeriod();
        require(rtde_control.speedJ(joint_speed, 0.5, 0.002), "speedJ");
        joint_speed[5] += 0.0005;
        rtde_control.waitPeriod(t_start);
    }
    require(rtde_receive.getActualQ()[5] > kHome[5] + 0.001, "the joint has turned");
    rtde_control.speedStop();
    rtde_control.stopScript();
    return 0;
}
