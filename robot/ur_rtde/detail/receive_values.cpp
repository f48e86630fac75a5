// SPDX-License-Identifier: MIT
// The getters of RTDEReceiveInterface: which field each reads.
#include <stdexcept>

#include "robot/rtde/fields.h"
#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/receive_private.h"

namespace ur_rtde {

using List = std::vector<double>;
using tiller::rtde::Direction;
namespace check = tiller::urrtde::check;

namespace {
constexpr int kDigitalPins = 18;
}

double RTDEReceiveInterface::getTimestamp() {
    return d_->number("timestamp");
}

List RTDEReceiveInterface::getTargetQ() {
    return d_->list("target_q");
}

List RTDEReceiveInterface::getTargetQd() {
    return d_->list("target_qd");
}

List RTDEReceiveInterface::getTargetQdd() {
    return d_->list("target_qdd");
}

List RTDEReceiveInterface::getTargetCurrent() {
    return d_->list("target_current");
}

List RTDEReceiveInterface::getTargetMoment() {
    return d_->list("target_moment");
}

List RTDEReceiveInterface::getActualQ() {
    return d_->list("actual_q");
}

List RTDEReceiveInterface::getActualQd() {
    return d_->list("actual_qd");
}

List RTDEReceiveInterface::getActualCurrent() {
    return d_->list("actual_current");
}

List RTDEReceiveInterface::getJointControlOutput() {
    return d_->list("joint_control_output");
}

List RTDEReceiveInterface::getActualTCPPose() {
    return d_->list("actual_TCP_pose");
}

List RTDEReceiveInterface::getActualTCPSpeed() {
    return d_->list("actual_TCP_speed");
}

List RTDEReceiveInterface::getActualTCPForce() {
    return d_->list("actual_TCP_force");
}

List RTDEReceiveInterface::getTargetTCPPose() {
    return d_->list("target_TCP_pose");
}

List RTDEReceiveInterface::getTargetTCPSpeed() {
    return d_->list("target_TCP_speed");
}

uint64_t RTDEReceiveInterface::getActualDigitalInputBits() {
    return static_cast<uint64_t>(d_->number("actual_digital_input_bits"));
}

List RTDEReceiveInterface::getJointTemperatures() {
    return d_->list("joint_temperatures");
}

double RTDEReceiveInterface::getActualExecutionTime() {
    return d_->number("actual_execution_time");
}

int32_t RTDEReceiveInterface::getRobotMode() {
    return static_cast<int32_t>(d_->number("robot_mode"));
}

uint32_t RTDEReceiveInterface::getRobotStatus() {
    return static_cast<uint32_t>(d_->number("robot_status_bits"));
}

int32_t RTDEReceiveInterface::getSafetyMode() {
    return static_cast<int32_t>(d_->number("safety_mode"));
}

uint32_t RTDEReceiveInterface::getSafetyStatusBits() {
    return static_cast<uint32_t>(d_->number("safety_status_bits"));
}

List RTDEReceiveInterface::getActualToolAccelerometer() {
    return d_->list("actual_tool_accelerometer");
}

double RTDEReceiveInterface::getSpeedScaling() {
    return d_->number("speed_scaling");
}

double RTDEReceiveInterface::getTargetSpeedFraction() {
    return d_->number("target_speed_fraction");
}

double RTDEReceiveInterface::getActualMomentum() {
    return d_->number("actual_momentum");
}

double RTDEReceiveInterface::getActualMainVoltage() {
    return d_->number("actual_main_voltage");
}

double RTDEReceiveInterface::getActualRobotVoltage() {
    return d_->number("actual_robot_voltage");
}

double RTDEReceiveInterface::getActualRobotCurrent() {
    return d_->number("actual_robot_current");
}

List RTDEReceiveInterface::getActualJointVoltage() {
    return d_->list("actual_joint_voltage");
}

uint64_t RTDEReceiveInterface::getActualDigitalOutputBits() {
    return static_cast<uint64_t>(d_->number("actual_digital_output_bits"));
}

uint32_t RTDEReceiveInterface::getRuntimeState() {
    return static_cast<uint32_t>(d_->number("runtime_state"));
}

double RTDEReceiveInterface::getStandardAnalogInput0() {
    return d_->number("standard_analog_input0");
}

double RTDEReceiveInterface::getStandardAnalogInput1() {
    return d_->number("standard_analog_input1");
}

double RTDEReceiveInterface::getStandardAnalogOutput0() {
    return d_->number("standard_analog_output0");
}

double RTDEReceiveInterface::getStandardAnalogOutput1() {
    return d_->number("standard_analog_output1");
}

List RTDEReceiveInterface::getFtRawWrench() {
    return d_->list("ft_raw_wrench");
}

double RTDEReceiveInterface::getPayload() {
    return d_->number("payload");
}

List RTDEReceiveInterface::getPayloadCog() {
    return d_->list("payload_cog");
}

List RTDEReceiveInterface::getPayloadInertia() {
    return d_->list("payload_inertia");
}

std::vector<int32_t> RTDEReceiveInterface::getJointMode() {
    const List modes = d_->list("joint_mode");
    return {modes.begin(), modes.end()};
}

bool RTDEReceiveInterface::getDigitalInState(std::uint8_t input_id) {
    check::integer("input_id", input_id, 0, kDigitalPins - 1);
    return (getActualDigitalInputBits() >> input_id & 1U) != 0;
}

bool RTDEReceiveInterface::getDigitalOutState(std::uint8_t output_id) {
    check::integer("output_id", output_id, 0, kDigitalPins - 1);
    return (getActualDigitalOutputBits() >> output_id & 1U) != 0;
}

bool RTDEReceiveInterface::isProtectiveStopped() {
    return (getSafetyStatusBits() >> IS_PROTECTIVE_STOPPED & 1U) != 0;
}

bool RTDEReceiveInterface::isEmergencyStopped() {
    return (getSafetyStatusBits() >> IS_EMERGENCY_STOPPED & 1U) != 0;
}

int RTDEReceiveInterface::getOutputIntRegister(int output_id) {
    check::integer("output_id", output_id, 0, tiller::rtde::kRegisterCount - 1);
    return static_cast<int>(d_->registerValue(tiller::rtde::intRegisterName(Direction::Output, output_id)));
}

double RTDEReceiveInterface::getOutputDoubleRegister(int output_id) {
    check::integer("output_id", output_id, 0, tiller::rtde::kRegisterCount - 1);
    return d_->registerValue(tiller::rtde::doubleRegisterName(Direction::Output, output_id));
}

double RTDEReceiveInterface::getSpeedScalingCombined() {
    return d_->speed();
}

}  // namespace ur_rtde
