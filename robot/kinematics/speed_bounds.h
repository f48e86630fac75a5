// SPDX-License-Identifier: MIT
#pragma once

// How fast a bounded motion may go so that neither the TCP nor the elbow gets faster than a cap: looked up
// along the whole way, not only where the arm stands now. And how long such a motion then takes.

#include <cstdint>
#include <limits>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"

namespace tiller::kinematics {

enum class SpeedLimit : std::uint8_t { None, Tcp, Elbow, Rotation };

struct SpeedBound {
    double speed = std::numeric_limits<double>::infinity();
    SpeedLimit by = SpeedLimit::None;  ///< what would get too fast above it
};

/// For a joint move.
/// cap      of TCP and elbow [m/s]
/// Returns  the speed of the joint that turns most [rad/s]; infinity when nothing moves
/// Threads  any. Real-time: no (some ten microseconds)
SpeedBound jointSpeedBound(const DhParameters& dh, const JointPositions& from, const JointPositions& to,
                           const Pose& tcpOffset, double cap);

/// A turn on the spot counts as a path of this radius, so the speed of such a move is this times the speed of
/// the turn [m]. Source: eq_radius of the controller's configuration data.
inline constexpr double kTurnRadius = 0.25;

/// For a straight line of the TCP, orientation in step with it.
/// rotationCap  of the TCP [rad/s]
/// Returns      the speed of the TCP along the line [m/s]; infinity when nothing moves. Where the line leaves
///              the reach of the arm the rest is not looked at: the controller stops there.
/// Threads      any. Real-time: no (some hundred microseconds)
SpeedBound lineSpeedBound(const DhParameters& dh, const JointPositions& from, const Pose& to,
                          const Pose& tcpOffset, double cap, double rotationCap);

/// How long the way of such a line counts as [m]: a turn that takes longer than the way leads it.
double lineLength(const Pose& from, const Pose& to);

/// Time of a move over `distance` that speeds up, goes on and slows down [s]; 0 where there is no speed or
/// acceleration. All three in m or all three in rad.
double moveDuration(double distance, double speed, double acceleration);

}  // namespace tiller::kinematics
