// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>

#include "robot/core/clock.h"

namespace tiller::test {

/// Forwards to another clock, and counts how often the time is read.
/// Threads  any
class AskedClock final : public Clock {
public:
    explicit AskedClock(const Clock& clock) : clock_(clock) {}
    std::int64_t nowNs() const override {
        const std::int64_t now = clock_.nowNs();
        asked_.fetch_add(1, std::memory_order_acq_rel);
        return now;
    }
    bool runsByItself() const override { return clock_.runsByItself(); }
    void waitUntil(std::int64_t ns, std::int64_t awakeNs) const override { clock_.waitUntil(ns, awakeNs); }
    std::uint64_t asked() const { return asked_.load(std::memory_order_acquire); }

private:
    const Clock& clock_;
    mutable std::atomic<std::uint64_t> asked_{0};
};

}  // namespace tiller::test
