// SPDX-License-Identifier: MIT
#include "robot/kinematics/tcp_calibration.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace tiller::kinematics {
namespace {

double turnBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
    return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

}  // namespace

TipFit fitTip(std::span<const Eigen::Isometry3d> T_base_flange) {
    TipFit fit;
    const auto count = static_cast<Eigen::Index>(T_base_flange.size());
    if (std::any_of(T_base_flange.begin(), T_base_flange.end(),
                    [](const Eigen::Isometry3d& T) { return !T.matrix().allFinite(); })) {
        fit.problem = TipFit::Problem::NotFinite;
        return fit;
    }
    if (count == 0) {
        return fit;
    }
    // R_i tip + p_i = point. Subtracting the mean eliminates the point and keeps the values small.
    Eigen::Matrix3d meanR = Eigen::Matrix3d::Zero();
    Eigen::Vector3d meanP = Eigen::Vector3d::Zero();
    for (const Eigen::Isometry3d& T : T_base_flange) {
        meanR += T.linear() / static_cast<double>(count);
        meanP += T.translation() / static_cast<double>(count);
    }
    Eigen::MatrixXd turns(3 * count, 3);
    Eigen::VectorXd ways(3 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Isometry3d& T = T_base_flange[static_cast<std::size_t>(i)];
        turns.middleRows<3>(3 * i) = T.linear() - meanR;
        ways.segment<3>(3 * i) = meanP - T.translation();
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(turns, Eigen::ComputeThinU | Eigen::ComputeThinV);
    fit.spread = svd.singularValues()[2] / std::sqrt(static_cast<double>(count));
    if (count < kMinTipPoses) {
        return fit;
    }
    if (fit.spread < kMinTipSpread) {
        fit.problem = TipFit::Problem::TooAlike;
        return fit;
    }
    fit.problem = TipFit::Problem::None;
    fit.tip = svd.solve(ways);
    fit.point = meanR * fit.tip + meanP;
    double squares = 0;
    for (const Eigen::Isometry3d& T : T_base_flange) {
        fit.residuals.push_back((T * fit.tip - fit.point).norm());
        squares += fit.residuals.back() * fit.residuals.back();
    }
    fit.rms = std::sqrt(squares / static_cast<double>(count));
    fit.worst = static_cast<int>(std::max_element(fit.residuals.begin(), fit.residuals.end()) -
                                 fit.residuals.begin());
    return fit;
}

Eigen::Matrix3d toolRotation(const Eigen::Matrix3d& R_base_flange, const Eigen::Matrix3d& R_base_tool) {
    return R_base_flange.transpose() * R_base_tool;
}

ToolRotationFit fitToolRotation(const std::array<Eigen::Isometry3d, 3>& T_base_flange) {
    using Problem = ToolRotationFit::Problem;
    ToolRotationFit fit;
    if (std::any_of(T_base_flange.begin(), T_base_flange.end(),
                    [](const Eigen::Isometry3d& T) { return !T.matrix().allFinite(); })) {
        return fit;
    }
    const auto& [first, second, third] = T_base_flange;
    const Eigen::Vector3d toSecond = second.translation() - first.translation();
    const Eigen::Vector3d toThird = third.translation() - first.translation();
    fit.alongZ = toSecond.norm();
    fit.towardsX = toThird.norm();
    const double turned = turnBetween(first, second);
    fit.residual = std::max(turned, turnBetween(first, third));
    fit.worst = fit.residual > turned ? 2 : 1;
    const Eigen::Vector3d z =
        fit.alongZ > 0 ? Eigen::Vector3d(toSecond / fit.alongZ) : Eigen::Vector3d::Zero();
    fit.offLine = z.cross(toThird).norm();
    fit.problem = fit.residual > kMaxAxisTurn     ? Problem::Turned
                  : fit.alongZ < kMinAxisTravel   ? Problem::ZTooClose
                  : fit.towardsX < kMinAxisTravel ? Problem::XTooClose
                  : fit.offLine < kMinAxisOffset  ? Problem::InLine
                                                  : Problem::None;
    if (fit.ok()) {
        const Eigen::Vector3d y = z.cross(toThird).normalized();
        Eigen::Matrix3d R_base_tool;
        R_base_tool << y.cross(z), y, z;
        fit.R_flange_tool = toolRotation(first.linear(), R_base_tool);
    }
    return fit;
}

}  // namespace tiller::kinematics
