// SPDX-License-Identifier: MIT
#include "robot/realtime/periodic_timer.h"

#include <algorithm>

#include "robot/core/clock.h"

namespace tiller::realtime {

PeriodicTimer::PeriodicTimer(std::chrono::nanoseconds period, bool punctual)
    : periodNs_(std::max<std::int64_t>(period.count(), 1)), wait_(punctual && PunctualWait().awakeNs() > 0) {
    restart();
}

void PeriodicTimer::restart() {
    nextNs_ = SteadyClock::shared().nowNs() + periodNs_;
}

std::uint64_t PeriodicTimer::wait() {
    const std::int64_t now = SteadyClock::shared().nowNs();
    std::uint64_t missed = 0;
    if (now >= nextNs_) {
        missed = static_cast<std::uint64_t>((now - nextNs_) / periodNs_) + 1;
        nextNs_ += static_cast<std::int64_t>(missed) * periodNs_;
    }
    wait_.until(SteadyClock::shared(), nextNs_);
    latenessNs_ = SteadyClock::shared().nowNs() - nextNs_;
    nextNs_ += periodNs_;
    return missed;
}

}  // namespace tiller::realtime
