// SPDX-License-Identifier: MIT
#pragma once

// A motion that runs only while an operator holds a button: start, refresh, end and maximum duration.

#include <cstdint>
#include <functional>

#include "robot/control/motion_types.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"

namespace tiller {

/// Time limits of one hold.
struct HoldBounds {
    static constexpr std::int64_t kMinHoldTimeoutNs = std::chrono::nanoseconds(control::kHoldTime).count();
    static constexpr std::int64_t kMaxHoldTimeoutNs = 2 * kNsPerSecond;
    /// A hold ends when the arm has moved by this distance or angle without an event from the touch contact
    /// or joystick that holds the button, but not before kMinHoldTimeoutNs.
    static constexpr double kUnconfirmedLength = 0.025;            ///< [m]
    static constexpr double kUnconfirmedAngle = 0.26179938779915;  ///< [rad] 15 deg

    /// Maximum duration of the motion [ns]. 0: HoldPolicy::longestNs applies.
    std::int64_t longestNs = 0;
    /// Maximum time without an event from the touch contact or joystick [ns].
    std::int64_t holdTimeoutNs = kMinHoldTimeoutNs;

    /// Maximum duration of a motion with a known duration: that duration plus 5 s.
    static std::int64_t longestOf(double seconds);
    /// Time after which the arm has moved by kUnconfirmedLength or kUnconfirmedAngle, whichever comes first,
    /// limited to kMinHoldTimeoutNs ... kMaxHoldTimeoutNs [ns].
    /// linear, angular  speeds [m/s, rad/s]; a speed of 0 is ignored
    static std::int64_t holdTimeoutAt(double linear, double angular);
};

/// The motion of one held button: start, refresh, end and limits. Created from MotionPort, which provides
/// jogs, moves and freedrive independently of buttons. HoldGuard monitors the button independently of the
/// robot.
struct HoldMotion {
    using Id = std::uint64_t;
    /// Starts the motion, or returns an error if it is refused.
    std::function<Result<Id>()> begin;
    /// Keeps the motion active. Returns false if the motion has been stopped or has reached its target.
    std::function<bool(Id)> hold;
    std::function<void(Id, control::StopCause)> end;
    /// Called when the button is pressed. Returns true for a short limited step, which continues to its end
    /// after the button is released. All other stop conditions still apply. Empty: releasing the button ends
    /// the motion.
    std::function<bool()> runsToEnd;
    /// Called after the start. Returns the limits of the hold. Empty: the motion does not set a duration
    /// limit.
    std::function<HoldBounds()> bounds = {};
    /// Called once near the end of the maximum duration. The motion then pauses as soon as possible, and
    /// hold() returns false when it has paused. Returns the maximum time until the pause [ns]; the hold is
    /// extended by this time if necessary. Empty: the motion ends at its maximum duration.
    std::function<std::int64_t()> pause = {};
};

}  // namespace tiller
