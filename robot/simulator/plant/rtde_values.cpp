// SPDX-License-Identifier: MIT
#include "robot/simulator/plant/rtde_values.h"

#include <charconv>
#include <unordered_map>

namespace tiller::simulator {

namespace {

using Read = FieldSource::Read;

void put(double* into, const Vector6& v) {
    Vector6::Map(into) = v;
}
void put(double* into, const Eigen::Vector3d& v) {
    Eigen::Vector3d::Map(into) = v;
}
void put(double* into, const Pose& pose) {
    Eigen::Vector3d::Map(into) = pose.position;
    Eigen::Vector3d::Map(into + 3) = pose.rotation;
}
template <class Quantity>
void put(double* into, const JointArray<Quantity>& v) {
    put(into, v.values);
}
void put(double* into, const Twist& v) {
    put(into, v.vector());
}
void put(double* into, const Wrench& v) {
    put(into, v.vector());
}
template <class Number>
requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
void put(double* into, Number v) {
    *into = static_cast<double>(v);
}

/// The value of a terminal as reported by RTDE: [mA] in the current domain, otherwise [V].
double analog(double terminal, unsigned domain) {
    return domain == 0 ? terminal * 1000.0 : terminal;
}

// One line per field; `t` is the telemetry and `a` the state of the arm.
#define TILLER_FIELD(name, expression)                                    \
    {                                                                     \
#name, [](const Telemetry& t, std::size_t, double* into) {              \
            [[maybe_unused]] const arm::ArmState& a = *t.arm;                   \
            [[maybe_unused]] const Pins& p = *t.pins;                           \
            put(into, expression);                                              \
        } \
    }

const std::unordered_map<std::string_view, Read>& namedSources() {
    static const std::unordered_map<std::string_view, Read> table = {
        TILLER_FIELD(timestamp, t.timestamp),
        TILLER_FIELD(target_q, a.targetQ),
        TILLER_FIELD(target_qd, a.targetQd),
        TILLER_FIELD(target_qdd, a.targetQdd),
        TILLER_FIELD(target_current, a.targetCurrent),
        TILLER_FIELD(target_moment, a.targetMoment),
        TILLER_FIELD(actual_q, a.actualQ),
        TILLER_FIELD(actual_qd, a.actualQd),
        TILLER_FIELD(actual_current, a.actualCurrent),
        TILLER_FIELD(actual_current_window, a.actualCurrentWindow),
        TILLER_FIELD(actual_current_as_torque, a.actualMoment),
        TILLER_FIELD(joint_control_output, a.jointControlOutput),
        TILLER_FIELD(actual_TCP_pose, a.actualTcpPose),
        TILLER_FIELD(actual_TCP_speed, a.actualTcpSpeed),
        TILLER_FIELD(actual_TCP_force, t.tcpForce),
        TILLER_FIELD(target_TCP_pose, a.targetTcpPose),
        TILLER_FIELD(target_TCP_speed, a.targetTcpSpeed),
        TILLER_FIELD(actual_TCP_acceleration, a.actualTcpAcceleration),
        TILLER_FIELD(target_TCP_acceleration, a.targetTcpAcceleration),
        TILLER_FIELD(tcp_offset, t.tcpOffset),
        TILLER_FIELD(joint_temperatures, a.jointTemperature),
        TILLER_FIELD(actual_execution_time, t.executionTime),
        TILLER_FIELD(target_execution_time, t.executionTime),
        TILLER_FIELD(actual_tool_accelerometer, a.toolAccelerometer),
        TILLER_FIELD(speed_scaling, t.speedScaling),
        TILLER_FIELD(target_speed_fraction, t.speedSlider),
        TILLER_FIELD(time_scale_source, t.timeScaleSource),
        TILLER_FIELD(actual_momentum, a.momentum),
        TILLER_FIELD(elbow_position, a.elbowPosition),
        TILLER_FIELD(elbow_velocity, a.elbowVelocity),
        TILLER_FIELD(tcp_force_scalar, t.tcpForce.force.norm()),
        TILLER_FIELD(dexterity, 0),
        TILLER_FIELD(ft_raw_wrench, a.ftRawWrench),
        TILLER_FIELD(wrench_calc_from_currents, a.wrenchFromCurrents),
        TILLER_FIELD(joint_position_deviation_ratio, a.positionDeviationRatio),
        TILLER_FIELD(collision_detection_ratio, a.collisionRatio),
        TILLER_FIELD(payload, t.payload.mass),
        TILLER_FIELD(payload_cog, t.payload.centreOfGravity),
        TILLER_FIELD(payload_inertia, t.payload.inertia),
        TILLER_FIELD(script_control_line, t.scriptLine),
        TILLER_FIELD(target_gravity, t.gravity),
        TILLER_FIELD(target_base_acceleration, (Vector6() << t.gravity, Eigen::Vector3d::Zero()).finished()),
        TILLER_FIELD(target_base_wrench, a.targetBaseWrench),
        TILLER_FIELD(control_step, t.tick),
        TILLER_FIELD(robot_mode, t.robotMode),
        TILLER_FIELD(joint_mode, Vector6::Constant(static_cast<double>(t.jointMode)).eval()),
        TILLER_FIELD(safety_mode, t.safetyMode),
        TILLER_FIELD(safety_status, t.safetyStatus),
        TILLER_FIELD(runtime_state, t.runtimeState),
        TILLER_FIELD(robot_status_bits, t.robotStatusBits()),
        TILLER_FIELD(safety_status_bits, t.safetyStatusBits),
        TILLER_FIELD(tool_mode, t.powered ? JointMode::Running : JointMode::PowerOff),
        TILLER_FIELD(tool_output_mode, p.toolOutputMode),
        TILLER_FIELD(tool_digital_output0_mode, p.toolDigitalOutputModes[0]),
        TILLER_FIELD(tool_digital_output1_mode, p.toolDigitalOutputModes[1]),
        TILLER_FIELD(actual_digital_input_bits, p.digitalInputs),
        TILLER_FIELD(actual_digital_output_bits, p.digitalOutputs),
        TILLER_FIELD(actual_configurable_digital_input_bits, (p.digitalInputs >> kConfigurablePin) & 0xFFU),
        TILLER_FIELD(actual_configurable_digital_output_bits, (p.digitalOutputs >> kConfigurablePin) & 0xFFU),
        TILLER_FIELD(analog_io_types, p.analogInputDomains[0] | (p.analogInputDomains[1] << 1U) |
                                          (p.analogOutputDomains[0] << 2U) |
                                          (p.analogOutputDomains[1] << 3U)),
        TILLER_FIELD(standard_analog_input0, analog(p.analogInputs[0], p.analogInputDomains[0])),
        TILLER_FIELD(standard_analog_input1, analog(p.analogInputs[1], p.analogInputDomains[1])),
        TILLER_FIELD(standard_analog_output0, analog(p.analogOutput(0), p.analogOutputDomains[0])),
        TILLER_FIELD(standard_analog_output1, analog(p.analogOutput(1), p.analogOutputDomains[1])),
        TILLER_FIELD(io_current, 0),
        TILLER_FIELD(tool_analog_input_types, p.toolAnalogDomains[0] | (p.toolAnalogDomains[1] << 1U)),
        TILLER_FIELD(tool_analog_input0, analog(p.toolAnalogInputs[0], p.toolAnalogDomains[0])),
        TILLER_FIELD(tool_analog_input1, analog(p.toolAnalogInputs[1], p.toolAnalogDomains[1])),
        TILLER_FIELD(tool_output_voltage, p.toolVoltage),
        TILLER_FIELD(tool_output_voltage_2, 0),
        TILLER_FIELD(tool_output_current, a.toolCurrent * 1000.0),
        TILLER_FIELD(tool_output_current_2, 0),
        TILLER_FIELD(tool_temperature, a.toolTemperature),
        TILLER_FIELD(actual_main_voltage, a.mainVoltage),
        TILLER_FIELD(actual_robot_voltage, a.robotVoltage),
        TILLER_FIELD(actual_robot_current, a.robotCurrent),
        TILLER_FIELD(actual_joint_voltage, a.jointVoltage),
        TILLER_FIELD(actual_robot_energy_consumed, a.energyConsumed),
        TILLER_FIELD(actual_robot_braking_energy_dissipated, a.energyBraked),
        TILLER_FIELD(encoder0_raw, t.encoders[0]),
        TILLER_FIELD(encoder1_raw, t.encoders[1]),
        TILLER_FIELD(euromap67_input_bits, 0),
        TILLER_FIELD(euromap67_output_bits, 0),
        TILLER_FIELD(euromap67_24V_voltage, 0),
        TILLER_FIELD(euromap67_24V_current, 0),
        TILLER_FIELD(output_bit_registers0_to_31, t.registers->output.word(0)),
        TILLER_FIELD(output_bit_registers32_to_63, t.registers->output.word(32)),
        TILLER_FIELD(input_bit_registers0_to_31, t.registers->input.word(0)),
        TILLER_FIELD(input_bit_registers32_to_63, t.registers->input.word(32)),
    };
    return table;
}

#undef TILLER_FIELD

struct RegisterFamily {
    std::string_view prefix;
    std::size_t count;
    Read read;
};

constexpr RegisterFamily kRegisterFamilies[] = {
    {"output_bit_register_", 128,
     [](const Telemetry& t, std::size_t n, double* into) { put(into, t.registers->output.bits[n]); }},
    {"input_bit_register_", 128,
     [](const Telemetry& t, std::size_t n, double* into) { put(into, t.registers->input.bits[n]); }},
    {"output_int_register_", 48,
     [](const Telemetry& t, std::size_t n, double* into) {
         put(into, t.registers->overwritten.seen(n, t.registers->output.ints[n]));
     }},
    {"input_int_register_", 48,
     [](const Telemetry& t, std::size_t n, double* into) { put(into, t.registers->input.ints[n]); }},
    {"output_double_register_", 48,
     [](const Telemetry& t, std::size_t n, double* into) { put(into, t.registers->output.doubles[n]); }},
    {"input_double_register_", 48,
     [](const Telemetry& t, std::size_t n, double* into) { put(into, t.registers->input.doubles[n]); }},
};

}  // namespace

