// SPDX-License-Identifier: MIT
#pragma once

// Predicts the distance after which a Cartesian jog ends. The jog is simulated with the limiter of the
// controller, so the distance displayed before a jog matches the actual one.

#include "robot/control/control_status.h"
#include "robot/core/robot_model.h"

namespace tiller::collision {
class CollisionCheck;
}

namespace tiller::control {

/// Joint limits of the model, for robots that do not report their limits.
JointLimits jointLimitsOf(const RobotModel& model);

/// The arm and the limits of the jog.
struct JogConditions {
    DhParameters dh;           ///< parameters of the individual arm if it reports a calibration
    JointLimits joints;        ///< joint limits
    MotionLimits limits = {};  ///< only the decelerations are used; speed limits do not end a jog
    const collision::CollisionCheck* check = nullptr;  ///< null: no collision check
};

struct JogReach {
    double distance = 0;  ///< of the TCP: translation [m] or rotation [rad]
    Limiter end;          ///< why the jog ends; LimiterKind::None: no limit within `farthest`
};

/// Simulates a Cartesian jog from rest at q.
/// tcpOffset  flange to TCP [m, rad]
/// direction  in the base frame: a unit vector for either translation or rotation about an axis through the
///            TCP, zeros for the other one
/// farthest   maximum distance [m] or angle [rad]
/// Threads    any. Blocks: never. Real-time: no (a millisecond)
JogReach jogReach(const JogConditions& arm, const JointPositions& q, const Pose& tcpOffset,
                  const Vector6& direction, double farthest);

}  // namespace tiller::control
