// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/receive_fields.h"

#include "robot/rtde/fields.h"

namespace tiller::urrtde {

std::vector<std::string> receiveFields(bool upper) {
    std::vector<std::string> fields = {
        "timestamp",
        "target_q",
        "target_qd",
        "target_qdd",
        "target_current",
        "target_moment",
        "actual_q",
        "actual_qd",
        "actual_current",
        "joint_control_output",
        "actual_TCP_pose",
        "actual_TCP_speed",
        "actual_TCP_force",
        "target_TCP_pose",
        "target_TCP_speed",
        "actual_digital_input_bits",
        "joint_temperatures",
        "actual_execution_time",
        "robot_mode",
        "joint_mode",
        "safety_mode",
        "actual_tool_accelerometer",
        "speed_scaling",
        "target_speed_fraction",
        "actual_momentum",
        "actual_main_voltage",
        "actual_robot_voltage",
        "actual_robot_current",
        "actual_joint_voltage",
        "actual_digital_output_bits",
        "runtime_state",
        "standard_analog_input0",
        "standard_analog_input1",
        "standard_analog_output0",
        "standard_analog_output1",
        "robot_status_bits",
        "safety_status_bits",
        "ft_raw_wrench",
        "payload",
        "payload_cog",
        "payload_inertia",
    };
    const int offset = upper ? rtde::kFirstUpperRegister : 0;
    constexpr int kFirst = 12;
    constexpr int kLast = 19;
    fields.push_back(rtde::intRegisterName(rtde::Direction::Output, 2 + offset));
    for (int n = kFirst; n <= kLast; ++n) {
        fields.push_back(rtde::intRegisterName(rtde::Direction::Output, n + offset));
    }
    for (int n = kFirst; n <= kLast; ++n) {
        fields.push_back(rtde::doubleRegisterName(rtde::Direction::Output, n + offset));
    }
    return fields;
}

}  // namespace tiller::urrtde
