// SPDX-License-Identifier: MIT
#include "robot/station/link/hold_motion.h"

#include <algorithm>
#include <cmath>

namespace tiller {

std::int64_t HoldBounds::longestOf(double seconds) {
    constexpr double kSpare = 5;
    constexpr double kMax = 3600;  // limits the hold even if `seconds` is invalid
    const double sane = std::isfinite(seconds) ? std::clamp(seconds, 0.0, kMax) : 0.0;
    return static_cast<std::int64_t>((sane + kSpare) * kNsPerSecond);
}

std::int64_t HoldBounds::holdTimeoutAt(double linear, double angular) {
    double seconds = static_cast<double>(kMaxHoldTimeoutNs) / kNsPerSecond;
    if (linear > 0) {
        seconds = std::min(seconds, kUnconfirmedLength / linear);
    }
    if (angular > 0) {
        seconds = std::min(seconds, kUnconfirmedAngle / angular);
    }
    return std::max(kMinHoldTimeoutNs, static_cast<std::int64_t>(seconds * kNsPerSecond));
}

}  // namespace tiller
