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
constexpr double kFurthest = 1;    // between two time stamps [s]
constexpr int kLongerForGood = 5;  // so many late packages in a row: the path has become a longer one

// What is worked on follows the estimates by this part of a period for each package, so that one that is late
// does not make a cycle longer; by that part of the way when there is far to go.
constexpr double kSmallestStep = 0.001;
constexpr double kPartOfWay = 0.125;

void track(double& quantile, double value, double part, double step) {
    quantile += value > quantile ? part * step : (part - 1) * step;
}

}  // namespace

ArrivalPace::ArrivalPace(double period) : periodNs_(period * 1e9), mostNs_(periodNs_ / 4) {}

std::int64_t ArrivalPace::follow(std::int64_t arrivedNs, double senderTime) {
    const double delay = static_cast<double>(arrivedNs) - senderTime * 1e9;
    const double step = senderTime - senderTime_;
    if (packages_ == 0 || !(step > 0 && step < kFurthest)) {
        begin(delay);
    }
    senderTime_ = senderTime;
    ++packages_;
    learn(delay - origin_);
    hold();
    return std::clamp(expectedNs(senderTime), arrivedNs,
                      arrivedNs + static_cast<std::int64_t>(periodNs_ / 2));
}

std::int64_t ArrivalPace::expectedNs(double senderTime) const {
    return std::llround(senderTime * 1e9 + origin_ + heldNs_);
}

void ArrivalPace::begin(double delay) {
    packages_ = 0;
    origin_ = delay;
    usualNs_ = 0;
    marginNs_ = 0;
    lateInARow_ = 0;
}

void ArrivalPace::learn(double late) {
    // Nothing arrives before it is sent: what comes this early shows that those before it were late.
    if (late < usualNs_ - mostNs_) {
        usualNs_ = late;
    }
    track(usualNs_, late, kMedian, periodNs_ * std::max(kFirstStep / packages_, kUsualStep));
    const double more = late - usualNs_;
    if (more > mostNs_) {
        // No margin would help: it says nothing about what all others need.
        // After a stall each comes a period less late than the one before; on a longer path all come alike.
        const bool first = lateInARow_ == 0 || more < leastLateNs_ - mostNs_;
        lateInARow_ = first ? 1 : lateInARow_ + 1;
        leastLateNs_ = first ? more : std::min(leastLateNs_, more);
        if (lateInARow_ >= kLongerForGood) {
            usualNs_ += leastLateNs_;
            lateInARow_ = 0;
        }
        return;
    }
    lateInARow_ = 0;
    if (isSettled()) {
        track(marginNs_, more, kNearlyAll, periodNs_ * kMarginStep);
    } else if (packages_ > kFirstPackages) {
        marginNs_ = std::max(marginNs_, more);
    }
    marginNs_ = std::clamp(marginNs_, 0.0, mostNs_);
}

void ArrivalPace::hold() {
    const double wanted = usualNs_ + marginNs_ + periodNs_ * kGrace;
    const double off = wanted - heldNs_;
    const double most = std::max(periodNs_ * kSmallestStep, std::abs(off) * kPartOfWay);
    heldNs_ = isSettled() && std::abs(off) < mostNs_ ? heldNs_ + std::clamp(off, -most, most) : wanted;
}

}  // namespace tiller::realtime
