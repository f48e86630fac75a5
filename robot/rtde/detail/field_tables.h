// SPDX-License-Identifier: MIT
#pragma once

// The single (non-register) entries of the field catalogue. Private to robot/rtde; other code uses fields.h.
// Source: RTDE guide. Entries marked kRecent are from newer software and the field tables of other clients.

#include <array>

#include "robot/rtde/fields.h"

namespace tiller::rtde::tables {

inline constexpr Since kAll{};
/// Recent e-Series and PolyScope X software; the first version is not documented.
inline constexpr Since kRecent{{Since::kNever, 0, 0, 0}, {}, false};

constexpr Since since(SoftwareVersion cb3, SoftwareVersion eSeries) {
    return {cb3, eSeries, true};
}
inline constexpr SoftwareVersion kNoCb3{Since::kNever, 0, 0, 0};
/// PolyScope X with the newer tool flange. Source: the vendor's Python client, recording with V3.
inline constexpr Since kSecondFlange{kNoCb3, {10, 15, 0, 0}, true};

using D = DataType;

constexpr Field out(const char* name, DataType type, const char* unit, const char* meaning,
                    Since first = kAll) {
    return {name, type, unit, meaning, Direction::Output, first};
}
constexpr Field in(const char* name, DataType type, const char* unit, const char* meaning,
                   Since first = kAll) {
    return {name, type, unit, meaning, Direction::Input, first};
}

// clang-format off
inline constexpr std::array kOutputs = {
    // motion and time
    out("timestamp", D::Double, "s", "time since the controller started"),
    out("target_q", D::Vector6D, "rad", "target joint positions"),
    out("target_qd", D::Vector6D, "rad/s", "target joint velocities"),
    out("target_qdd", D::Vector6D, "rad/s2", "target joint accelerations"),
    out("target_current", D::Vector6D, "A", "target joint currents"),
    out("target_moment", D::Vector6D, "Nm", "target joint torques"),
    out("actual_q", D::Vector6D, "rad", "joint positions"),
    out("actual_qd", D::Vector6D, "rad/s", "joint velocities"),
    out("actual_current", D::Vector6D, "A", "joint currents"),
    out("actual_current_window", D::Vector6D, "A", "allowed deviation from the target currents"),
    out("actual_current_as_torque", D::Vector6D, "Nm", "joint currents expressed as torques", kRecent),
    out("joint_control_output", D::Vector6D, "A", "joint control currents"),
    out("actual_TCP_pose", D::Vector6D, "m, rad", "TCP pose in the base frame, orientation as rotation vector"),
    out("actual_TCP_speed", D::Vector6D, "m/s, rad/s", "TCP velocity in the base frame"),
    out("actual_TCP_force", D::Vector6D, "N, Nm", "force and torque at the TCP without the payload's weight"),
    out("target_TCP_pose", D::Vector6D, "m, rad", "target TCP pose"),
    out("target_TCP_speed", D::Vector6D, "m/s, rad/s", "target TCP velocity"),
    out("actual_TCP_acceleration", D::Vector6D, "m/s2, rad/s2", "TCP acceleration", kRecent),
    out("target_TCP_acceleration", D::Vector6D, "m/s2, rad/s2", "target TCP acceleration", kRecent),
    out("tcp_offset", D::Vector6D, "m, rad", "pose of the TCP in the flange frame",
        since({3, 12, 3, 0}, {5, 5, 1, 0})),
    out("joint_temperatures", D::Vector6D, "degC", "joint temperatures"),
    out("actual_execution_time", D::Double, "ms", "duration of the controller's last control step"),
    out("target_execution_time", D::Double, "ms", "nominal duration of a control step", kRecent),
    out("actual_tool_accelerometer", D::Vector3D, "m/s2", "acceleration measured at the tool flange"),
    out("speed_scaling", D::Double, "", "speed scaling of the trajectory limiter, 0 to 1"),
    out("target_speed_fraction", D::Double, "", "speed slider, 0 to 1"),
    out("time_scale_source", D::Int32, "", "current limit of the speed scaling", kRecent),
    out("actual_momentum", D::Double, "kg m/s", "norm of the linear momentum"),
    out("elbow_position", D::Vector3D, "m", "elbow position in the base frame", since({3, 5, 0, 0}, {5, 0, 0, 0})),
    out("elbow_velocity", D::Vector3D, "m/s", "elbow velocity in the base frame", since({3, 5, 0, 0}, {5, 0, 0, 0})),
    out("tcp_force_scalar", D::Double, "N", "norm of the TCP force"),
    out("dexterity", D::Double, "", "distance from a singularity", kSecondFlange),
    out("ft_raw_wrench", D::Vector6D, "N, Nm", "raw wrench of the force sensor in the flange frame, not zeroed, with payload",
        since(kNoCb3, {5, 9, 0, 0})),
    out("wrench_calc_from_currents", D::Vector6D, "N, Nm", "TCP wrench estimated from joint currents", kRecent),
    out("joint_position_deviation_ratio", D::Double, "", "position deviation relative to its limit; protective stop at 1"),
    out("collision_detection_ratio", D::Double, "", "collision measure relative to its limit; protective stop at 1", kRecent),
    out("payload", D::Double, "kg", "payload mass", since({3, 11, 0, 0}, {5, 5, 1, 0})),
    out("payload_cog", D::Vector3D, "m", "payload centre of gravity", since({3, 11, 0, 0}, {5, 5, 1, 0})),
    out("payload_inertia", D::Vector6D, "kg m2", "payload inertia Ixx Iyy Izz Ixy Ixz Iyz",
        since({3, 15, 0, 0}, {5, 11, 0, 0})),
    out("script_control_line", D::UInt32, "", "script line that controls the arm, 0 for none",
        since({3, 14, 0, 0}, {5, 9, 0, 0})),
    out("target_gravity", D::Vector3D, "m/s2", "gravity used by the controller", kRecent),
    out("target_base_acceleration", D::Vector6D, "m/s2, rad/s2", "target acceleration of the base", kRecent),
    out("target_base_wrench", D::Vector6D, "N, Nm", "target wrench at the base", kRecent),
    out("control_step", D::UInt64, "", "number of the control step", kRecent),
    // modes and status
    out("robot_mode", D::Int32, "", "robot mode"),
    out("joint_mode", D::Vector6Int32, "", "joint modes"),
    out("safety_mode", D::Int32, "", "safety mode"),
    out("safety_status", D::Int32, "", "safety status", since({3, 10, 0, 0}, {5, 4, 0, 0})),
    out("runtime_state", D::UInt32, "", "program state"),
    out("robot_status_bits", D::UInt32, "", "bits: power on, program running, freedrive button, power button"),
    out("safety_status_bits", D::UInt32, "", "bits: normal, reduced, protective, recovery, safeguard, emergency..."),
    out("tool_mode", D::UInt32, "", "tool mode"),
    out("tool_output_mode", D::UInt8, "", "tool outputs: 0 digital, 1 dual-pin power"),
    out("tool_digital_output0_mode", D::UInt8, "", "driver of tool output 0: 1 sinking, 2 sourcing, 3 push-pull"),
    out("tool_digital_output1_mode", D::UInt8, "", "driver of tool output 1: 1 sinking, 2 sourcing, 3 push-pull"),
    // electrical and I/O
    out("actual_digital_input_bits", D::UInt64, "", "digital inputs: bits 0-7 standard, 8-15 configurable, 16-17 tool"),
    out("actual_digital_output_bits", D::UInt64, "", "digital outputs: bits 0-7 standard, 8-15 configurable, 16-17 tool"),
    out("actual_configurable_digital_input_bits", D::UInt64, "", "configurable digital inputs", kRecent),
    out("actual_configurable_digital_output_bits", D::UInt64, "", "configurable digital outputs", kRecent),
    out("analog_io_types", D::UInt32, "", "bits AI0, AI1, AO0, AO1: 0 current, 1 voltage"),
    out("standard_analog_input0", D::Double, "mA or V", "analog input 0, unit according to analog_io_types"),
    out("standard_analog_input1", D::Double, "mA or V", "analog input 1, unit according to analog_io_types"),
    out("standard_analog_output0", D::Double, "mA or V", "analog output 0, unit according to analog_io_types"),
    out("standard_analog_output1", D::Double, "mA or V", "analog output 1, unit according to analog_io_types"),
    out("io_current", D::Double, "mA", "current drawn by the I/O"),
    out("tool_analog_input_types", D::UInt32, "", "bits tool AI0, AI1: 0 current, 1 voltage"),
    out("tool_analog_input0", D::Double, "mA or V", "tool analog input 0"),
    out("tool_analog_input1", D::Double, "mA or V", "tool analog input 1"),
    out("tool_output_voltage", D::Int32, "V", "tool supply: 0, 12 or 24"),
    out("tool_output_voltage_2", D::Int32, "V", "supply of the second pin of a newer tool flange", kSecondFlange),
    out("tool_output_current", D::Double, "mA", "current drawn by the tool"),
    out("tool_output_current_2", D::Double, "mA", "current drawn from the second pin", kSecondFlange),
    out("tool_temperature", D::Double, "degC", "tool temperature"),
    out("actual_main_voltage", D::Double, "V", "main voltage of the safety board"),
    out("actual_robot_voltage", D::Double, "V", "arm supply voltage"),
    out("actual_robot_current", D::Double, "A", "arm supply current"),
    out("actual_joint_voltage", D::Vector6D, "V", "joint voltages"),
    out("actual_robot_energy_consumed", D::Double, "J", "energy consumed", kRecent),
    out("actual_robot_braking_energy_dissipated", D::Double, "J", "energy dissipated by braking", kRecent),
    out("encoder0_raw", D::Int32, "", "count of conveyor encoder 0", kRecent),
    out("encoder1_raw", D::Int32, "", "count of conveyor encoder 1", kRecent),
    out("euromap67_input_bits", D::UInt32, "", "Euromap 67 inputs"),
    out("euromap67_output_bits", D::UInt32, "", "Euromap 67 outputs"),
    out("euromap67_24V_voltage", D::Double, "V", "Euromap 67 24 V voltage"),
    out("euromap67_24V_current", D::Double, "mA", "Euromap 67 24 V current"),
};

inline constexpr std::array kInputs = {
    in("speed_slider_mask", D::UInt32, "", "1: apply speed_slider_fraction"),
    in("speed_slider_fraction", D::Double, "", "speed slider, 0 to 1"),
    in("standard_digital_output_mask", D::UInt8, "", "mask of the standard digital outputs to write"),
    in("standard_digital_output", D::UInt8, "", "values of the standard digital outputs"),
    in("configurable_digital_output_mask", D::UInt8, "", "mask of the configurable digital outputs to write"),
    in("configurable_digital_output", D::UInt8, "", "values of the configurable digital outputs"),
    in("tool_digital_output_mask", D::UInt8, "", "mask of the tool digital outputs to write", Since{{}, {}, false}),
    in("tool_digital_output", D::UInt8, "", "values of the tool digital outputs", Since{{}, {}, false}),
    in("standard_analog_output_mask", D::UInt8, "", "mask of the analog outputs to write"),
    in("standard_analog_output_type", D::UInt8, "", "domain of the analog outputs: 0 current, 1 voltage"),
    in("standard_analog_output_0", D::Double, "", "analog output 0 as a fraction of its range, 0 to 1"),
    in("standard_analog_output_1", D::Double, "", "analog output 1 as a fraction of its range, 0 to 1"),
    in("external_force_torque", D::Vector6D, "N, Nm", "wrench of an external sensor",
       since({3, 3, 0, 0}, {})),
};
// clang-format on

}  // namespace tiller::rtde::tables
