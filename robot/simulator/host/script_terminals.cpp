// SPDX-License-Identifier: MIT
#include "robot/simulator/host/script_terminals.h"

#include "robot/simulator/plant/plant.h"

namespace tiller::simulator {

namespace {

std::size_t at(int number) {
    return static_cast<std::size_t>(number);
}

int pin(urscript::DigitalBank bank, int n) {
    switch (bank) {
        case urscript::DigitalBank::Standard:
            return n;
        case urscript::DigitalBank::Configurable:
            return kConfigurablePin + n;
        case urscript::DigitalBank::Tool:
            return kToolPin + n;
    }
    return n;
}

const RegisterBank& bank(const Plant& plant, urscript::RegisterSide side) {
    return side == urscript::RegisterSide::Input ? plant.registers().input : plant.registers().output;
}

}  // namespace

void ScriptTerminals::programChanged(bool running) {
    rules_.programChanged(running, plant_.pins(), plant_.registers());
}

bool ScriptTerminals::freedriveWanted() const {
    return rules_.freedriveWanted(plant_.pins(), plant_.registers());
}

// ---- registers ------------------------------------------------------------------------------------------

bool ScriptTerminals::boolRegister(urscript::RegisterSide side, int address) const {
    return bank(plant_, side).bits[at(address)];
}
std::int32_t ScriptTerminals::intRegister(urscript::RegisterSide side, int address) const {
    return bank(plant_, side).ints[at(address)];
}
double ScriptTerminals::floatRegister(urscript::RegisterSide side, int address) const {
    return bank(plant_, side).doubles[at(address)];
}
void ScriptTerminals::setBoolOutput(int address, bool value) {
    plant_.registers().output.bits[at(address)] = value;
}
void ScriptTerminals::setIntOutput(int address, std::int32_t value) {
    std::int32_t& number = plant_.registers().output.ints[at(address)];
    plant_.registers().overwritten.write(at(address), number);
    if (WrittenIntegers& followed = plant_.registers().followed; followed.number == at(address)) {
        followed.values.push_back(value);
    }
    number = value;
}
void ScriptTerminals::setFloatOutput(int address, double value) {
    plant_.registers().output.doubles[at(address)] = value;
}
bool ScriptTerminals::flag(int number) const {
    return plant_.registers().flags[at(number)];
}
void ScriptTerminals::setFlag(int number, bool value) {
    plant_.registers().flags[at(number)] = value;
}

// ---- Modbus map -----------------------------------------------------------------------------------------

bool ScriptTerminals::portBit(int address) const {
    return portBits_[at(address)];
}
void ScriptTerminals::setPortBit(int address, bool value) {
    portBits_[at(address)] = value;
}
std::int16_t ScriptTerminals::portRegister(int address) const {
    return portRegisters_[at(address)];
}
void ScriptTerminals::setPortRegister(int address, std::int16_t value) {
    portRegisters_[at(address)] = value;
}

// ---- pins -----------------------------------------------------------------------------------------------

bool ScriptTerminals::digitalInput(urscript::DigitalBank bank, int n) const {
    return Pins::bit(plant_.pins().digitalInputs, pin(bank, n));
}
bool ScriptTerminals::digitalOutput(urscript::DigitalBank bank, int n) const {
    return Pins::bit(plant_.pins().digitalOutputs, pin(bank, n));
}
void ScriptTerminals::setDigitalOutput(urscript::DigitalBank bank, int n, bool value) {
    Pins::setBit(plant_.pins().digitalOutputs, pin(bank, n), value);
}

double ScriptTerminals::analog(urscript::AnalogPort port, int n) const {
    const Pins& pins = plant_.pins();
    switch (port) {
        case urscript::AnalogPort::StandardInput:
            return pins.analogInputs[at(n)];
        case urscript::AnalogPort::StandardOutput:
            return pins.analogOutput(at(n));
        case urscript::AnalogPort::ToolInput:
            return pins.toolAnalogInputs[at(n)];
    }
    return 0;
}

void ScriptTerminals::setAnalogOutput(int n, double level) {
    plant_.pins().setAnalogOutput(at(n), level);
}

void ScriptTerminals::setAnalogDomain(urscript::AnalogPort port, int n, int domain) {
    Pins& pins = plant_.pins();
    const unsigned value = domain == 0 ? 0 : 1;
    switch (port) {
        case urscript::AnalogPort::StandardInput:
            pins.analogInputDomains[at(n)] = value;
            break;
        case urscript::AnalogPort::StandardOutput:
            pins.analogOutputDomains[at(n)] = value;
            break;
        case urscript::AnalogPort::ToolInput:
            pins.toolAnalogDomains[at(n)] = value;
            break;
    }
}

void ScriptTerminals::setToolVoltage(int volts) {
    plant_.pins().toolVoltage = volts;
}

void ScriptTerminals::setToolCommunication(const urscript::ToolCommunication& settings) {
    plant_.pins().toolCommunication = {settings.enabled,  settings.baudRate,    settings.parity,
                                       settings.stopBits, settings.rxIdleChars, settings.txIdleChars};
}

void ScriptTerminals::setToolOutputMode(int mode) {
    plant_.pins().toolOutputMode = mode;
}
void ScriptTerminals::setToolDigitalOutputMode(int n, int mode) {
    plant_.pins().toolDigitalOutputModes[at(n)] = mode;
}

// ---- rules ----------------------------------------------------------------------------------------------

void ScriptTerminals::setRunState(urscript::RuledOutput output, int number, int state) {
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

void ScriptTerminals::setFreedriveInput(urscript::RuledInput input, int number, bool freedrive) {
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

void ScriptTerminals::resetInputActions() {
    rules_.freedriveInputs.reset();
    rules_.freedriveRegisters.reset();
}

}  // namespace tiller::simulator
