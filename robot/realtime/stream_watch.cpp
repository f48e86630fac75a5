// SPDX-License-Identifier: MIT
#include "robot/realtime/stream_watch.h"

#include <algorithm>
#include <cmath>

#include "robot/core/clock.h"

namespace tiller::realtime {

namespace {

// Drift between the two clocks that does not count as delay.
constexpr double kDrift = 500e-6;
// A larger jump of the time stamps means that the controller was restarted.
constexpr double kMaxGap = 3600;
// If all packets arrive late for this long without a pause, the cause is not a backlog. Either the network
// delay has increased, or the robot's clock was stopped. The delay then becomes the new reference.
constexpr std::int64_t kSettlingNs = 1 * kNsPerSecond;
constexpr std::int64_t kPauseNs = 50 * kNsPerMs;

}  // namespace

void StreamWatch::begin(double period) {
    period_ = period > 0 ? period : 0.002;
    hasBase_ = false;
    settlingSinceNs_ = 0;
}

StreamWatch::Verdict StreamWatch::add(double timestamp, std::int64_t hostNs) {
    Verdict verdict;
    if (!std::isfinite(timestamp)) {
        return verdict;
    }
    const double step = timestamp - lastTimestamp_;
    const bool continues = hasTimestamp_ && step > 0 && step < kMaxGap;
    if (continues) {
        verdict.lost = static_cast<std::uint64_t>(std::max(std::llround(step / period_) - 1, 0LL));
    }
    const double offset = static_cast<double>(hostNs) - timestamp * 1e9;
    if (!hasBase_ || !continues) {
        baseNs_ = offset;
        hasBase_ = true;
    } else {
        baseNs_ = std::min(baseNs_ + step * kDrift * 1e9, offset);
    }
    if (!continues || settlingSinceNs_ == 0 || hostNs - lastHostNs_ > kPauseNs) {
        settlingSinceNs_ = hostNs;
        settledNs_ = offset;
    } else if (settledNs_ = std::min(settledNs_, offset); hostNs - settlingSinceNs_ >= kSettlingNs) {
        baseNs_ = std::max(baseNs_, settledNs_);
        settlingSinceNs_ = hostNs;
        settledNs_ = offset;
    }
    lastHostNs_ = hostNs;
    verdict.jitterNs = std::llround(offset - baseNs_);
    verdict.late = offset - baseNs_ > period_ * 0.5e9;
    lastTimestamp_ = timestamp;
    hasTimestamp_ = true;
    return verdict;
}

}  // namespace tiller::realtime
