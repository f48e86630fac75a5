// SPDX-License-Identifier: MIT
#pragma once

// Predicts the distance after which a Cartesian jog ends. Simulates the jog with the limiter of the
// controller, so that the displayed distance matches the actual distance.

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
    DhParameters dh;           ///< parameters of the individual arm if it reports a calibration
    JointLimits joints;        ///< joint limits
    MotionLimits limits = {};  ///< only the decelerations are used; speed limits do not end a jog
    const collision::CollisionCheck* check = nullptr;  ///< null: no collision check
};

struct JogReach {
    double distance = 0;  ///< TCP travel until the end: translation [m] or rotation [rad]
    Limiter end;          ///< limit that ends the jog; LimiterKind::None: no limit within `farthest`
};

/// Simulates a Cartesian jog from rest at q.
/// tcpOffset  flange to TCP [m, rad]
/// direction  base frame: unit vector of a translation or of a rotation about an axis through the TCP; the
///            other part is zero
/// farthest   maximum distance [m] or angle [rad]
/// Threads    any. Blocks: never. Real-time: no (about 1 ms)
JogReach jogReach(const JogConditions& arm, const JointPositions& q, const Pose& tcpOffset,
                  const Vector6& direction, double farthest);

}  // namespace tiller::control
