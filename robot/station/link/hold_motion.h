// SPDX-License-Identifier: MIT
#pragma once

// A motion that runs only while an operator holds a key: its start, refresh, end and maximum duration.

#include <cstdint>
#include <functional>

#include "robot/control/motion_types.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"

namespace tiller {

/// Time limits of one hold.
struct HoldBounds {
    static constexpr std::int64_t kMinHoldTimeoutNs = 100 * kNsPerMs;
    static constexpr std::int64_t kMaxHoldTimeoutNs = 2 * kNsPerSecond;
    /// Maximum distance the arm may move while a finger or stick that holds it reports no event.
    static constexpr double kUnconfirmedLength = 0.025;            ///< [m]
    static constexpr double kUnconfirmedAngle = 0.26179938779915;  ///< [rad] 15 deg

    /// Maximum duration of the motion [ns]; 0: no own limit, HoldPolicy::longestNs applies.
    std::int64_t longestNs = 0;
    /// Maximum time without an event from a finger or a stick [ns].
    std::int64_t holdTimeoutNs = kMinHoldTimeoutNs;

    /// For a motion with a known duration: its duration plus 5 s.
    static std::int64_t longestOf(double seconds);
    /// The time in which the arm moves kUnconfirmedLength and kUnconfirmedAngle at most, limited to kMinHoldTimeoutNs ...
    /// kMaxHoldTimeoutNs [ns].
    /// linear, angular  speeds [m/s, rad/s]; a speed of 0 is ignored
    static std::int64_t holdTimeoutAt(double linear, double angular);
};

/// The motion of one held key: its start, refresh and end, and its limits. Created from MotionPort, which
/// knows jogs, moves and freedrive but no keys; HoldGuard, which monitors the key, knows no robot.
struct HoldMotion {
    using Id = std::uint64_t;
    /// Starts the motion or returns the reason of a refusal.
    std::function<Result<Id>()> begin;
    /// Keeps it alive. Returns false when it has been stopped or has arrived.
    std::function<bool(Id)> hold;
    std::function<void(Id, control::StopCause)> end;
    /// Queried at the press: true for a short limited step, which runs to its end after the key is released.
    /// All other stop conditions still apply. May be empty: then releasing the key ends the motion.
    std::function<bool()> runsToEnd;
    /// Queried after the start: limits of the hold. May be empty: no duration limit of the motion itself.
    std::function<HoldBounds()> bounds = {};
};

}  // namespace tiller
