// SPDX-License-Identifier: MIT
#pragma once

// Predicts the distance after which a Cartesian jog ends, by simulating it with the limiter that ends it, so that
// the distance displayed before a jog is the distance it achieves.

#include "robot/control/control_status.h"
#include "robot/core/robot_model.h"

namespace tiller::collision {
class CollisionCheck;
}

namespace tiller::control {

/// Joint limits of the model, for robots that do not report them.
JointLimits jointLimitsOf(const RobotModel& model);

/// The arm and the limits of the jog.
struct JogConditions {
    DhParameters dh;           ///< of the individual arm, if it reports a calibration
    JointLimits joints;        ///< joint limits
    MotionLimits limits = {};  ///< for the decelerations; speed limits do not end a jog
    const collision::CollisionCheck* check = nullptr;  ///< collision check; null: none
};

struct JogReach {
    double distance = 0;  ///< of the TCP [m], or its rotation [rad]
    Limiter end;          ///< the reason for the end; LimiterKind::None: no limit within `farthest`
};

/// Simulates a Cartesian jog from rest at q.
/// tcpOffset  flange to TCP [m, rad]
/// direction  in the base frame: a unit vector in one half (translation, or rotation about an axis through the
///            TCP), zeros in the other
/// farthest   maximum distance [m] or angle [rad]
/// Threads    any. Blocks: never. Real-time: no (a millisecond)
JogReach jogReach(const JogConditions& arm, const JointPositions& q, const Pose& tcpOffset,
                  const Vector6& direction, double farthest);

}  // namespace tiller::control
