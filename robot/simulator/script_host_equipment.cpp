// SPDX-License-Identifier: MIT
//
// The equipment part of ScriptHost: terminals with rules, Modbus map, values asked of people.

#include "robot/simulator/plant.h"
#include "robot/simulator/program_runner.h"
#include "robot/simulator/script_host.h"

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
    }
    if (const bool wanted = rules_.freedriveWanted(plant_.pins(), plant_.registers());
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
