// SPDX-License-Identifier: MIT
#include "robot/receive/robot_state.h"

#include <cmath>

#include "robot/rtde/fields.h"

namespace tiller::receive {

double RobotState::number(std::string_view field, std::size_t component, double fallback) const {
    const auto values = sample_->field(field);
    return component < values.size() ? values[component] : fallback;
}

Vector6 RobotState::vector6(std::string_view field) const {
    const auto values = sample_->field(field);
    return values.size() == 6 ? Vector6(Eigen::Map<const Vector6>(values.data()))
                              : Vector6(Vector6::Constant(kAbsent));
}

Pose RobotState::pose(std::string_view field) const {
    const Vector6 v = vector6(field);
    return {v.head<3>(), v.tail<3>()};
}

std::optional<std::uint32_t> RobotState::bits32(std::string_view field) const {
    const auto bits = bits64(field);
    return bits ? std::optional(static_cast<std::uint32_t>(*bits)) : std::nullopt;
}

std::optional<std::uint64_t> RobotState::bits64(std::string_view field) const {
    const double value = number(field);
    const bool fits = value >= 0 && value < 18446744073709551616.0;
    return fits ? std::optional(static_cast<std::uint64_t>(value)) : std::nullopt;
}

std::array<JointMode, 6> RobotState::jointModes() const {
    std::array<JointMode, 6> modes;
    for (std::size_t i = 0; i < modes.size(); ++i) {
        modes[i] = static_cast<JointMode>(
            static_cast<std::int32_t>(number("joint_mode", i, static_cast<double>(JointMode::PowerOff))));
    }
    return modes;
}

RobotMode RobotState::robotMode() const {
    return static_cast<RobotMode>(
        static_cast<std::int32_t>(number("robot_mode", 0, static_cast<double>(RobotMode::Disconnected))));
}

SafetyMode RobotState::safetyMode() const {
    return static_cast<SafetyMode>(
        static_cast<std::int32_t>(number("safety_mode", 0, static_cast<double>(SafetyMode::Undefined))));
}

RuntimeState RobotState::runtimeState() const {
    return static_cast<RuntimeState>(
        static_cast<std::uint32_t>(number("runtime_state", 0, static_cast<double>(RuntimeState::Stopped))));
}

double RobotState::analogInput(int channel) const {
    return number(channel == 0 ? "standard_analog_input0" : "standard_analog_input1");
}

double RobotState::analogOutput(int channel) const {
    return number(channel == 0 ? "standard_analog_output0" : "standard_analog_output1");
}

Eigen::Vector3d RobotState::payloadCentreOfGravity() const {
    const auto values = sample_->field("payload_cog");
    return values.size() == 3 ? Eigen::Vector3d(values[0], values[1], values[2])
                              : Eigen::Vector3d(Eigen::Vector3d::Constant(kAbsent));
}

std::optional<int> RobotState::outputIntRegister(int number) const {
    const double value = this->number(rtde::intRegisterName(rtde::Direction::Output, number));
    return std::isnan(value) ? std::nullopt : std::optional(static_cast<int>(value));
}

double RobotState::outputDoubleRegister(int number) const {
    return this->number(rtde::doubleRegisterName(rtde::Direction::Output, number));
}

}  // namespace tiller::receive
