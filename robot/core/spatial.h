// SPDX-License-Identifier: MIT
#pragma once

// Poses, twists and wrenches as the controller writes them: metres, radians, newtons, and orientations as
// rotation vectors (axis times angle, angle in [0, pi]). Names carry the frame: T_base_tool maps tool
// coordinates to base coordinates.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "robot/core/joints.h"

namespace tiller {

/// Position [m] and orientation (rotation vector [rad]).
struct Pose {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();

    Pose() = default;
    Pose(const Eigen::Vector3d& p, const Eigen::Vector3d& r) : position(p), rotation(r) {}
    Pose(double x, double y, double z, double rx, double ry, double rz)
        : position(x, y, z), rotation(rx, ry, rz) {}
    explicit Pose(const Eigen::Isometry3d& T);

    static Pose fromArray(const std::array<double, 6>& v) { return {v[0], v[1], v[2], v[3], v[4], v[5]}; }
    std::array<double, 6> array() const {
        return {position.x(), position.y(), position.z(), rotation.x(), rotation.y(), rotation.z()};
    }
    Eigen::Isometry3d transform() const;
    bool allFinite() const { return position.allFinite() && rotation.allFinite(); }
    friend bool operator==(const Pose&, const Pose&) = default;
};

/// Linear [m/s] and angular [rad/s] velocity, in the frame the holder names.
struct Twist {
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();

    Vector6 vector() const { return (Vector6() << linear, angular).finished(); }
    static Twist fromVector(const Vector6& v) { return {v.head<3>(), v.tail<3>()}; }
    bool isZero() const { return linear.isZero(0) && angular.isZero(0); }
    friend bool operator==(const Twist&, const Twist&) = default;
};

/// Force [N] and torque [Nm], in the frame the holder names.
struct Wrench {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();

    Vector6 vector() const { return (Vector6() << force, torque).finished(); }
    static Wrench fromVector(const Vector6& v) { return {v.head<3>(), v.tail<3>()}; }
    friend bool operator==(const Wrench&, const Wrench&) = default;
};

/// Rotation vector [rad] to matrix and back; the angle of the result is in [0, pi].
Eigen::Matrix3d rotationMatrix(const Eigen::Vector3d& rotationVector);
Eigen::Vector3d rotationVector(const Eigen::Matrix3d& R);

/// Roll, pitch, yaw [rad], R = Rz(yaw) Ry(pitch) Rx(roll). At pitch = +-90 deg yaw is set to 0.
Eigen::Vector3d rpyFromRotationVector(const Eigen::Vector3d& rotationVector);
Eigen::Vector3d rotationVectorFromRpy(const Eigen::Vector3d& rpy);

}  // namespace tiller
