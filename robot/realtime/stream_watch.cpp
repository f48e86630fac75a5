// SPDX-License-Identifier: MIT
#include "robot/realtime/stream_watch.h"

#include <algorithm>
#include <cmath>

#include "robot/core/clock.h"

namespace tiller::realtime {

namespace {

// The two clocks may drift apart by this much without it being taken for lateness.
constexpr double kDrift = 500e-6;
// A jump of the time stamps beyond this is a controller that was started anew, not a gap.
constexpr double kLongestGap = 3600;
// A stream that comes for so long without such a pause, and always late, is not a backlog being read off: the
// way from the robot has become longer, or its clock was held up. From then on that is its time.
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
    const bool continues = hasTimestamp_ && step > 0 && step < kLongestGap;
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
