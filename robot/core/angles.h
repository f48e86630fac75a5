// SPDX-License-Identifier: MIT
#pragma once

// Conversion between degrees (user interface, scripts, external files) and radians (used for all internal
// angles).

#include <numbers>

namespace tiller {

/// Units    [rad] to [deg], also for velocities
/// Threads  any. Real-time: yes
constexpr double toDegrees(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

/// Units    [deg] to [rad], also for velocities
/// Threads  any. Real-time: yes
constexpr double toRadians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

}  // namespace tiller
