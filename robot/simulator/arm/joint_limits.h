// SPDX-License-Identifier: MIT
#pragma once

// Limits of the joints for any requested motion.

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"

namespace tiller::simulator::arm {

/// Distance kept from the end of the joint range [rad].
constexpr double kRangeReserve = 0.002;

/// Joint state commanded to the drives.
struct JointTarget {
    Vector6 q = Vector6::Zero();   ///< [rad]
    Vector6 qd = Vector6::Zero();  ///< [rad/s]
};

struct JointLimits {
    Vector6 speed = Vector6::Constant(3.14);        ///< [rad/s]
    double acceleration = kJointAccelerationLimit;  ///< [rad/s2]
    double position = kJointPositionLimit;          ///< [rad]

    /// Acceleration of planned motion. The rest is reserved for corrections.
    double plannedAcceleration() const { return 0.9 * acceleration; }
    /// Deceleration used to stop a joint before the end of its range.
    double brakingAcceleration() const { return 0.5 * acceleration; }

    /// Factor 0..1 by which qd must be scaled to stay within the speed limits.
    double speedFactor(const Vector6& qd) const;
    /// Factor 0..1 by which qd must be scaled so that every joint can stop before the end of its range.
    /// `joint` is set to the limiting joint.
    double rangeFactor(const Vector6& q, const Vector6& qd, double period, int& joint) const;
    /// Limits the velocity change to the permitted acceleration within `period`, with the same factor for all
    /// joints.
    /// Returns  true if the change was limited
    bool cutToAcceleration(const Vector6& from, Vector6& to, double period) const;
    /// True if the position change matches the velocities; false for a jump, e.g. to another branch.
    bool continuous(const JointTarget& from, const JointTarget& to, double period) const;
};

}  // namespace tiller::simulator::arm
