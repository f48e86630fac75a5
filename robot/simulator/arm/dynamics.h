// SPDX-License-Identifier: MIT
#pragma once

// Rigid-body dynamics of the arm with a payload: joint torques, mass matrix, Coriolis torques, momentum.
// NewtonEuler calculates the torques and orocos-KDL the rarely used quantities, both with the DH parameters
// of the model. Only setGravity() allocates memory after construction.

#include <memory>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "robot/simulator/arm/arm_state.h"

namespace tiller::simulator::arm {

class Dynamics {
public:
    explicit Dynamics(const RobotModel& model);
    ~Dynamics();

    void setPayload(const Payload& payload);
    /// Sets gravity as measured by an accelerometer at the base [m/s2]; [0, 0, 9.82] when upright.
    void setGravity(const Eigen::Vector3d& gravity);

    /// Joint torques [Nm] that produce qdd while the wrench `onFlange` (flange frame, about its origin) acts
    /// on the flange.
    Vector6 torques(const Vector6& q, const Vector6& qd, const Vector6& qdd, const Wrench& onFlange = {});
    /// rotors  whether to include the inertia of the motors, as seen by the joints through their gears
    Matrix6 massMatrix(const Vector6& q, bool rotors = false);
    Vector6 coriolis(const Vector6& q, const Vector6& qd);
    Vector6 gravityTorques(const Vector6& q);

    /// Momentum of all links and the payload, base frame.
    struct Momentum {
        Eigen::Vector3d linear = Eigen::Vector3d::Zero();       ///< [kg m/s]
        Eigen::Vector3d angular = Eigen::Vector3d::Zero();      ///< about the origin of the base [kg m2/s]
        double mass = 0;                                        ///< [kg]
        Eigen::Vector3d firstMoment = Eigen::Vector3d::Zero();  ///< mass times centre [kg m]
    };
    Momentum momentum(const std::array<Eigen::Isometry3d, 7>& frames, const Vector6& qd) const;

private:
    struct Chain;
    std::unique_ptr<Chain> chain_;
};

}  // namespace tiller::simulator::arm
