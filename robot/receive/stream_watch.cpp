// SPDX-License-Identifier: MIT
#include "robot/receive/stream_watch.h"

#include <algorithm>
#include <cmath>

namespace tiller::receive {

namespace {

// The two clocks may drift apart by this much without it being taken for lateness.
constexpr double kDrift = 500e-6;
// A jump of the time stamps beyond this is a controller that was started anew, not a gap.
constexpr double kLongestGap = 3600;

}  // namespace

void StreamWatch::begin(double period) {
    period_ = period > 0 ? period : 0.002;
    hasBase_ = false;
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
    verdict.jitterNs = std::llround(offset - baseNs_);
    verdict.late = offset - baseNs_ > period_ * 0.5e9;
    lastTimestamp_ = timestamp;
    hasTimestamp_ = true;
    return verdict;
}

}  // namespace tiller::receive
