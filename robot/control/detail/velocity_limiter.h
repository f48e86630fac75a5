// SPDX-License-Identifier: MIT
#pragma once

// Reduces a requested velocity to the permitted value and reports the limit. The velocity is only scaled; its
// direction does not change.

#include <array>

#include "robot/collision/collision_check.h"
#include "robot/control/control_status.h"
#include "robot/control/motion_types.h"
#include "robot/core/robot_model.h"
#include "robot/script/controller_message.h"

namespace tiller::control {

/// Properties of the arm.
struct ArmLimits {
    DhParameters dh;
    std::array<double, 6> minPosition{};  ///< [rad]
    std::array<double, 6> maxPosition{};  ///< [rad]
    std::array<double, 6> maxSpeed{};     ///< [rad/s]
    std::array<double, 6> maxTorque{};    ///< [Nm]

    static ArmLimits of(const RobotModel& model);
    /// Uses the values reported by the robot. Model values replace missing or implausible values.
    static ArmLimits of(const RobotModel& model, const script::RobotConfiguration& reported);
};

/// Limits the speed so that joints stop before their limits, and the arm stops before singularities and at
/// the safety distance from itself and its environment. Motion away from them is not limited. Also limits the
/// speeds of TCP, elbow, rotation and joints.
/// Threads  one. Real-time: yes (no allocation; a few tens of microseconds)
class VelocityLimiter {
public:
    VelocityLimiter(const ArmLimits& arm, const MotionLimits& limits) : arm_(arm), limits_(limits) {}

    /// Current motion of the arm and the objects it could collide with.
    struct Situation {
        JointVelocities qd = {};                           ///< current velocity of the arm [rad/s]
        const collision::CollisionCheck* check = nullptr;  ///< null: no check
    };
    /// q, tcpPose  current joint positions, and TCP pose in the base frame
    /// A jog with contact detection (contactForce) may touch the environment with the tool and wrist 3.
    /// Returns     the factor for the target in Limiter::scale; 0 if motion in this direction is not
    ///             permitted or a value is not finite
    Limiter limit(const JogTarget& target, const JointPositions& q, const Pose& tcpPose,
                  const Situation& situation) const;
    Limiter limit(const JogTarget& target, const JointPositions& q, const Pose& tcpPose) const {
        return limit(target, q, tcpPose, Situation());
    }

    /// Changes the speed limit of TCP and elbow [m/s].
    void setSpeedCap(double cap) { limits_.tcpSpeed = cap; }
    const ArmLimits& arm() const { return arm_; }

private:
    struct Motion;
    void keepClear(Limiter& limiter, const Motion& motion, const Situation& situation) const;
    double brakingTime(bool cartesian, const Twist& twist, const Vector6& qd) const;

    ArmLimits arm_;
    MotionLimits limits_;
};

/// The target's twist in the base frame. tcpPose is used only for JogFrame::Tool.
Twist twistInBase(const JogTarget& target, const Pose& tcpPose);

}  // namespace tiller::control
