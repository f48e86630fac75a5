// SPDX-License-Identifier: MIT
#pragma once

// Automatic functions of the terminals: outputs that follow the program state, and inputs used as a freedrive
// button. Programs set these functions, which remain set until changed. Source: URScript set_runstate_* and
// set_*_input_action.

#include <array>
#include <bitset>
#include <cstddef>

#include "robot/simulator/plant/pins.h"
#include "robot/simulator/plant/registers.h"

namespace tiller::simulator {

/// Automatic function of an output, with the numbers of the script function.
enum class RunState { Keep, LowWhenStopped, HighWhenStopped, HighWhileRunning };

class TerminalRules {
public:
    std::array<RunState, kDigitalPins> digitalOutputs{};
    std::array<RunState, 2> analogOutputs{};
    std::array<RunState, 128> outputRegisters{};
    std::bitset<kDigitalPins> freedriveInputs;
    std::bitset<128> freedriveRegisters;

    void programChanged(bool running, Pins& pins, Registers& registers) const {
        for (std::size_t i = 0; i < digitalOutputs.size(); ++i) {
            apply(digitalOutputs[i], running,
                  [&](bool high) { Pins::setBit(pins.digitalOutputs, static_cast<int>(i), high); });
        }
        for (std::size_t i = 0; i < analogOutputs.size(); ++i) {
            apply(analogOutputs[i], running, [&](bool high) { pins.setAnalogOutput(i, high ? 1 : 0); });
        }
        for (std::size_t i = 0; i < outputRegisters.size(); ++i) {
            apply(outputRegisters[i], running, [&](bool high) { registers.output.bits[i] = high; });
        }
    }
    /// True if any input that acts as a freedrive button is high.
    bool freedriveWanted(const Pins& pins, const Registers& registers) const {
        if ((freedriveInputs & std::bitset<kDigitalPins>(pins.digitalInputs)).any()) {
            return true;
        }
        for (std::size_t i = 0; freedriveRegisters.any() && i < freedriveRegisters.size(); ++i) {
            if (freedriveRegisters[i] && registers.input.bits[i]) {
                return true;
            }
        }
        return false;
    }

private:
    template <class Set>
    static void apply(RunState rule, bool running, Set set) {
        if (rule == RunState::HighWhileRunning) {
            set(running);
        } else if (!running && rule != RunState::Keep) {
            set(rule == RunState::HighWhenStopped);
        }
    }
};

}  // namespace tiller::simulator
