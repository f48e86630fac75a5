// SPDX-License-Identifier: MIT
#pragma once

// Waits that end on time. A thread that sleeps wakes up late, by how much depends on the machine; one that never
// sleeps takes a whole CPU. This one sleeps until as long before its moment as nearly all wake-ups are late here, and
// stays awake for the rest.

#include <cstdint>
#include <thread>

#include "robot/core/clock.h"

namespace tiller::realtime {

/// Threads  one. Real-time: yes (one system call a wait, no allocation, no lock)
class PunctualWait {
public:
    /// It stays awake no longer than this before a moment [ns].
    static constexpr std::int64_t kMostAwakeNs = 300'000;

    /// maySpin  false: it only sleeps. On a single CPU whoever is waited for could not run meanwhile.
    explicit PunctualWait(bool maySpin = std::thread::hardware_concurrency() > 1) : maySpin_(maySpin) {}

    /// Returns at this moment [ns] of the clock, or at once where it is over or time does not run by itself.
    void until(const Clock& clock, std::int64_t ns);

    /// How long before its moment the next wait gets up [ns]: what 99 of 100 wake-ups are not later than, by those
    /// of the last seconds; 0 where even the longest would mostly be too short.
    std::int64_t awakeNs() const;
    /// One wake-up was so much late [ns]. until() calls it; so do those who sleep in their own way.
    void learn(std::int64_t lateNs);
    /// What staying awake has cost so far [ns of processor time].
    std::int64_t spentNs() const { return spentNs_; }

private:
    bool maySpin_;
    std::int64_t awakeNs_ = kWakeUpNs;
    int hopeless_ = 0;  ///< share of the wake-ups that were later than kMostAwakeNs, of 65536
    std::int64_t spentNs_ = 0;
};

}  // namespace tiller::realtime
