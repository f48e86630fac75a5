// SPDX-License-Identifier: MIT
#include "robot/kinematics/payload_estimation.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace tiller::kinematics {
namespace {

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d result;
    result << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return result;
}

}  // namespace

PayloadEstimate estimatePayload(std::span<const PayloadReading> readings, double gravity) {
    PayloadEstimate result;
    const auto count = static_cast<Eigen::Index>(readings.size());
    if (std::any_of(readings.begin(), readings.end(), [](const PayloadReading& reading) {
            return !reading.felt.vector().allFinite() || !reading.R_base_flange.allFinite();
        })) {
        result.problem = PayloadEstimate::Problem::NotFinite;
        return result;
    }
    if (count == 0) {
        return result;
    }
    // force_i = R_i^T weight + zero, with the weight in the base frame, for any mounting of the arm.
    Eigen::MatrixXd turns(3 * count, 6);
    Eigen::VectorXd forces(3 * count);
    Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
    for (Eigen::Index i = 0; i < count; ++i) {
        const PayloadReading& reading = readings[static_cast<std::size_t>(i)];
        turns.middleRows<3>(3 * i) << reading.R_base_flange.transpose(), Eigen::Matrix3d::Identity();
        forces.segment<3>(3 * i) = reading.felt.force;
        mean += reading.R_base_flange.transpose() / static_cast<double>(count);
    }
    Eigen::MatrixXd centred(3 * count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
        centred.middleRows<3>(3 * i) = readings[static_cast<std::size_t>(i)].R_base_flange.transpose() - mean;
    }
    result.spread = Eigen::JacobiSVD<Eigen::MatrixXd>(centred).singularValues()[2] /
                    std::sqrt(static_cast<double>(count));
    if (count < kMinPayloadPoses) {
        return result;
    }
    if (result.spread < kMinPayloadSpread) {
        result.problem = PayloadEstimate::Problem::TooAlike;
        return result;
    }
    const Eigen::Matrix<double, 6, 1> byForce = turns.colPivHouseholderQr().solve(forces);
    const Eigen::Vector3d weight = byForce.head<3>();
    result.zero.force = byForce.tail<3>();
    result.mass = weight.norm() / gravity;
    if (result.mass < kMinPayloadMass) {
        result.problem = PayloadEstimate::Problem::NoWeight;
        return result;
    }
    result.down = weight.normalized();

    // torque_i = centre x (R_i^T weight) + zero
    Eigen::MatrixXd arms(3 * count, 6);
    Eigen::VectorXd torques(3 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const PayloadReading& reading = readings[static_cast<std::size_t>(i)];
        arms.middleRows<3>(3 * i) << -crossMatrix(reading.R_base_flange.transpose() * weight),
            Eigen::Matrix3d::Identity();
        torques.segment<3>(3 * i) = reading.felt.torque;
    }
    const Eigen::Matrix<double, 6, 1> byTorque = arms.colPivHouseholderQr().solve(torques);
    result.centre = byTorque.head<3>();
    result.zero.torque = byTorque.tail<3>();
    result.problem = PayloadEstimate::Problem::None;

    const Eigen::VectorXd forceLeft = turns * byForce - forces;
    const Eigen::VectorXd torqueLeft = arms * byTorque - torques;
    result.forceResidual = std::sqrt(forceLeft.squaredNorm() / static_cast<double>(count));
    result.torqueResidual = std::sqrt(torqueLeft.squaredNorm() / static_cast<double>(count));
    double worst = -1;
    for (Eigen::Index i = 0; i < count; ++i) {
        // A force of 1 N is weighted like a torque of 0.1 Nm (a lever arm of 0.1 m).
        const double left = forceLeft.segment<3>(3 * i).norm() + 10 * torqueLeft.segment<3>(3 * i).norm();
        if (left > worst) {
            worst = left;
            result.worst = static_cast<int>(i);
        }
    }
    return result;
}

Wrench feltAtFlange(const Wrench& atTcp, const Eigen::Matrix3d& R_base_flange, const Eigen::Vector3d& tcp,
                    double mass, const Eigen::Vector3d& centre, const Eigen::Vector3d& down, double gravity) {
    const Eigen::Vector3d known = R_base_flange.transpose() * (mass * gravity * down);
    Wrench felt;
    felt.force = R_base_flange.transpose() * atTcp.force;
    felt.torque = R_base_flange.transpose() * atTcp.torque + tcp.cross(felt.force) + centre.cross(known);
    felt.force += known;
    return felt;
}

}  // namespace tiller::kinematics
