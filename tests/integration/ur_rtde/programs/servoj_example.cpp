// SPDX-License-Identifier: MIT
// A joint follows a stream of setpoints.
#include <ur_rtde/rtde_control_interface.h>
#include <ur_rtde/rtde_receive_interface.h>

#include "common.h"

int main(int, char** argv) {
    RTDEControlInterface rtde_control(argv[1]);
    RTDEReceiveInterface rtde_receive(argv[1]);
    double velocity = 0.5;
    double acceleration = 0.5;
    double dt = 1.0 / 500;
    double lookahead_time = 0.1;
    double gain = 300;
    std::vector<double> joint_q = kHome;
    rtde_control.moveJ(joint_q);
    for (unsigned int i = 0; i < 200; i++) {
        steady_clock::time_point t_start = rtde_control.initPeriod();
        require(rtde_control.servoJ(joint_q, velocity, acceleration, dt, lookahead_time, gain), "servoJ");
        joint_q[0] += 0.001;
        joint_q[1] += 0.001;
        rtde_control.waitPeriod(t_start);
    }
    while (!areNear(rtde_receive.getActualQ(), joint_q, 0.02)) {
        steady_clock::time_point t_start = rtde_control.initPeriod();
        require(rtde_control.servoJ(joint_q, velocity, acceleration, dt, lookahead_time, gain), "servoJ");
        rtde_control.waitPeriod(t_start);
    }
    rtde_control.servoStop();
    rtde_control.stopScript();
    return 0;
}
