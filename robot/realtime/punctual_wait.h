// SPDX-License-Identifier: MIT
#pragma once

// A wait that ends on time. A sleeping thread wakes up late by an amount that depends on the machine; a
// busy-waiting thread occupies a whole CPU. This class sleeps until shortly before the deadline, based on the
// measured wake-up delays, and busy-waits for the remaining time.

#include <cstdint>
#include <thread>

#include "robot/core/clock.h"

namespace tiller::realtime {

/// Threads  one. Real-time: yes (one system call per wait, no allocation, no lock)
class PunctualWait {
public:
    /// Maximum duration of the busy-wait [ns].
    static constexpr std::int64_t kMaxAwakeNs = 300'000;

    /// maySpin  false: only sleep. On a single CPU, a busy-wait would block the thread that produces the
    ///          event.
    explicit PunctualWait(bool maySpin = std::thread::hardware_concurrency() > 1) : maySpin_(maySpin) {}

    /// Returns when the clock reaches `ns`, or immediately if this time has passed or Clock::runsByItself()
    /// is false.
    void until(const Clock& clock, std::int64_t ns);

    /// Duration of the next busy-wait [ns]: an estimate of the 99th percentile of the recent wake-up delays,
    /// or 0 if more than half of the recent delays exceeded kMaxAwakeNs.
    std::int64_t awakeNs() const;
    /// Adds a measured wake-up delay [ns]. Called by until(); callers that sleep by other means can call it
    /// too.
    void learn(std::int64_t lateNs);
    /// Processor time spent in busy-waiting [ns].
    std::int64_t spentNs() const { return spentNs_; }

private:
    bool maySpin_;
    std::int64_t awakeNs_ = kWakeUpNs;
    int hopeless_ = 0;  ///< fraction of wake-ups later than kMaxAwakeNs, in 1/65536
    std::int64_t spentNs_ = 0;
};

}  // namespace tiller::realtime
