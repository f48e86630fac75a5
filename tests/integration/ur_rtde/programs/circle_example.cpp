// SPDX-License-Identifier: MIT
// Listing 6 of the ur_rtde publication with a shorter circle. The setpoints follow the speed slider.
#include <ur_rtde/rtde_control_interface.h>
#include <ur_rtde/rtde_receive_interface.h>

#include "common.h"

std::vector<double> getCircleTarget(const std::vector<double>& pose, double time) {
    std::vector<double> target = pose;
    target[0] = pose[0] + 0.02 * (std::cos(2 * M_PI * time) - 1);
    target[1] = pose[1] + 0.02 * std::sin(2 * M_PI * time);
    return target;
}

int main(int, char** argv) {
    double time_counter = 0.0;
    std::string robot_ip = argv[1];
    double freq = 500.0;
    double dt = 1.0 / freq;
    uint16_t flags = RTDEControlInterface::FLAG_VERBOSE | RTDEControlInterface::FLAG_UPLOAD_SCRIPT;
    int ur_cap_port = 50002;
    int rt_receive_priority = 90;
    int rt_control_priority = 85;
    RTDEReceiveInterface rtde_receive(robot_ip, freq, {}, false, false, rt_receive_priority);
    RTDEControlInterface rtde_control(robot_ip, freq, flags, ur_cap_port, rt_control_priority);
    RTDEUtility::setRealtimePriority(80);  // if permitted

    std::vector<double> init_pose = rtde_receive.getActualTCPPose();
    while (time_counter < 0.5) {
        auto t_start = rtde_control.initPeriod();
        double speed_scaling_combined = rtde_receive.getSpeedScalingCombined();
        std::vector<double> servo_target = getCircleTarget(init_pose, time_counter);
        require(rtde_control.servoL(servo_target, 0.5, 0.5, dt, 0.1, 600), "servoL");
        rtde_control.waitPeriod(t_start);
        time_counter += dt * speed_scaling_combined;
    }
    while (!areNear(rtde_receive.getActualTCPPose(), getCircleTarget(init_pose, time_counter), 0.005)) {
        auto t_start = rtde_control.initPeriod();
        rtde_control.servoL(getCircleTarget(init_pose, time_counter), 0.5, 0.5, dt, 0.1, 600);
        rtde_control.waitPeriod(t_start);
    }
    rtde_control.servoStop();
    rtde_control.stopScript();
    return 0;
}
