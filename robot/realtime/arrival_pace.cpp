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
constexpr double kLessStep = 0.0025;
constexpr double kHighestNs = 500'000;  // margin, and a quarter of a period at most
constexpr double kGrace = 0.1;          // of the highest, beyond the margin: for those that are just late
constexpr double kFirstPackages = 50;   // until the median is good enough to judge by
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

ArrivalPace::ArrivalPace(double period)
    : periodNs_(period * 1e9), mostNs_(std::min(periodNs_ / 4, kHighestNs)) {}

std::int64_t ArrivalPace::follow(std::int64_t arrivedNs, double senderTime, bool awaited) {
    const double delay = static_cast<double>(arrivedNs) - senderTime * 1e9;
    const double step = senderTime - senderTime_;
    if (packages_ == 0 || !(step >= 0 && step < kFurthest)) {
        begin(delay);
    }
    senderTime_ = senderTime;
    const double late = delay - origin_;
    if (awaited || packages_ == 0) {
        ++packages_;
        learn(late);
    } else {
        holdLess(late);
    }
    hold();
    if (!awaited && marginNs_ <= 0) {
        return arrivedNs;
    }
    return std::clamp(expectedNs(senderTime), arrivedNs, arrivedNs + static_cast<std::int64_t>(2 * mostNs_));
}

std::int64_t ArrivalPace::expectedNs(double senderTime) const {
    return std::llround(senderTime * 1e9 + origin_ + heldNs_);
}

void ArrivalPace::begin(double delay) {
    packages_ = 0;
    origin_ = delay;
    usualNs_ = 0;
    marginNs_ = 0;
    latestNs_ = 0;
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
    learnMargin(more);
}

void ArrivalPace::learnMargin(double more) {
    if (isSettled()) {
        track(marginNs_, more, kNearlyAll, periodNs_ * kMarginStep);
    } else if (packages_ > kFirstPackages) {
        // The second latest: a single one would be held against all others for a minute.
        marginNs_ = std::max(marginNs_, std::min(more, latestNs_));
        latestNs_ = std::max(latestNs_, more);
    }
    marginNs_ = std::clamp(marginNs_, 0.0, mostNs_);
}

// Who works on packages takes so long that the next one is there before he looks: the delay is his own, and
// there is less time to hold them back.
void ArrivalPace::holdLess(double late) {
    const double less = periodNs_ * kLessStep;
    if (late - usualNs_ < 2 * mostNs_) {
        marginNs_ = std::max(marginNs_ - less, 0.0);
    }
    if (late < usualNs_) {
        usualNs_ -= less;  // it came even before that
    }
}

void ArrivalPace::hold() {
    const double wanted = usualNs_ + marginNs_ + mostNs_ * kGrace;
    const double off = wanted - heldNs_;
    const double most = std::max(periodNs_ * kSmallestStep, std::abs(off) * kPartOfWay);
    heldNs_ = isSettled() && std::abs(off) < mostNs_ ? heldNs_ + std::clamp(off, -most, most) : wanted;
}

}  // namespace tiller::realtime
