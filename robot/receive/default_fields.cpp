// SPDX-License-Identifier: MIT
#include "robot/receive/receiver.h"
#include "robot/rtde/fields.h"

namespace tiller::receive {

std::vector<std::string> defaultFields() {
    // What ur_rtde follows unless told otherwise, and what the interface shows besides. Together the names
    // have to stay below the 2048 bytes of one setup request.
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
        "tcp_offset",
        "actual_digital_input_bits",
        "actual_digital_output_bits",
        "joint_temperatures",
        "actual_execution_time",
        "robot_mode",
        "joint_mode",
        "safety_mode",
        "safety_status",
        "runtime_state",
        "robot_status_bits",
        "safety_status_bits",
        "actual_tool_accelerometer",
        "speed_scaling",
        "target_speed_fraction",
        "actual_momentum",
        "actual_main_voltage",
        "actual_robot_voltage",
        "actual_robot_current",
        "actual_joint_voltage",
        "standard_analog_input0",
        "standard_analog_input1",
        "standard_analog_output0",
        "standard_analog_output1",
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
    };
    // The registers ur_rtde's receive interface follows, in the lower and in the upper range.
    for (const int offset : {0, rtde::kFirstUpperRegister}) {
        fields.push_back(rtde::intRegisterName(rtde::Direction::Output, 2 + offset));
        for (int n = 12; n <= 19; ++n) {
            fields.push_back(rtde::intRegisterName(rtde::Direction::Output, n + offset));
        }
        for (int n = 12; n <= 19; ++n) {
            fields.push_back(rtde::doubleRegisterName(rtde::Direction::Output, n + offset));
        }
    }
    return fields;
}

}  // namespace tiller::receive
