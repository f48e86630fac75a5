// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator::urscript {

Error notSimulated(std::string_view what) {
    return scriptError(std::string(what) + " is not simulated");
}

Error scriptError(std::string text) {
    return {ErrorCode::ScriptError, QString(), QString::fromStdString(text)};
}

Result<void> MotionHost::screwDriving(double, double) {
    return notSimulated("screw_driving");
}
Result<void> MotionHost::endScrewDriving() {
    return {};
}
Result<void> MotionHost::setJointPositions(const JointPositions&) {
    return notSimulated("set_pos");
}
Result<void> MotionHost::resetRevolutionCounter(const JointPositions&) {
    return notSimulated("reset_revolution_counter");
}

Result<void> SuperpositionHost::enablePathOffset() {
    return notSimulated("path_offset_enable");
}
Result<void> SuperpositionHost::setPathOffset(const Pose&, int) {
    return notSimulated("path_offset_set");
}
Result<Pose> SuperpositionHost::pathOffset(int) const {
    return notSimulated("path_offset_get");
}
Result<void> SuperpositionHost::setPathOffsetFilter(double) {
    return notSimulated("path_offset_set_alpha_filter");
}
Result<void> SuperpositionHost::setPathOffsetLimits(double, double) {
    return notSimulated("path_offset_set_max_offset");
}
Result<void> SuperpositionHost::trackConveyorLinear(const Pose&, double, int) {
    return notSimulated("track_conveyor_linear");
}
Result<void> SuperpositionHost::trackConveyorCircular(const Pose&, double, bool, int) {
    return notSimulated("track_conveyor_circular");
}
Result<double> SuperpositionHost::encoderTicks(int) const {
    return notSimulated("conveyor encoder");
}
Result<void> SuperpositionHost::setEncoderTicks(int, double) {
    return notSimulated("conveyor encoder");
}
Result<void> SuperpositionHost::enableEncoder(int, int, int, int) {
    return notSimulated("conveyor encoder");
}
Result<void> SuperpositionHost::setEncoderRange(int, int) {
    return notSimulated("conveyor encoder");
}

Result<StateHost::FieldValue> StateHost::rtdeValue(std::string_view) const {
    return notSimulated("get_rtde_value");
}

Result<Matrix6> KinematicsHost::jacobian(const std::optional<JointPositions>&,
                                         const std::optional<Pose>&) const {
    return notSimulated("get_jacobian");
}
Result<Matrix6> KinematicsHost::jacobianTimeDerivative(const std::optional<JointPositions>&,
                                                       const std::optional<JointVelocities>&,
                                                       const std::optional<Pose>&) const {
    return notSimulated("get_jacobian_time_derivative");
}
Result<Matrix6> KinematicsHost::massMatrix(const std::optional<JointPositions>&, bool) const {
    return notSimulated("get_mass_matrix");
}
Result<JointTorques> KinematicsHost::coriolisTorques(const std::optional<JointPositions>&,
                                                     const std::optional<JointVelocities>&) const {
    return notSimulated("get_coriolis_and_centrifugal_torques");
}

Result<void> SetupHost::setBaseAcceleration(const Eigen::Vector3d&) {
    return notSimulated("set_base_acceleration");
}
Result<void> SetupHost::applySetting(std::string_view, std::span<const double>) {
    return {};
}

bool RegisterHost::portBit(int) const {
    return false;
}
void RegisterHost::setPortBit(int, bool) {}
std::int16_t RegisterHost::portRegister(int) const {
    return 0;
}
void RegisterHost::setPortRegister(int, std::int16_t) {}

Result<void> ModbusHost::addModbusSignal(const ModbusSignal&) {
    return notSimulated("A Modbus device");
}
Result<void> ModbusHost::deleteModbusSignal(std::string_view) {
    return notSimulated("A Modbus device");
}
Result<ModbusStatus> ModbusHost::modbusStatus(std::string_view) const {
    return notSimulated("A Modbus device");
}
Result<std::int32_t> ModbusHost::modbusError(std::string_view, ModbusErrorSource) const {
    return notSimulated("A Modbus device");
}
Result<double> ModbusHost::modbusInvalidTime(std::string_view) const {
    return notSimulated("A Modbus device");
}
Result<void> ModbusHost::setModbusOutput(std::string_view, bool, std::span<const std::int32_t>) {
    return notSimulated("A Modbus device");
}
Result<void> ModbusHost::setModbusFrequency(std::string_view, double) {
    return notSimulated("A Modbus device");
}
Result<void> ModbusHost::setModbusWatchdog(std::string_view, double) {
    return notSimulated("A Modbus device");
}
Result<void> ModbusHost::setModbusFreedrive(std::string_view, bool) {
    return notSimulated("A Modbus device");
}
Result<void> ModbusHost::setModbusRunState(std::string_view, int) {
    return notSimulated("A Modbus device");
}
Result<void> ModbusHost::sendModbusCommand(int, std::span<const std::uint8_t>) {
    return notSimulated("A Modbus device");
}

Result<int> MessageHost::requestValue(RequestedType, std::string_view) {
    return notSimulated("Requesting a value from a primary client");
}
std::optional<RequestAnswer> MessageHost::requestedValue(int) {
    return std::nullopt;
}

}  // namespace tiller::simulator::urscript
