// SPDX-License-Identifier: MIT
#include "robot/receive/robot_state.h"

#include "robot/rtde/fields.h"

namespace tiller::receive {

double RobotState::number(std::string_view field, std::size_t component, double fallback) const {
    const auto values = sample_->field(field);
    return component < values.size() ? values[component] : fallback;
}

Vector6 RobotState::vector6(std::string_view field) const {
    const auto values = sample_->field(field);
    return values.size() == 6 ? Vector6(Eigen::Map<const Vector6>(values.data())) : Vector6(Vector6::Zero());
}

Pose RobotState::pose(std::string_view field) const {
    const Vector6 v = vector6(field);
    return {v.head<3>(), v.tail<3>()};
}

std::uint32_t RobotState::bits32(std::string_view field) const {
    return static_cast<std::uint32_t>(bits64(field));
}

std::uint64_t RobotState::bits64(std::string_view field) const {
    const double value = number(field);
    return value >= 0 && value < 18446744073709551616.0 ? static_cast<std::uint64_t>(value) : 0;
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
                              : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

int RobotState::outputIntRegister(int number) const {
    return static_cast<int>(this->number(rtde::intRegisterName(rtde::Direction::Output, number)));
}

double RobotState::outputDoubleRegister(int number) const {
    return this->number(rtde::doubleRegisterName(rtde::Direction::Output, number));
}

}  // namespace tiller::receive
