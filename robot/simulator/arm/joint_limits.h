// SPDX-License-Identifier: MIT
#pragma once

// What the joints may do, whatever is asked of them.

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"

namespace tiller::simulator::arm {

struct JointLimits {
    Vector6 speed = Vector6::Constant(3.14);           ///< [rad/s]
    double acceleration = kJointAccelerationLimit;     ///< [rad/s2]
    double position = kJointPositionLimit;             ///< [rad]

    /// Part of the acceleration that planned motion uses, so that corrections have the rest.
    double plannedAcceleration() const { return 0.9 * acceleration; }
    /// Deceleration with which a joint is kept from the end of its range.
    double brakingAcceleration() const { return 0.5 * acceleration; }
};

}  // namespace tiller::simulator::arm
