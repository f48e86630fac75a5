// SPDX-License-Identifier: MIT
#pragma once

// Remaining travel of a jog in each direction of the jog pad, and the button that moves the arm away from a
// limit.

#include <QString>
#include <optional>

#include "robot/collision/collision_check.h"
#include "robot/control/jog_reach.h"
#include "robot/station/link/session_state.h"

namespace tiller {

/// Maximum distance for which a jog is evaluated.
inline constexpr double kTravelSeen = 1.0;       ///< [m]
inline constexpr double kTurnSeen = 3.14159265;  ///< [rad]

/// Remaining travel of a jog pad button from the current arm position.
/// direction  unit twist in the base frame, as for control::jogReach()
/// Threads    any. Takes about a millisecond
control::JogReach travelLeft(const SessionState& state, const Vector6& direction);

/// The pair of bodies that is closest relative to its safety distance.
struct NearestBodies {
    collision::CollisionCheck::Pair pair;
    double distance = 0;  ///< [m]
};
/// Returns nothing if no pair is closer than its safety distance plus `beyond` [m].
std::optional<NearestBodies> nearestBodies(const SessionState& state, double beyond);

// These functions return one of the twelve buttons (X-, X+, Y-, Y+, ... Rz-, Rz+), or -1. It is the button
// that moves the arm away from a limit fastest and has sufficient remaining travel.
// R_base_frame  axes of the buttons

/// Moves this joint away from its limit.
int escapeKey(const SessionState& state, const Eigen::Matrix3d& R_base_frame, int joint);
enum class Singularity { Wrist, Elbow, Shoulder };
/// Moves the arm away from a singularity.
int escapeKeyFrom(const SessionState& state, const Eigen::Matrix3d& R_base_frame, Singularity singularity);
/// Separates this pair of bodies.
int escapeKeyFrom(const SessionState& state, const Eigen::Matrix3d& R_base_frame,
                  const collision::CollisionCheck::Pair& pair);
/// Label of a button by its number, e.g. "Z−".
QString travelKeyName(int key);

}  // namespace tiller
