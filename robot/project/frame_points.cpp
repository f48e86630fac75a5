// SPDX-License-Identifier: MIT
#include "robot/project/frame_points.h"

namespace tiller::project {
namespace {

bool isFinite(const std::optional<Eigen::Vector3d>& point) {
    return !point || point->allFinite();
}

}  // namespace

FramePointsCheck check(const FramePoints& points) {
    using Problem = FramePointsCheck::Problem;
    FramePointsCheck found;
    if (!isFinite(points.origin) || !isFinite(points.onX) || !isFinite(points.towardsY)) {
        found.problem = Problem::NotFinite;
        return found;
    }
    if (points.origin && points.onX) {
        found.alongX = (*points.onX - *points.origin).norm();
    }
    if (points.origin && points.towardsY) {
        found.towardsY = (*points.towardsY - *points.origin).norm();
    }
    const bool complete = points.origin && points.onX && points.towardsY;
    if (complete && found.alongX > 0) {
        const Eigen::Vector3d x = (*points.onX - *points.origin) / found.alongX;
        found.offLine = x.cross(*points.towardsY - *points.origin).norm();
    }
    if (points.origin && points.onX && found.alongX < kMinFrameArm) {
        found.problem = Problem::XTooClose;
    } else if (points.origin && points.towardsY && found.towardsY < kMinFrameArm) {
        found.problem = Problem::YTooClose;
    } else if (complete) {
        found.problem = found.offLine < kMinFrameOffset ? Problem::InLine : Problem::None;
    }
    return found;
}

std::optional<Pose> frameThrough(const FramePoints& points) {
    if (!check(points).ok()) {
        return std::nullopt;
    }
    const Eigen::Vector3d x = (*points.onX - *points.origin).normalized();
    const Eigen::Vector3d z = x.cross(*points.towardsY - *points.origin).normalized();
    Eigen::Isometry3d T_base_frame = Eigen::Isometry3d::Identity();
    T_base_frame.linear() << x, z.cross(x), z;
    T_base_frame.translation() = *points.origin;
    return Pose(T_base_frame);
}

}  // namespace tiller::project
