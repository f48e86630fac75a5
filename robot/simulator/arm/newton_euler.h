// SPDX-License-Identifier: MIT
#pragma once

// Joint torques of a motion by the recursive Newton-Euler algorithm, with each link in its own frame: outward
// recursion of velocities and accelerations, inward recursion of forces. Optimized for six revolute joints
// with Denavit-Hartenberg parameters, because the simulated controller runs this algorithm at least twice per
// control period.

#include <array>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "robot/simulator/arm/arm_state.h"

namespace tiller::simulator::arm {

/// No function allocates memory.
class NewtonEuler {
public:
    explicit NewtonEuler(const RobotModel& model);

    /// Sets the payload at the flange, which is added to the last link.
    void setPayload(const Payload& payload);
    /// Sets gravity as measured by an accelerometer at the base [m/s2]; [0, 0, 9.82] when upright.
    void setGravity(const Eigen::Vector3d& gravity) { gravity_ = gravity; }

    /// Joint torques [Nm] that produce qdd while the wrench `onFlange` (flange frame, about its origin) acts
    /// on the flange.
    Vector6 torques(const Vector6& q, const Vector6& qd, const Vector6& qdd, const Wrench& onFlange) const;

private:
    struct Body {
        double mass = 0;                                    ///< [kg]
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< link frame [m]
        Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre, link frame [kg m2]
    };
    struct Link {
        double theta = 0;  ///< added to the joint position [rad]
        double sinAlpha = 0;
        double cosAlpha = 1;
        Eigen::Vector3d arm = Eigen::Vector3d::Zero();  ///< vector from the previous frame, link frame [m]
        Body body;
    };
    static Body joined(const Body& one, const Body& other);

    std::array<Link, kJointCount> links_;
    Body bareLast_;  ///< the last link without the payload
    Eigen::Vector3d gravity_{0, 0, 9.82};
};

}  // namespace tiller::simulator::arm
