// SPDX-License-Identifier: MIT
#pragma once

// How far a jog of the TCP would go before it ends by itself: followed with the limiter that ends it, so that the
// distance shown before a jog is the distance that the jog makes.

#include "robot/control/control_status.h"
#include "robot/core/robot_model.h"

namespace tiller::collision {
class CollisionCheck;
}

namespace tiller::control {

/// What the joints of this model can, where the robot does not report it.
JointLimits jointLimitsOf(const RobotModel& model);

/// The arm that would jog.
struct JogConditions {
    DhParameters dh;                                   ///< its own, where it reports a calibration
    JointLimits joints;                                ///< its ranges
    MotionLimits limits = {};                          ///< its decelerations; caps on speed do not end a jog
    const collision::CollisionCheck* check = nullptr;  ///< what it keeps away from; null: nothing
};

struct JogReach {
    double distance = 0;  ///< of the TCP [m], or its turn [rad]
    Limiter end;          ///< what ends the jog; LimiterKind::None: nothing within the distance followed
};

/// A jog of the TCP from rest at q.
/// tcpOffset  flange to TCP [m, rad]
/// direction  in the base frame: a unit vector in one half (along, or about an axis through the TCP), zeros in the
///            other
/// farthest   where following it ends [m] or [rad]
/// Threads    any. Blocks: never. Real-time: no (a millisecond)
JogReach jogReach(const JogConditions& arm, const JointPositions& q, const Pose& tcpOffset,
                  const Vector6& direction, double farthest);

}  // namespace tiller::control
