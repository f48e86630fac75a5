// SPDX-License-Identifier: MIT
#pragma once

// Poses, twists and wrenches in the controller's representation: metres, radians, newtons, and orientations
// as rotation vectors (axis times angle, angle in [0, pi]). Variable names contain the frames: T_base_tool
// maps tool coordinates to base coordinates.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/text.h"

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

    /// x y z rx ry rz [m, rad]
    static Pose fromArray(const std::array<double, 6>& v) { return {v[0], v[1], v[2], v[3], v[4], v[5]}; }
    /// Errors   std::invalid_argument if the size is not 6
    static Pose fromStdVector(const std::vector<double>& v);
    std::vector<double> toStdVector() const;  ///< x y z rx ry rz [m, rad]
    /// Indices 0, 1, 2: position [m]; 3, 4, 5: rotation vector [rad].
    double& operator[](int i) { return i < 3 ? position[i] : rotation[i - 3]; }
    double operator[](int i) const { return i < 3 ? position[i] : rotation[i - 3]; }
    std::array<double, 6> array() const {  ///< x y z rx ry rz [m, rad]
        return {position.x(), position.y(), position.z(), rotation.x(), rotation.y(), rotation.z()};
    }
    Eigen::Isometry3d transform() const;  ///< Maps coordinates in this pose's frame to its reference frame.
    /// Inverse transform: T_b_a for T_a_b.
    Pose inverse() const;
    bool allFinite() const;  ///< True if no value is NaN or infinite.
    friend bool operator==(const Pose&, const Pose&) = default;
    /// T_a_c = T_a_b * T_b_c. Source: URScript pose_trans
    friend Pose operator*(const Pose& T_a_b, const Pose& T_b_c);
    /// Transforms a point from frame b to frame a.
    friend Eigen::Vector3d operator*(const Pose& T_a_b, const Eigen::Vector3d& point);
    /// In URScript notation, e.g. "p[0.1, 0.2, 0.3, 0, 3.14159, 0]".
    friend std::ostream& operator<<(std::ostream& out, const Pose& pose);
};

/// Linear [m/s] and angular [rad/s] velocity. The frame is documented where the type is used.
struct Twist {
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();

    Vector6 vector() const;                     ///< vx vy vz wx wy wz
    static Twist fromVector(const Vector6& v);  ///< vx vy vz wx wy wz
    bool isZero() const;                        ///< True if all components are exactly 0.
    friend Twist operator+(const Twist& a, const Twist& b);
    friend Twist operator-(const Twist& a, const Twist& b);
    friend Twist operator*(const Twist& a, double f);
    friend Twist operator*(double f, const Twist& a) { return a * f; }
    friend std::ostream& operator<<(std::ostream& out, const Twist& twist);
    friend bool operator==(const Twist&, const Twist&) = default;
};

/// Force [N] and torque [Nm]. The frame is documented where the type is used.
struct Wrench {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();

    Vector6 vector() const;                      ///< Fx Fy Fz Tx Ty Tz
    static Wrench fromVector(const Vector6& v);  ///< Fx Fy Fz Tx Ty Tz
    friend Wrench operator+(const Wrench& a, const Wrench& b);
    friend Wrench operator-(const Wrench& a, const Wrench& b);
    friend Wrench operator*(const Wrench& a, double f);
    friend Wrench operator*(double f, const Wrench& a) { return a * f; }
    friend bool operator==(const Wrench&, const Wrench&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Wrench& wrench);
};

/// Rotation vector [rad] to rotation matrix.
Eigen::Matrix3d rotationMatrix(const Eigen::Vector3d& rotationVector);
/// Rotation matrix to rotation vector [rad], length 0 ... pi.
Eigen::Vector3d rotationVector(const Eigen::Matrix3d& R);

/// Roll, pitch, yaw [rad] with R = Rz(yaw) Ry(pitch) Rx(roll). At pitch = +-90 deg, yaw is set to 0.
Eigen::Vector3d rpyFromRotationVector(const Eigen::Vector3d& rotationVector);
/// The inverse of rpyFromRotationVector(). Both [rad].
Eigen::Vector3d rotationVectorFromRpy(const Eigen::Vector3d& rpy);

}  // namespace tiller
