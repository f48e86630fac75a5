// SPDX-License-Identifier: MIT
#include "robot/receive/default_fields.h"

#include "robot/receive/receiver.h"
#include "robot/rtde/fields.h"

namespace tiller::receive {

std::vector<std::string> commonFields() {
    return {
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
    };
}

void addOutputRegisters(std::vector<std::string>& fields, bool upper) {
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
}

std::vector<std::string> defaultFields() {
    // The list of names must not exceed 2048 bytes, the limit of one setup request.
    std::vector<std::string> fields = commonFields();
    for (const char* shown : {
             "tcp_offset",
             "safety_status",
             "analog_io_types",
             "tool_mode",
             "tool_temperature",
             "tool_output_voltage",
             "tool_output_current",
             "tool_analog_input0",
             "tool_analog_input1",
             "ft_raw_wrench",
             "payload",
             "payload_cog",
             "payload_inertia",
         }) {
        fields.emplace_back(shown);
    }
    addOutputRegisters(fields, false);
    addOutputRegisters(fields, true);
    return fields;
}

}  // namespace tiller::receive
