// SPDX-License-Identifier: MIT
#pragma once

// The one place that sleeps for a period: absolute times, so that errors do not add up.

#include <chrono>
#include <cstdint>

#include "robot/realtime/punctual_wait.h"

namespace tiller::realtime {

/// Threads  one. Real-time: yes (one system call)
class PeriodicTimer {
public:
    /// punctual  stays awake for the last part of each wait, as PunctualWait does
    explicit PeriodicTimer(std::chrono::nanoseconds period, bool punctual = false);

    /// Sleeps until the next multiple of the period since construction (or restart()).
    /// Returns  how many multiples were already over when it was called: 0 when all is well. They are
    ///          skipped, not made up for.
    std::uint64_t wait();
    void restart();  ///< The next period begins now.
    /// How much later than due the last wait() returned [ns].
    std::int64_t latenessNs() const { return latenessNs_; }
    /// What staying awake has cost so far [ns of processor time].
    std::int64_t spentNs() const { return wait_.spentNs(); }
    /// As constructed.
    std::chrono::nanoseconds period() const { return std::chrono::nanoseconds(periodNs_); }

private:
    std::int64_t periodNs_;
    PunctualWait wait_;
    std::int64_t nextNs_ = 0;
    std::int64_t latenessNs_ = 0;
};

}  // namespace tiller::realtime
