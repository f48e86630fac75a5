// SPDX-License-Identifier: MIT
#pragma once

// The UTC time of packets and notes of a file. The system clock may be set while the file is being written.
// The times of packets and notes then still refer to the setting of the clock at the start of the file.

#include <chrono>
#include <cstdint>

#include "robot/core/clock.h"

namespace tiller::recording {

class PacketClock {
public:
    using Now = std::int64_t (*)();

    /// system  the system clock [ns since 1970, UTC]
    explicit PacketClock(Now system = systemUtcNs)
        : system_(system), offset_(system() - SteadyClock::shared().nowNs()) {}

    /// steadyNs  time of SteadyClock [ns]
    std::int64_t utcOf(std::int64_t steadyNs) const { return steadyNs + offset_; }
    /// utcNs  time of the system clock with its current setting [ns since 1970]
    std::int64_t utcOfNote(std::int64_t utcNs) const {
        constexpr std::int64_t kPrecision = 1'000'000;
        const std::int64_t set = system_() - utcOf(SteadyClock::shared().nowNs());
        return set > -kPrecision && set < kPrecision ? utcNs : utcNs - set;
    }

private:
    static std::int64_t systemUtcNs() {
        const auto utc = std::chrono::system_clock::now().time_since_epoch();
        return std::chrono::duration_cast<std::chrono::nanoseconds>(utc).count();
    }

    Now system_;
    std::int64_t offset_;  ///< [ns]
};

}  // namespace tiller::recording
