// SPDX-License-Identifier: MIT
#include "robot/realtime/arrival_pace.h"

#include <algorithm>
#include <cmath>

namespace tiller::realtime {

namespace {

// The median and the margin are quantiles that are tracked incrementally: a value above the estimate raises
// it by `part` of a step, a value below lowers it by (1 - `part`) of a step. Step sizes are fractions of a
// period. The first steps of the median are large. Later steps follow a clock drift of up to 250 ppm in each
// direction.
constexpr double kFirstStep = 0.1;
constexpr double kUsualStep = 0.0005;
constexpr double kMarginStep = 0.01;
constexpr double kLessStep = 0.0025;
constexpr double kHighestNs = 500'000;  // upper limit of the margin, unless a quarter of a period is less
constexpr double kGrace = 0.1;          // tolerance added to the margin, as a fraction of the maximum margin
constexpr double kFirstPackages = 50;   // packets needed for an accurate median
constexpr double kMedian = 0.5;
constexpr double kNearlyAll = 0.999;
constexpr double kFurthest = 1;    // maximum difference between consecutive time stamps [s]
constexpr int kLongerForGood = 5;  // consecutive late packets that indicate a permanently longer delay

// With each packet, the processing time moves towards median plus margin by at most kSmallestStep of a
// period, so that a late packet does not extend a cycle. For large deviations, the limit is kCorrectionShare
// of the deviation.
constexpr double kSmallestStep = 0.001;
constexpr double kCorrectionShare = 0.125;

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
    // Packets cannot arrive before they are sent. A packet this early shows that the previous packets were
    // late.
    if (late < usualNs_ - mostNs_) {
        usualNs_ = late;
    }
    track(usualNs_, late, kMedian, periodNs_ * std::max(kFirstStep / packages_, kUsualStep));
    const double more = late - usualNs_;
    if (more > mostNs_) {
        // No margin can cover this delay, so it does not affect the margin. After a stall, each packet is one
        // period less late than the previous packet. If the network delay has increased, all packets are
        // equally late.
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
        // Use the second largest value, because a single outlier would delay all other packets for a minute.
        marginNs_ = std::max(marginNs_, std::min(more, latestNs_));
        latestNs_ = std::max(latestNs_, more);
    }
    marginNs_ = std::clamp(marginNs_, 0.0, mostNs_);
}

// Called for a packet that may have arrived before the thread waited for it, because processing the previous
// packet took too long. The consumer causes this delay, so packets are held back for a shorter time.
void ArrivalPace::holdLess(double late) {
    const double less = periodNs_ * kLessStep;
    if (late - usualNs_ < 2 * mostNs_) {
        marginNs_ = std::max(marginNs_ - less, 0.0);
    }
    if (late < usualNs_) {
        usualNs_ -= less;  // the actual arrival was even earlier
    }
}

void ArrivalPace::hold() {
    const double wanted = usualNs_ + marginNs_ + mostNs_ * kGrace;
    const double off = wanted - heldNs_;
    const double most = std::max(periodNs_ * kSmallestStep, std::abs(off) * kCorrectionShare);
    heldNs_ = isSettled() && std::abs(off) < mostNs_ ? heldNs_ + std::clamp(off, -most, most) : wanted;
}

}  // namespace tiller::realtime
