// SPDX-License-Identifier: MIT
#pragma once

// Decides how much of an asked-for velocity the arm may have here and now, and says what holds it down. It
// only ever scales: the direction stays what the hand asked for.

#include <array>

#include "robot/control/control_status.h"
#include "robot/control/motion_types.h"
#include "robot/core/robot_model.h"
#include "robot/script/controller_message.h"

namespace tiller::control {

/// What is known of the arm.
struct ArmLimits {
    DhParameters dh;
    std::array<double, 6> minPosition{};  ///< [rad]
    std::array<double, 6> maxPosition{};  ///< [rad]
    std::array<double, 6> maxSpeed{};     ///< [rad/s]
    std::array<double, 6> maxTorque{};    ///< [Nm]

    static ArmLimits of(const RobotModel& model);
    /// What the robot tells of itself; the model's where it tells nothing that can be.
    static ArmLimits of(const RobotModel& model, const script::RobotConfiguration& told);
};

/// Slows down so that joints stop before their limits and the arm before its singularities; motion away from
/// either is free. Holds TCP, elbow, rotation and joints to their caps.
/// Threads  one. Real-time: yes (no allocation; a few microseconds)
class VelocityLimiter {
public:
    VelocityLimiter(const ArmLimits& arm, const MotionLimits& limits) : arm_(arm), limits_(limits) {}

    /// q, tcpPose  where the arm is (base frame)
    /// Returns     Limiter::scale to multiply the target with, 0 when it may not move that way at all
    Limiter limit(const JogTarget& target, const JointPositions& q, const Pose& tcpPose) const;

    /// Another cap on TCP and elbow [m/s].
    void setSpeedCap(double cap) { limits_.tcpSpeed = cap; }
    const ArmLimits& arm() const { return arm_; }

private:
    ArmLimits arm_;
    MotionLimits limits_;
};

/// The target's twist in the base frame. tcpPose is needed for JogFrame::Tool.
Twist twistInBase(const JogTarget& target, const Pose& tcpPose);

}  // namespace tiller::control
