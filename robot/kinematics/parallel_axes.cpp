// SPDX-License-Identifier: MIT
#include "robot/kinematics/parallel_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller::kinematics {
namespace {

constexpr int kUpperArm = 1;
constexpr int kForearm = 2;

double turnedBack(double angle) {
    return std::remainder(angle, 2 * std::numbers::pi);
}

bool isFinite(const DhParameters& dh) {
    const auto finite = [](const std::array<double, 6>& values) {
        return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
    };
    return finite(dh.a) && finite(dh.d) && finite(dh.alpha) && finite(dh.theta) && finite(dh.beta);
}

/// The parameters of one link.
struct Link {
    double theta = 0;
    double d = 0;
    double a = 0;
    double alpha = 0;
    double beta = 0;
};

/// Replaces the parameters of a link with equivalent parameters that have the same end axis. The parameters
/// of the next joint compensate for the shift and rotation of the frame along this axis.
void replace(DhParameters& dh, int joint, const Link& with) {
    const auto i = static_cast<std::size_t>(joint);
    const Eigen::Isometry3d before = linkTransform(dh, joint, 0);
    dh.theta[i] = with.theta;
    dh.d[i] = with.d;
    dh.a[i] = with.a;
    dh.alpha[i] = with.alpha;
    dh.beta[i] = with.beta;
    const Eigen::Isometry3d moved = linkTransform(dh, joint, 0).inverse() * before;
    dh.d[i + 1] += moved.translation().z();
    dh.theta[i + 1] = turnedBack(dh.theta[i + 1] + std::atan2(moved(1, 0), moved(0, 0)));
}

/// Places the frame at the intersection of the next axis with the XY plane of the current frame.
/// Returns  false if the axes are far from parallel, or identical
bool toHayati(DhParameters& dh, int joint) {
    constexpr double kParallel = 0.9;   // cosine
    constexpr double kShortest = 1e-3;  // [m]
    const Eigen::Isometry3d T = linkTransform(dh, joint, 0);
    const Eigen::Vector3d axis = T.linear().col(2);
    if (std::abs(axis.z()) < kParallel) {
        return false;
    }
    const Eigen::Vector3d met = T.translation() - axis * (T.translation().z() / axis.z());
    Link found;
    found.a = -met.norm();  // both links point along -x in all models
    if (found.a > -kShortest) {
        return false;
    }
    found.theta = std::atan2(-met.y(), -met.x());
    const Eigen::Vector3d seen = Eigen::AngleAxisd(-found.theta, Eigen::Vector3d::UnitZ()) * axis;
    found.beta = std::asin(std::clamp(seen.x(), -1.0, 1.0));
    found.alpha = std::atan2(-seen.y(), seen.z());
    replace(dh, joint, found);
    return true;
}

/// Places the frame at the foot of the common normal. Parallel axes have no unique normal, so their frames
/// remain unchanged.
void toDenavitHartenberg(DhParameters& dh, int joint) {
    const Eigen::Isometry3d T = linkTransform(dh, joint, 0);
    const Eigen::Vector3d axis = T.linear().col(2);
    const Eigen::Vector3d across = Eigen::Vector3d::UnitZ().cross(axis);
    const double sine = across.norm();
    if (dh.beta[static_cast<std::size_t>(joint)] == 0 || sine == 0) {
        return;
    }
    const Eigen::Vector3d normal = across / sine;
    const Eigen::Vector3d lateral = Eigen::Vector3d::UnitZ().cross(normal);
    const double along = -T.translation().dot(lateral) / axis.dot(lateral);
    replace(dh, joint,
            {std::atan2(normal.y(), normal.x()), T.translation().z() + along * axis.z(),
             T.translation().dot(normal), std::atan2(sine, axis.z()), 0});
}

}  // namespace

DhParameters resolveParallelAxes(const DhParameters& reported) {
    DhParameters dh = reported;
    if (!isFinite(reported) || !toHayati(dh, kUpperArm) || !toHayati(dh, kForearm)) {
        return reported;
    }
    return dh;
}

DhParameters asDenavitHartenberg(const DhParameters& arm) {
    DhParameters dh = arm;
    toDenavitHartenberg(dh, kUpperArm);
    toDenavitHartenberg(dh, kForearm);
    return dh;
}

DhParameters calibrated(const RobotModel& model, const DhParameters& reported) {
    constexpr double kLongest = 3;      // [m]
    constexpr double kShortest = 0.05;  // [m], for upper arm and forearm
    const DhParameters arm = resolveParallelAxes(reported);
    const auto isOfAnArm = [](const std::array<double, 6>& lengths) {
        return std::ranges::all_of(lengths, [](double length) { return std::abs(length) < kLongest; });
    };
    const bool reaches = arm.a[kUpperArm] < -kShortest && arm.a[kForearm] < -kShortest;
    return isFinite(arm) && reaches && isOfAnArm(arm.a) && isOfAnArm(arm.d) ? arm : model.dh;
}

}  // namespace tiller::kinematics
