// SPDX-License-Identifier: MIT
#pragma once

// Checks the targets and parameters of a stream and converts them to a command. Used only in this folder.

#include "robot/control/detail/mailbox.h"
#include "robot/control/detail/velocity_limiter.h"
#include "robot/control/setpoints.h"
#include "robot/core/error.h"

namespace tiller::control {

/// Limits for the targets and parameters of a stream. The functions return an error with the code None if the
/// value is valid.
/// Real-time: yes, for valid values
struct SetpointRules {
    ArmLimits arm;
    double toolSpeed = 0;  ///< [m/s]

    Error check(const JointPositions& target) const;
    Error check(const Pose& target) const;
    Error check(const JointVelocities& target) const;
    Error check(const Twist& target) const;
    Error check(const JointTorques& target) const;
    Error check(const ServoParameters& parameters) const;
    Error check(const CircularServoParameters& parameters) const;
    Error check(const SpeedParameters& parameters) const;
    Error check(const TorqueParameters& parameters) const;

    /// Checks that the arm can move from one servo target to the next: see kJointLeeway.
    /// seconds  time between the targets
    Error step(const JointPositions& from, const JointPositions& to, double seconds) const;
    Error step(const Pose& from, const Pose& to, double seconds) const;
};

/// Time available for the move to the next servo target [s].
/// since  time since the previous target [s]; 0 for the first
/// rules  duration of one target [s]
double stepTime(double since, double rules);

SetpointRules rulesOf(Controller& controller);

void fill(MotionCommand& command, const JointPositions& target);
void fill(MotionCommand& command, const Pose& target);
void fill(MotionCommand& command, const JointVelocities& target);
void fill(MotionCommand& command, const Twist& target);
void fill(MotionCommand& command, const JointTorques& target);
void fill(MotionCommand& command, const ServoParameters& parameters, double period);
void fill(MotionCommand& command, const CircularServoParameters& parameters, double period);
void fill(MotionCommand& command, const SpeedParameters& parameters, double period);
void fill(MotionCommand& command, const TorqueParameters& parameters, double period);

}  // namespace tiller::control
