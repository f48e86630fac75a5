// SPDX-License-Identifier: MIT
#pragma once

// The terminals of the control box and of the tool flange.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tiller::simulator {

inline constexpr int kDigitalPins = 18;  ///< 0-7 standard, 8-15 configurable, 16-17 tool
inline constexpr int kConfigurablePin = 8;
inline constexpr int kToolPin = 16;

struct Pins {
    std::uint64_t digitalInputs = 0;
    std::uint64_t digitalOutputs = 0;

    std::array<double, 2> analogInputs{};              ///< [A] or [V], depending on the domain
    std::array<unsigned, 2> analogInputDomains{1, 1};  ///< 0: 4-20 mA, 1: 0-10 V
    std::array<double, 2> analogOutputLevels{};        ///< 0..1 of the range
    std::array<unsigned, 2> analogOutputDomains{0, 0};
    std::array<double, 2> toolAnalogInputs{};
    std::array<unsigned, 2> toolAnalogDomains{1, 1};
    int toolVoltage = 0;                              ///< [V] 0, 12, 24
    int toolOutputMode = 0;                           ///< 0 digital outputs, 1 dual-pin power
    std::array<int, 2> toolDigitalOutputModes{1, 1};  ///< 1 NPN, 2 PNP, 3 push-pull

    struct ToolCommunication {
        bool enabled = false;
        int baudRate = 115200;
        int parity = 0;
        int stopBits = 1;
        double rxIdleChars = 1.5;
        double txIdleChars = 3.5;
    } toolCommunication;

    static bool bit(std::uint64_t word, int n) { return ((word >> n) & 1U) != 0; }
    static void setBit(std::uint64_t& word, int n, bool value) {
        const std::uint64_t mask = std::uint64_t{1} << n;
        word = value ? (word | mask) : (word & ~mask);
    }

    /// Level at the terminal: [A] in the current domain, [V] in the voltage domain.
    double analogOutput(std::size_t n) const {
        const double level = analogOutputLevels[n];
        return analogOutputDomains[n] == 0 ? 0.004 + 0.016 * level : 10.0 * level;
    }
    /// level  0..1 of the range; other values are clamped, NaN is ignored
    void setAnalogOutput(std::size_t n, double level) {
        if (!std::isnan(level)) {
            analogOutputLevels[n] = std::clamp(level, 0.0, 1.0);
        }
    }
};

}  // namespace tiller::simulator
