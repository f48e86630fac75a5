// SPDX-License-Identifier: MIT
#include "robot/simulator/host/script_modbus.h"

namespace tiller::simulator {

Result<void> ScriptModbus::addModbusSignal(const urscript::ModbusSignal& signal) {
    return modbus_.add(signal);
}
Result<void> ScriptModbus::deleteModbusSignal(std::string_view name) {
    modbus_.remove(name);
    return {};
}
Result<urscript::ModbusStatus> ScriptModbus::modbusStatus(std::string_view name) const {
    return modbus_.status(name);
}
Result<std::int32_t> ScriptModbus::modbusError(std::string_view name,
                                               urscript::ModbusErrorSource source) const {
    return modbus_.error(name, source);
}
Result<double> ScriptModbus::modbusInvalidTime(std::string_view name) const {
    return modbus_.invalidTime(name);
}
Result<void> ScriptModbus::setModbusOutput(std::string_view name, bool digital,
                                           std::span<const std::int32_t> values) {
    return modbus_.setOutput(name, digital, values);
}
Result<void> ScriptModbus::setModbusFrequency(std::string_view name, double hertz) {
    return modbus_.setFrequency(name, hertz);
}
Result<void> ScriptModbus::setModbusWatchdog(std::string_view name, double seconds) {
    return modbus_.setWatchdog(name, seconds);
}
Result<void> ScriptModbus::setModbusFreedrive(std::string_view name, bool freedrive) {
    return modbus_.setFreedrive(name, freedrive);
}
Result<void> ScriptModbus::setModbusRunState(std::string_view name, int state) {
    return modbus_.setRunState(name, static_cast<RunState>(state));
}
Result<void> ScriptModbus::sendModbusCommand(int function, std::span<const std::uint8_t> data) {
    modbus_.command(function, data);
    return {};
}
bool ScriptModbus::isModbusConnected() const {
    return modbus_.isConnected();
}

}  // namespace tiller::simulator
