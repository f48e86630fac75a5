// SPDX-License-Identifier: MIT
#pragma once

// Computes the maximum speed at which the TCP and the elbow stay below a speed limit along the whole path,
// and the duration of moves.

#include <cstdint>
#include <limits>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"

namespace tiller::kinematics {

enum class SpeedLimit : std::uint8_t { None, Tcp, Elbow, Rotation };

struct SpeedBound {
    double speed = std::numeric_limits<double>::infinity();
    SpeedLimit by = SpeedLimit::None;  ///< the limit that is reached first
};

/// Speed bound of a joint move.
/// cap      speed limit of TCP and elbow [m/s]
/// Returns  the speed of the joint with the largest rotation [rad/s]; infinity if there is no motion
/// Threads  any. Real-time: no (about ten microseconds)
SpeedBound jointSpeedBound(const DhParameters& dh, const JointPositions& from, const JointPositions& to,
                           const Pose& tcpOffset, double cap);

/// Radius [m] of the path that represents a pure rotation: the speed of such a move is this radius times the
/// angular speed. Source: eq_radius of the controller's configuration data.
inline constexpr double kTurnRadius = 0.25;

/// Speed bound of a straight line of the TCP with synchronous rotation.
/// cap          speed limit of TCP and elbow [m/s]
/// rotationCap  speed limit of the TCP rotation [rad/s]
/// Returns      the speed of the TCP along the line [m/s]; infinity if there is no motion. The part of the
///              line outside the workspace is ignored, because the controller stops at the boundary.
/// Threads      any. Real-time: no (a few hundred microseconds)
SpeedBound lineSpeedBound(const DhParameters& dh, const JointPositions& from, const Pose& to,
                          const Pose& tcpOffset, double cap, double rotationCap);

/// Path length that determines the duration of a linear move. The rotation is used if it takes longer than
/// the translation.
double lineLength(const Pose& from, const Pose& to);

/// Duration of a move over `distance` with a trapezoidal speed profile [s]; 0 if speed or acceleration is 0.
/// All three parameters use the same base unit, m or rad.
double moveDuration(double distance, double speed, double acceleration);

}  // namespace tiller::kinematics
