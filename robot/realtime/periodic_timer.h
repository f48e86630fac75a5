// SPDX-License-Identifier: MIT
#pragma once

// Periodic sleep until absolute times, so that errors do not accumulate.

#include <chrono>
#include <cstdint>

#include "robot/realtime/punctual_wait.h"

namespace tiller::realtime {

/// Threads  one. Real-time: yes (one system call)
class PeriodicTimer {
public:
    /// punctual  true: busy-waits at the end of each period, like PunctualWait
    explicit PeriodicTimer(std::chrono::nanoseconds period, bool punctual = false);

    /// Sleeps until the next multiple of the period since construction or restart().
    /// Returns  the number of multiples that had already passed at the call; normally 0. They are skipped.
    std::uint64_t wait();
    void restart();  ///< Starts a new period at the time of the call.
    /// Delay of the last return from wait() [ns].
    std::int64_t latenessNs() const { return latenessNs_; }
    /// Processor time spent in busy-waiting [ns].
    std::int64_t spentNs() const { return wait_.spentNs(); }
    std::chrono::nanoseconds period() const { return std::chrono::nanoseconds(periodNs_); }

private:
    std::int64_t periodNs_;
    PunctualWait wait_;
    std::int64_t nextNs_ = 0;
    std::int64_t latenessNs_ = 0;
};

}  // namespace tiller::realtime