std::optional<FieldSource> fieldSource(const rtde::Field& field) {
    const std::string_view name = field.name;
    if (const auto found = namedSources().find(name); found != namedSources().end()) {
        return FieldSource{found->second, 0, field.components()};
    }
    for (const RegisterFamily& family : kRegisterFamilies) {
        if (!name.starts_with(family.prefix)) {
            continue;
        }
        std::size_t number = 0;
        const std::string_view digits = name.substr(family.prefix.size());
        const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (parsed.ec == std::errc() && parsed.ptr == digits.data() + digits.size() &&
            number < family.count) {
            return FieldSource{family.read, number, 1};
        }
    }
    return std::nullopt;
}

OutputRecipe::OutputRecipe(const std::vector<std::string>& names, const SoftwareVersion& software,
                           bool isListed)
    : valid_(!names.empty()) {
    std::vector<rtde::DataType> types;
    for (const std::string& name : names) {
        const rtde::Field* field = rtde::findOutput(name);
        const bool exists =
            field != nullptr && (isListed ? field->isListedOn(software) : field->isAvailableOn(software));
        const auto source = exists ? fieldSource(*field) : std::nullopt;
        if (!source) {
            answers_.push_back(rtde::FieldAnswer::notFound());
            valid_ = false;
            continue;
        }
        answers_.push_back(rtde::FieldAnswer::of(field->type));
        sources_.push_back(*source);
        types.push_back(field->type);
    }
    layout_ = rtde::ValueLayout(std::move(types));
    values_.resize(layout_.components());
    package_.resize(rtde::dataPackageSize(layout_.wireBytes(), true));
    if (package_.size() > rtde::kMaxPackageSize) {
        valid_ = false;  // the package is too large for the size field
    }
}

rtde::ByteView OutputRecipe::write(const Telemetry& now, std::optional<std::uint8_t> recipeId) {
    double* into = values_.data();
    for (const FieldSource& source : sources_) {
        source.read(now, source.number, into);
        into += source.components;
    }
    const std::size_t size = rtde::writeDataPackage(package_, recipeId, layout_, values_);
    return rtde::ByteView(package_).first(size);
}

}  // namespace tiller::simulator
