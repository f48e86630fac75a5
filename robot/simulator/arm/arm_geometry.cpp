// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/arm_geometry.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller::simulator::arm {

namespace {
constexpr int kMaxIterations = 10;
constexpr double kConverged = 1e-11;  // m and rad
constexpr double kAccepted = 1e-8;    // m and rad
constexpr double kLargestStep = 0.2;  // rad
}  // namespace

Eigen::Quaterniond quaternionFromVector(const Eigen::Vector3d& rotation) {
    const double angle = rotation.norm();
    if (angle < 1e-9) {
        return Eigen::Quaterniond(1, 0.5 * rotation.x(), 0.5 * rotation.y(), 0.5 * rotation.z()).normalized();
    }
    const Eigen::Vector3d v = rotation * (std::sin(0.5 * angle) / angle);
    return {std::cos(0.5 * angle), v.x(), v.y(), v.z()};
}

Eigen::Vector3d vectorFromQuaternion(const Eigen::Quaterniond& q) {
    const double sign = q.w() < 0 ? -1.0 : 1.0;
    const double sine = q.vec().norm();
    if (sine < 1e-9) {
        return 2.0 * sign * q.vec();
    }
    return q.vec() * (2.0 * sign * std::atan2(sine, sign * q.w()) / sine);
}

ArmGeometry::ArmGeometry(const RobotModel& model) : model_(model) {
    const auto alpha = Vector6::Map(model.dh.alpha.data()).array();
    sinAlpha_ = alpha.sin();
    cosAlpha_ = alpha.cos();
    for (std::size_t i = 0; i < turned_.size(); ++i) {
        turned_[i] = Eigen::AngleAxisd(model.dh.beta[i], Eigen::Vector3d::UnitY()).toRotationMatrix();
    }
    const auto& a = model.dh.a;
    determinantScale_ = std::abs(a[1] * a[2]) * (std::abs(a[1]) + std::abs(a[2]));
}

void ArmGeometry::setTcp(const Pose& T_flange_tcp) {
    tcp_ = T_flange_tcp;
    T_flange_tcp_ = T_flange_tcp.transform();
}

void ArmGeometry::placeLinks(const Vector6& q, std::array<Eigen::Isometry3d, 7>& frames) const {
    frames[0].setIdentity();
    for (int i = 0; i < kJointCount; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double theta = q[i] + model_.dh.theta[k];
        const double st = std::sin(theta);
        const double ct = std::cos(theta);
        const auto before = frames[k].linear();
        const Eigen::Vector3d x = ct * before.col(0) + st * before.col(1);
        const Eigen::Vector3d y = ct * before.col(1) - st * before.col(0);
        Eigen::Isometry3d& T = frames[k + 1];
        T.linear().col(0) = x;
        T.linear().col(1) = cosAlpha_[i] * y + sinAlpha_[i] * before.col(2);
        T.linear().col(2) = cosAlpha_[i] * before.col(2) - sinAlpha_[i] * y;
        if (model_.dh.beta[k] != 0) {
            T.linear() = (T.linear() * turned_[k]).eval();
        }
        T.translation() = frames[k].translation() + model_.dh.a[k] * x + model_.dh.d[k] * before.col(2);
        T.makeAffine();
    }
}

void ArmGeometry::evaluate(const Vector6& q, Posture& posture) const {
    placeLinks(q, posture.frames);
    posture.T_base_tcp = posture.frames[6] * T_flange_tcp_;
    const Eigen::Vector3d p = posture.T_base_tcp.translation();
    for (int i = 0; i < kJointCount; ++i) {
        // Joint i+1 rotates about the z axis of frame i.
        const Eigen::Isometry3d& T = posture.frames[static_cast<std::size_t>(i)];
        const Eigen::Vector3d z = T.linear().col(2);
        posture.jacobian.col(i).head<3>() = z.cross(p - T.translation());
        posture.jacobian.col(i).tail<3>() = z;
    }
}

Eigen::Isometry3d ArmGeometry::tcpPose(const Vector6& q) const {
    std::array<Eigen::Isometry3d, 7> frames;
    placeLinks(q, frames);
    return frames[6] * T_flange_tcp_;
}

Vector6 ArmGeometry::solve(const Posture& posture, const Vector6& twist) const {
    const Eigen::PartialPivLU<Matrix6> lu(posture.jacobian);
    if (std::abs(lu.determinant()) > 1e-4 * determinantScale_) {
        return lu.solve(twist);
    }
    const Matrix6 JJt = posture.jacobian * posture.jacobian.transpose();
    const Matrix6 damped = JJt + 1e-8 * Matrix6::Identity();
    return posture.jacobian.transpose() * damped.partialPivLu().solve(twist);
}

bool ArmGeometry::isReachable(const Eigen::Isometry3d& T) const {
    return kinematics::inverse(model().dh, T * tcpTransform().inverse()).count > 0;
}

bool ArmGeometry::follow(const Eigen::Isometry3d& T, Vector6& q, Posture& posture) const {
    for (int i = 0; i < kMaxIterations; ++i) {
        evaluate(q, posture);
        Vector6 error;
        error.head<3>() = T.translation() - posture.T_base_tcp.translation();
        error.tail<3>() =
            vectorFromQuaternion(Eigen::Quaterniond(T.linear() * posture.T_base_tcp.linear().transpose()));
        const double size = error.cwiseAbs().maxCoeff();
        if (size < kConverged || (i + 1 == kMaxIterations && size < kAccepted)) {
            return true;
        }
        Vector6 step = solve(posture, error);
        const double largest = step.cwiseAbs().maxCoeff();
        if (!(largest < 1e6)) {
            return false;
        }
        if (largest > kLargestStep) {
            step *= kLargestStep / largest;
        }
        q += step;
    }
    return false;
}

bool ArmGeometry::jointRates(const Posture& posture, const Vector6& twist, Vector6& qd) const {
    qd = solve(posture, twist);
    return (posture.jacobian * qd - twist).norm() <= 0.01 * twist.norm();
}

double ArmGeometry::singularityMargin(const Vector6& q, const Posture& posture) const {
    // Each distance is relative to the distance at which the singularity starts to have an effect.
    const double wrist = std::abs(std::sin(q[4]));
    const double elbow = std::abs(std::sin(q[2]));
    const Eigen::Vector3d centre = posture.frames[5].translation();
    // Distance of the wrist centre from the cylinder of radius d4 around axis 1, measured along the tangent.
    const double d4 = model_.dh.d[3];
    const double shoulder = std::sqrt(std::max(0.0, centre.head<2>().squaredNorm() - d4 * d4));
    return std::min({wrist / 0.3, elbow / 0.4, shoulder / 0.15});
}

Vector6 ArmGeometry::maxSpeed() const {
    return Eigen::Map<const Vector6>(model_.maxJointSpeed.data());
}

}  // namespace tiller::simulator::arm
