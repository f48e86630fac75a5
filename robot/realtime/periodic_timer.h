// SPDX-License-Identifier: MIT
#pragma once

// The one place that sleeps for a period: absolute times, so that errors do not add up.

#include <chrono>
#include <cstdint>

namespace tiller::realtime {

/// Threads  one. Real-time: yes (one system call)
class PeriodicTimer {
public:
    explicit PeriodicTimer(std::chrono::nanoseconds period);

    /// Sleeps until the next multiple of the period since construction (or restart()).
    /// Returns  how many multiples were already over when it was called: 0 when all is well. They are
    ///          skipped, not made up for.
    std::uint64_t wait();
    void restart();  ///< The next period begins now.
    /// How much later than due the last wait() returned [ns].
    std::int64_t latenessNs() const { return latenessNs_; }
    /// As constructed.
    std::chrono::nanoseconds period() const { return std::chrono::nanoseconds(periodNs_); }

private:
    std::int64_t periodNs_;
    std::int64_t nextNs_ = 0;
    std::int64_t latenessNs_ = 0;
};

}  // namespace tiller::realtime
