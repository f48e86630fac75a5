// SPDX-License-Identifier: MIT
#include "robot/realtime/arrival_pace.h"

#include <algorithm>
#include <cmath>

namespace tiller::realtime {

namespace {

// Both estimates are quantiles followed step by step: up by `part` of a step when a value lies above, down by
// the rest when below. Steps are parts of a period. The median's first ones are long, the later ones as short
// as the clocks' drift allows: half of 500 ppm either way.
constexpr double kFirstStep = 0.1;
constexpr double kUsualStep = 0.0005;
constexpr double kMarginStep = 0.01;
constexpr double kGrace = 0.025;       // beyond the margin, for those that are just late
constexpr double kFirstPackages = 50;  // until the median is good enough to judge by
constexpr double kMedian = 0.5;
constexpr double kNearlyAll = 0.999;

void follow(double& quantile, double value, double part, double step) {
    quantile += value > quantile ? part * step : (part - 1) * step;
}

}  // namespace

ArrivalPace::ArrivalPace(double period) : periodNs_(period * 1e9), mostNs_(periodNs_ / 4) {}

std::int64_t ArrivalPace::due(std::int64_t arrivedNs, double senderTime) {
    const double delay = static_cast<double>(arrivedNs) - senderTime * 1e9;
    if (packages_ == 0) {
        origin_ = delay;
    }
    ++packages_;
    const double late = delay - origin_;
    // Nothing arrives before it is sent: what comes this early shows that those before it were late.
    if (late < usualNs_ - mostNs_) {
        usualNs_ = late;
    }
    follow(usualNs_, late, kMedian, periodNs_ * std::max(kFirstStep / packages_, kUsualStep));
    const double more = late - usualNs_;
    if (more > mostNs_) {
        // No margin would help: it says nothing about what all others need.
    } else if (isSettled()) {
        follow(marginNs_, more, kNearlyAll, periodNs_ * kMarginStep);
    } else if (packages_ > kFirstPackages) {
        marginNs_ = std::max(marginNs_, more);
    }
    marginNs_ = std::clamp(marginNs_, 0.0, mostNs_);
    return std::clamp(expectedNs(senderTime), arrivedNs,
                      arrivedNs + static_cast<std::int64_t>(periodNs_ / 2));
}

std::int64_t ArrivalPace::expectedNs(double senderTime) const {
    return std::llround(senderTime * 1e9 + origin_ + usualNs_ + marginNs_ + periodNs_ * kGrace);
}

}  // namespace tiller::realtime
