// SPDX-License-Identifier: MIT
#pragma once

// How targets and parameters of a stream are looked at and put into a command. Inside this folder only.

#include "robot/control/detail/mailbox.h"
#include "robot/control/detail/velocity_limiter.h"
#include "robot/control/setpoints.h"
#include "robot/core/error.h"

namespace tiller::control {

/// Real-time: yes, as long as there is nothing to complain about. An error with code None is none.
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

    /// Whether the arm can get from one servo target to the next: see kJointLeeway.
    /// seconds  between them
    Error step(const JointPositions& from, const JointPositions& to, double seconds) const;
    Error step(const Pose& from, const Pose& to, double seconds) const;
};

/// How long the step to the next servo target may be reckoned [s].
/// since   the one before [s]; 0 for the first
/// rules   for how long one target rules [s]
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
