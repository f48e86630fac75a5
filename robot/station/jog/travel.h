// SPDX-License-Identifier: MIT
#pragma once

// Remaining travel of a jog in each direction of the pad, and the key that leads out of a limit.

#include <QString>
#include <optional>

#include "robot/collision/collision_check.h"
#include "robot/control/jog_reach.h"
#include "robot/station/link/session_state.h"

namespace tiller {

/// A jog is not followed further than this.
inline constexpr double kTravelSeen = 1.0;       ///< [m]
inline constexpr double kTurnSeen = 3.14159265;  ///< [rad]

/// Remaining travel of a key of the pad from the position of the arm.
/// direction  unit twist in the base frame, as control::jogReach
/// Threads    any. Takes about a millisecond
control::JogReach travelLeft(const SessionState& state, const Vector6& direction);

/// The arm's bodies that are nearest to each other or to the cell, measured against the distance that they keep.
struct NearestBodies {
    collision::CollisionCheck::Pair pair;
    double distance = 0;  ///< [m]
};
/// Nothing when no two are nearer than the safety distance and `beyond` [m].
std::optional<NearestBodies> nearestBodies(const SessionState& state, double beyond);

// The one of the twelve keys (X-, X+, Y-, Y+, ... Rz-, Rz+) that leads out of a limit fastest, with remaining
// travel; -1 if none.
// R_base_frame  the axes of the keys

/// Takes this joint away from its limit.
int wayOut(const SessionState& state, const Eigen::Matrix3d& R_base_frame, int joint);
/// Leads out of a singularity.
enum class Singularity { Wrist, Elbow, Shoulder };
int wayOutOf(const SessionState& state, const Eigen::Matrix3d& R_base_frame, Singularity singularity);
/// Takes these two apart.
int wayOutOf(const SessionState& state, const Eigen::Matrix3d& R_base_frame,
             const collision::CollisionCheck::Pair& pair);
/// "Z\u2212" for the number of a key.
QString travelKeyName(int key);

}  // namespace tiller
