// SPDX-License-Identifier: MIT
#include "robot/core/spatial.h"

#include <cmath>
#include <numbers>

namespace tiller {

Pose::Pose(const Eigen::Isometry3d& T) : position(T.translation()), rotation(rotationVector(T.linear())) {}

Eigen::Isometry3d Pose::transform() const {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = rotationMatrix(rotation);
    T.translation() = position;
    return T;
}

Pose Pose::fromStdVector(const std::vector<double>& v) {
    const JointPositions six(v);  // throws a descriptive exception
    return fromArray(six.array());
}

std::vector<double> Pose::toStdVector() const {
    const auto six = array();
    return {six.begin(), six.end()};
}

Pose Pose::inverse() const {
    return Pose(transform().inverse());
}

bool Pose::allFinite() const {
    return position.allFinite() && rotation.allFinite();
}

Pose operator*(const Pose& T_a_b, const Pose& T_b_c) {
    return Pose(T_a_b.transform() * T_b_c.transform());
}

Eigen::Vector3d operator*(const Pose& T_a_b, const Eigen::Vector3d& point) {
    return T_a_b.transform() * point;
}

std::ostream& operator<<(std::ostream& out, const Pose& pose) {
    return writeNumbers(out << 'p', pose.array());
}

Vector6 Twist::vector() const {
    return (Vector6() << linear, angular).finished();
}

Twist Twist::fromVector(const Vector6& v) {
    return {v.head<3>(), v.tail<3>()};
}

bool Twist::isZero() const {
    return linear.isZero(0) && angular.isZero(0);
}

Twist operator+(const Twist& a, const Twist& b) {
    return {a.linear + b.linear, a.angular + b.angular};
}

Twist operator-(const Twist& a, const Twist& b) {
    return {a.linear - b.linear, a.angular - b.angular};
}

Twist operator*(const Twist& a, double f) {
    return {a.linear * f, a.angular * f};
}

std::ostream& operator<<(std::ostream& out, const Twist& twist) {
    const Vector6 v = twist.vector();
    return writeNumbers(out, {v.data(), 6});
}

Vector6 Wrench::vector() const {
    return (Vector6() << force, torque).finished();
}

Wrench Wrench::fromVector(const Vector6& v) {
    return {v.head<3>(), v.tail<3>()};
}

Wrench operator+(const Wrench& a, const Wrench& b) {
    return {a.force + b.force, a.torque + b.torque};
}

Wrench operator-(const Wrench& a, const Wrench& b) {
    return {a.force - b.force, a.torque - b.torque};
}

Wrench operator*(const Wrench& a, double f) {
    return {a.force * f, a.torque * f};
}

std::ostream& operator<<(std::ostream& out, const Wrench& wrench) {
    const Vector6 v = wrench.vector();
    return writeNumbers(out, {v.data(), 6});
}

Eigen::Matrix3d rotationMatrix(const Eigen::Vector3d& rotationVector) {
    const double angle = rotationVector.norm();
    if (angle < 1e-12) {
        // The first-order term is exact to 1e-24 here and avoids a division by the angle.
        Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
        R(0, 1) = -rotationVector.z();
        R(0, 2) = rotationVector.y();
        R(1, 0) = rotationVector.z();
        R(1, 2) = -rotationVector.x();
        R(2, 0) = -rotationVector.y();
        R(2, 1) = rotationVector.x();
        return R;
    }
    return Eigen::AngleAxisd(angle, rotationVector / angle).toRotationMatrix();
}

Eigen::Vector3d rotationVector(const Eigen::Matrix3d& R) {
    // The quaternion is well conditioned over the whole range, including pi.
    Eigen::Quaterniond q(R);
    q.normalize();
    if (q.w() < 0) {
        q.coeffs() = -q.coeffs();
    }
    const double sine = q.vec().norm();
    if (sine < 1e-12) {
        return 2.0 * q.vec();
    }
    return q.vec() * (2.0 * std::atan2(sine, q.w()) / sine);
}

Eigen::Vector3d rpyFromRotationVector(const Eigen::Vector3d& rotationVector) {
    const Eigen::Matrix3d R = rotationMatrix(rotationVector);
    const double cosPitch = std::hypot(R(0, 0), R(1, 0));
    const double pitch = std::atan2(-R(2, 0), cosPitch);
    if (cosPitch < 1e-9) {
        // Gimbal lock: only the sum or difference of roll and yaw is defined, so yaw is set to 0.
        const double roll = std::atan2(-R(1, 2), R(1, 1));
        return {roll, pitch, 0.0};
    }
    return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

Eigen::Vector3d rotationVectorFromRpy(const Eigen::Vector3d& rpy) {
    const Eigen::Matrix3d R = (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
                                  .toRotationMatrix();
    return tiller::rotationVector(R);
}

}  // namespace tiller
