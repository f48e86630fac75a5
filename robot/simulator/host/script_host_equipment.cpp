// SPDX-License-Identifier: MIT
//
// The equipment part of ScriptHost: terminals with rules, Modbus map and devices, values asked of people.

#include "robot/simulator/box/plant.h"
#include "robot/simulator/host/script_host.h"
#include "robot/simulator/programs/program_runner.h"

namespace tiller::simulator {

namespace {

std::size_t at(int number) {
    return static_cast<std::size_t>(number);
}

}  // namespace

void ScriptHost::beginPeriod() {
    sockets_.service();
    plant_.registers().overwritten.beginPeriod();
    if (const bool running = plant_.programs().isActive(); running != wasRunning_) {
        wasRunning_ = running;
        rules_.programChanged(running, plant_.pins(), plant_.registers());
        modbus_.programChanged(running);
    }
    modbus_.step(plant_.stepTime());
    if (const bool wanted =
            rules_.freedriveWanted(plant_.pins(), plant_.registers()) || modbus_.freedriveWanted();
        wanted != freedriveWanted_) {
        freedriveWanted_ = wanted;
        plant_.setFreedriveButton(wanted);
    }
}

// ---- terminals ------------------------------------------------------------------------------------------

void ScriptHost::setRunState(urscript::RuledOutput output, int number, int state) {
    const auto rule = static_cast<RunState>(state);
    switch (output) {
        case urscript::RuledOutput::Standard:
            rules_.digitalOutputs[at(number)] = rule;
            break;
        case urscript::RuledOutput::Configurable:
            rules_.digitalOutputs[at(kConfigurablePin + number)] = rule;
            break;
        case urscript::RuledOutput::Tool:
            rules_.digitalOutputs[at(kToolPin + number)] = rule;
            break;
        case urscript::RuledOutput::Analog:
            rules_.analogOutputs[at(number)] = rule;
            break;
        case urscript::RuledOutput::Register:
            rules_.outputRegisters[at(number)] = rule;
            break;
    }
}

void ScriptHost::setFreedriveInput(urscript::RuledInput input, int number, bool freedrive) {
    switch (input) {
        case urscript::RuledInput::Standard:
            rules_.freedriveInputs[at(number)] = freedrive;
            break;
        case urscript::RuledInput::Configurable:
            rules_.freedriveInputs[at(kConfigurablePin + number)] = freedrive;
            break;
        case urscript::RuledInput::Tool:
            rules_.freedriveInputs[at(kToolPin + number)] = freedrive;
            break;
        case urscript::RuledInput::Register:
            rules_.freedriveRegisters[at(number)] = freedrive;
            break;
    }
}

void ScriptHost::resetInputActions() {
    rules_.freedriveInputs.reset();
    rules_.freedriveRegisters.reset();
}

// ---- Modbus map -----------------------------------------------------------------------------------------

bool ScriptHost::portBit(int address) const {
    return portBits_[at(address)];
}
void ScriptHost::setPortBit(int address, bool value) {
    portBits_[at(address)] = value;
}
std::int16_t ScriptHost::portRegister(int address) const {
    return portRegisters_[at(address)];
}
void ScriptHost::setPortRegister(int address, std::int16_t value) {
    portRegisters_[at(address)] = value;
}

// ---- Modbus devices -------------------------------------------------------------------------------------

Result<void> ScriptHost::addModbusSignal(const urscript::ModbusSignal& signal) {
    return modbus_.add(signal);
}
Result<void> ScriptHost::deleteModbusSignal(std::string_view name) {
    modbus_.remove(name);
    return {};
}
Result<urscript::ModbusStatus> ScriptHost::modbusStatus(std::string_view name) const {
    return modbus_.status(name);
}
Result<std::int32_t> ScriptHost::modbusError(std::string_view name,
                                             urscript::ModbusErrorSource source) const {
    return modbus_.error(name, source);
}
Result<double> ScriptHost::modbusInvalidTime(std::string_view name) const {
    return modbus_.invalidTime(name);
}
Result<void> ScriptHost::setModbusOutput(std::string_view name, bool digital,
                                         std::span<const std::int32_t> values) {
    return modbus_.setOutput(name, digital, values);
}
Result<void> ScriptHost::setModbusFrequency(std::string_view name, double hertz) {
    return modbus_.setFrequency(name, hertz);
}
Result<void> ScriptHost::setModbusWatchdog(std::string_view name, double seconds) {
    return modbus_.setWatchdog(name, seconds);
}
Result<void> ScriptHost::setModbusFreedrive(std::string_view name, bool freedrive) {
    return modbus_.setFreedrive(name, freedrive);
}
Result<void> ScriptHost::setModbusRunState(std::string_view name, int state) {
    return modbus_.setRunState(name, static_cast<RunState>(state));
}
Result<void> ScriptHost::sendModbusCommand(int function, std::span<const std::uint8_t> data) {
    modbus_.command(function, data);
    return {};
}
bool ScriptHost::isModbusConnected() const {
    return modbus_.isConnected();
}

// ---- values asked of people -----------------------------------------------------------------------------

Result<int> ScriptHost::requestValue(urscript::RequestKind kind, std::string_view text) {
    ++lastRequest_;
    requests_[lastRequest_] = {kind, std::nullopt};
    plant_.publish(primary::requestValue(plant_.timestampNs(), static_cast<std::uint32_t>(lastRequest_),
                                         static_cast<std::uint32_t>(kind), text));
    return lastRequest_;
}

std::optional<urscript::RequestAnswer> ScriptHost::requestedValue(int id) {
    const auto it = requests_.find(id);
    if (it == requests_.end() || !it->second.answer) {
        return std::nullopt;
    }
    auto answer = std::move(it->second.answer);
    requests_.erase(it);
    return answer;
}

std::optional<urscript::RequestKind> ScriptHost::asked() const {
    for (const auto& [id, request] : requests_) {
        if (!request.answer) {
            return request.kind;
        }
    }
    return std::nullopt;
}

bool ScriptHost::answerRequest(const urscript::RequestAnswer& answer) {
    // The oldest that still waits, and only with a value of its type: index and kind count alike.
    for (auto& [id, request] : requests_) {
        if (!request.answer) {
            if (answer.index() != static_cast<std::size_t>(request.kind)) {
                return false;
            }
            request.answer = answer;
            return true;
        }
    }
    return false;
}

}  // namespace tiller::simulator
