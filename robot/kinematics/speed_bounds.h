// SPDX-License-Identifier: MIT
#pragma once

// How fast a bounded motion may go so that neither the TCP nor the elbow gets faster than a cap: looked up
// along the whole way, not only where the arm stands now.

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"

namespace tiller::kinematics {

/// For a joint move.
/// cap      of TCP and elbow [m/s]
/// Returns  the speed of the joint that turns most [rad/s]; infinity when nothing moves
/// Threads  any. Real-time: no (some ten microseconds)
double jointSpeedBound(const DhParameters& dh, const JointPositions& from, const JointPositions& to,
                       const Pose& tcpOffset, double cap);

/// A turn on the spot counts as a path of this radius, so the speed of such a move is this times the speed of
/// the turn [m]. Source: eq_radius of the controller's configuration data.
inline constexpr double kTurnRadius = 0.25;

/// For a straight line of the TCP, orientation in step with it.
/// rotationCap  of the TCP [rad/s]
/// Returns      the speed of the TCP along the line [m/s]; infinity when nothing moves. Where the line leaves
/// the
///              reach of the arm the rest is not looked at: the controller stops there.
/// Threads      any. Real-time: no (some hundred microseconds)
double lineSpeedBound(const DhParameters& dh, const JointPositions& from, const Pose& to,
                      const Pose& tcpOffset, double cap, double rotationCap);

}  // namespace tiller::kinematics
