// SPDX-License-Identifier: MIT
#pragma once

// Geometry for the motion generator: poses of tool and links, their velocities, and the inverse kinematics on
// the current branch.

#include <Eigen/Geometry>
#include <array>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"

namespace tiller::simulator::arm {

/// All quantities that follow from one set of joint positions.
struct Posture {
    std::array<Eigen::Isometry3d, 7> frames;  ///< T_base_i, 0 = base ... 6 = flange
    Eigen::Isometry3d T_base_tcp;
    Matrix6 jacobian;  ///< TCP twist in base axes = jacobian * qd
};

class ArmGeometry {
public:
    explicit ArmGeometry(const RobotModel& model);

    void setTcp(const Pose& T_flange_tcp);
    const Pose& tcp() const { return tcp_; }
    const Eigen::Isometry3d& tcpTransform() const { return T_flange_tcp_; }
    const RobotModel& model() const { return model_; }

    void evaluate(const Vector6& q, Posture& posture) const;
    Eigen::Isometry3d tcpPose(const Vector6& q) const;

    /// Newton iteration from q to the joint positions whose TCP pose is T. Stays on the branch of q.
    /// Returns   false if there is no solution near q; q is then the closest position that was found
    bool follow(const Eigen::Isometry3d& T, Vector6& q, Posture& posture) const;

    /// True if any joint positions reach this TCP pose.
    bool isReachable(const Eigen::Isometry3d& T) const;

    /// Joint velocities for a TCP twist; damped near singularities.
    /// Returns   false if the twist cannot be produced with an accuracy of 1 %
    bool jointRates(const Posture& posture, const Vector6& twist, Vector6& qd) const;

    /// Singularity margin: 0 in a singular position, 1 or more where the singularity has no effect.
    double singularityMargin(const Vector6& q, const Posture& posture) const;

    Vector6 maxSpeed() const;

private:
    Vector6 solve(const Posture& posture, const Vector6& twist) const;
    /// Same as kinematics::linkFrames(), but with precomputed sines of constant angles.
    void placeLinks(const Vector6& q, std::array<Eigen::Isometry3d, 7>& frames) const;

    const RobotModel& model_;
    Vector6 sinAlpha_;
    Vector6 cosAlpha_;
    std::array<Eigen::Matrix3d, 6> turned_;  ///< rotations about y by the DH angles beta
    Pose tcp_;
    Eigen::Isometry3d T_flange_tcp_ = Eigen::Isometry3d::Identity();
    double determinantScale_ = 1;
};

/// Conversion between rotation vectors and quaternions. Also accurate for rotations near zero.
Eigen::Quaterniond quaternionFromVector(const Eigen::Vector3d& rotation);
Eigen::Vector3d vectorFromQuaternion(const Eigen::Quaterniond& q);

}  // namespace tiller::simulator::arm
