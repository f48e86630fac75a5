// SPDX-License-Identifier: MIT
#pragma once

// A motion that runs only while an operator holds a key: its start, refresh, end and maximum duration.

#include <cstdint>
#include <functional>

#include "robot/control/motion_types.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"

namespace tiller {

/// How long one hold may last.
struct HoldBounds {
    static constexpr std::int64_t kMinSilenceNs = 100 * kNsPerMs;
    static constexpr std::int64_t kMaxSilenceNs = 2 * kNsPerSecond;
    /// How far the arm may move while a finger or stick that holds it reports no event.
    static constexpr double kSilentLength = 0.025;            ///< [m]
    static constexpr double kSilentAngle = 0.26179938779915;  ///< [rad] 15 deg

    /// Maximum duration of the motion [ns]; 0: no end of its own, HoldTerms::longestNs applies.
    std::int64_t longestNs = 0;
    /// How long a finger or a stick may report no event [ns].
    std::int64_t silenceNs = kMinSilenceNs;

    /// For a motion with an end: its duration plus 5 s.
    static std::int64_t longestOf(double seconds);
    /// The time in which the arm moves kSilentLength and kSilentAngle at most, between kMinSilenceNs and kMaxSilenceNs [ns].
    /// linear, angular  speeds [m/s, rad/s]; a speed of 0 does not count
    static std::int64_t silenceAt(double linear, double angular);
};

/// What a press on one key begins, keeps and ends: a single motion with its target, its reach and how it is let go.
/// It is made from MotionPort, which knows jogs, moves and freedrive but no key; what holds it (HoldGuard) knows no robot.
struct HoldMotion {
    using Id = std::uint64_t;
    /// Starts the motion or returns the reason of a refusal.
    std::function<Result<Id>()> begin;
    /// Keeps it alive. Returns false when it has been stopped or has arrived.
    std::function<bool(Id)> hold;
    std::function<void(Id, control::StopCause)> end;
    /// Queried at the press: true for a short limited step, which runs to its end after the key is released. All
    /// other rules still end it. May be empty: then releasing the key ends the motion.
    std::function<bool()> runsToEnd;
    /// Queried after the start: duration of the hold. May be empty: a motion without an end.
    std::function<HoldBounds()> bounds = {};
};

}  // namespace tiller
