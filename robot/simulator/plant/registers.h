// SPDX-License-Identifier: MIT
#pragma once

// General purpose registers and script flags. They keep their values when a program ends or a client
// disconnects. Source: RTDE guide; URScript read_/write_..._register.

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

namespace tiller::simulator {

struct RegisterBank {
    std::array<bool, 128> bits{};
    std::array<std::int32_t, 48> ints{};
    std::array<double, 48> doubles{};

    /// Packs 32 registers starting at `first`; `first` is bit 0.
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

/// Values that a program writes and overwrites within one period. RTDE runs in parallel with programs and
/// occasionally samples such a value. Example: a program of ur_rtde returns the result of
/// getActualToolFlangePose() in this way and repeats it every period until the client has read it.
class OverwrittenIntegers {
public:
    void beginPeriod() {
        for (std::size_t n = 0; n < periods_.size(); ++n) {
            periods_[n] = overwritten_[n] ? periods_[n] % kCaught + 1 : 0;
            overwritten_[n].reset();
        }
        written_.reset();
    }
    void write(std::size_t n, std::int32_t before) {
        if (written_[n] && !overwritten_[n]) {
            overwritten_[n] = before;
        }
        written_.set(n);
    }
    std::int32_t seen(std::size_t n, std::int32_t now) const {
        return periods_[n] == kCaught ? overwritten_[n].value_or(now) : now;
    }

private:
    static constexpr int kCaught = 125;  ///< consecutive occurrences per reported value
    std::bitset<48> written_;
    std::array<std::optional<std::int32_t>, 48> overwritten_{};
    std::array<int, 48> periods_{};
};

/// All values that programs write to one output integer register, including those overwritten within a
/// period.
struct WrittenIntegers {
    std::optional<std::size_t> number;  ///< register number; empty: no register is followed
    std::vector<std::int32_t> values;
};

struct Registers {
    RegisterBank input;   ///< written by RTDE clients
    RegisterBank output;  ///< written by scripts
    OverwrittenIntegers overwritten;
    WrittenIntegers followed;
    std::array<bool, 33> flags{};
};

}  // namespace tiller::simulator
