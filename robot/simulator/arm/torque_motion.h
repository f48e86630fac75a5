// SPDX-License-Identifier: MIT
#pragma once

// direct_torque: the joints move according to the commanded torques and the inertia of the arm. Gravity is
// always compensated, friction only partially.

#include <optional>

#include "robot/simulator/arm/dynamics.h"
#include "robot/simulator/arm/joint_limits.h"
#include "robot/simulator/arm/motion_types.h"

namespace tiller::simulator::arm {

class TorqueMotion {
public:
    explicit TorqueMotion(Dynamics& dynamics) : dynamics_(dynamics) {}

    /// Sets the commanded torques.
    /// torques                     [Nm] without gravity
    /// viscousScale, coulombScale  compensated fractions of the friction, 0..1
    void command(const JointTorques& torques, const Vector6& viscousScale, const Vector6& coulombScale);
    /// Sets the external torques on the joints [Nm]: hands, contact, unknown load.
    void setExternal(const Vector6& torques) { external_ = torques; }
    /// Runs one control period.
    /// Returns  the reason if a joint is too fast or has reached the end of its range; `joint` is then set to
    ///          this joint
    std::optional<StopReason> step(double period, const JointLimits& limits, JointTarget& state, int& joint);

private:
    Dynamics& dynamics_;
    Vector6 torques_ = Vector6::Zero();
    Vector6 external_ = Vector6::Zero();
    Vector6 viscous_ = Vector6::Zero();  // Nm s/rad, after compensation
    Vector6 coulomb_ = Vector6::Zero();  // Nm, after compensation
};

}  // namespace tiller::simulator::arm
