// SPDX-License-Identifier: MIT
#pragma once

// General purpose registers and script flags. They keep their values between programs and clients.
// Source: RTDE guide; URScript read_/write_..._register.

#include <array>
#include <cstdint>

namespace tiller::simulator {

struct RegisterBank {
    std::array<bool, 128> bits{};
    std::array<std::int32_t, 48> ints{};
    std::array<double, 48> doubles{};

    /// 32 bits from `first` on, lowest in bit 0.
    std::uint32_t word(std::size_t first) const {
        std::uint32_t packed = 0;
        for (std::size_t i = 0; i < 32; ++i) {
            packed |= bits[first + i] ? 1U << i : 0U;
        }
        return packed;
    }
    void setWord(std::size_t first, std::uint32_t packed) {
        for (std::size_t i = 0; i < 32; ++i) {
            bits[first + i] = ((packed >> i) & 1U) != 0;
        }
    }
};

struct Registers {
    RegisterBank input;   ///< written by RTDE clients
    RegisterBank output;  ///< written by scripts
    std::array<bool, 33> flags{};
};

}  // namespace tiller::simulator
