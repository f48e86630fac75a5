// SPDX-License-Identifier: MIT
#pragma once

// Degrees are for people, for scripts and for files of others; inside, every angle is in radians.

#include <numbers>

namespace tiller {

/// Units    [rad] to [deg], also of speeds
/// Threads  any. Real-time: yes
constexpr double toDegrees(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

/// Units    [deg] to [rad], also of speeds
/// Threads  any. Real-time: yes
constexpr double toRadians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

}  // namespace tiller
