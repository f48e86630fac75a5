// SPDX-License-Identifier: MIT
#pragma once

// The speed at which a motion keeps both TCP and elbow below a speed limit, evaluated along the whole path, and the
// duration of such a motion.

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

/// For a joint move.
/// cap      of TCP and elbow [m/s]
/// Returns  the speed of the joint with the largest rotation [rad/s]; infinity if there is no motion
/// Threads  any. Real-time: no (some ten microseconds)
SpeedBound jointSpeedBound(const DhParameters& dh, const JointPositions& from, const JointPositions& to,
                           const Pose& tcpOffset, double cap);

/// A pure rotation is treated as a path with this radius: the speed of such a move is this radius times the angular
/// speed [m]. Source: eq_radius of the controller's configuration data.
inline constexpr double kTurnRadius = 0.25;

/// For a straight line of the TCP with synchronous rotation.
/// rotationCap  of the TCP [rad/s]
/// Returns      the speed of the TCP along the line [m/s]; infinity if there is no motion. If the line leaves the
///              workspace, the rest is ignored: the controller stops there.
/// Threads      any. Real-time: no (some hundred microseconds)
SpeedBound lineSpeedBound(const DhParameters& dh, const JointPositions& from, const Pose& to,
                          const Pose& tcpOffset, double cap, double rotationCap);

/// Path length used for the duration of such a line: the rotation counts if it takes longer than the translation.
double lineLength(const Pose& from, const Pose& to);

/// Duration of a move over `distance` with a trapezoidal speed profile [s]; 0 if speed or acceleration is 0. All
/// three in m or all three in rad.
double moveDuration(double distance, double speed, double acceleration);

}  // namespace tiller::kinematics
