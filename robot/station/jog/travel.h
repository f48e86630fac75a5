// SPDX-License-Identifier: MIT
#pragma once

// How far a jog in each direction of the pad goes before it ends by itself, and which key leads out of a limit.

#include <QString>
#include <optional>

#include "robot/collision/collision_check.h"
#include "robot/control/jog_reach.h"
#include "robot/station/link/session_state.h"

namespace tiller {

/// A jog is not followed further than this.
inline constexpr double kTravelSeen = 1.0;       ///< [m]
inline constexpr double kTurnSeen = 3.14159265;  ///< [rad]

/// Of a key of the pad, from where the arm is.
/// direction  unit twist in the base frame, as control::jogReach
/// Threads    any. A millisecond
control::JogReach travelLeft(const SessionState& state, const Vector6& direction);

/// The arm's bodies that are nearest to each other or to the cell, measured against the distance that they keep.
struct NearestBodies {
    collision::CollisionCheck::Pair pair;
    double distance = 0;  ///< [m]
};
/// Nothing when no two are nearer than the safety distance and `beyond` [m].
std::optional<NearestBodies> nearestBodies(const SessionState& state, double beyond);

// Which of the twelve keys (X-, X+, Y-, Y+, ... Rz-, Rz+) leads out of a limit fastest, with room left to go; -1 for
// none.
// R_base_frame  the axes they move in

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
