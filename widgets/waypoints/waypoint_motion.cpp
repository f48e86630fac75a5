// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_motion.h"

#include <algorithm>
#include <limits>

#include "robot/kinematics/arm_kinematics.h"
#include "widgets/waypoints/waypoint_model.h"

namespace tiller {

double jointSpeedWithin(const RobotModel& model, const JointPositions& from, const JointPositions& to,
                        const Pose& tcpOffset, double tcpSpeed) {
    const Vector6 way = to.values - from.values;
    const double largest = way.cwiseAbs().maxCoeff();
    if (largest < 1e-9) {
        return std::numeric_limits<double>::infinity();
    }
    // Speeds of the points while the joint that turns most turns at 1 rad/s.
    const Vector6 qd = way / largest;
    double fastest = 0;
    constexpr int kSamples = 64;
    for (int i = 0; i <= kSamples; ++i) {
        const JointPositions q(Vector6(from.values + way * (static_cast<double>(i) / kSamples)));
        const Matrix6 J = kinematics::jacobian(model.dh, q, tcpOffset);
        fastest = std::max(fastest, (J.topRows<3>() * qd).norm());
        const auto frames = kinematics::linkFrames(model.dh, q);
        const Eigen::Vector3d elbow = frames[2].translation();
        Eigen::Vector3d v = Eigen::Vector3d::Zero();
        for (int joint = 0; joint < 2; ++joint) {
            const Eigen::Isometry3d& axis = frames[static_cast<std::size_t>(joint)];
            v += axis.linear().col(2).cross(elbow - axis.translation()) * qd[joint];
        }
        fastest = std::max(fastest, v.norm());
    }
    return fastest < 1e-9 ? std::numeric_limits<double>::infinity() : tcpSpeed / fastest;
}

Result<MoveRequest> moveRequestFor(const RobotModel& model, const program::Waypoint& waypoint,
                                   const program::FrameList& frames, const JointPositions& from,
                                   const Pose& tcpOffset, const control::MotionLimits& limits) {
    const program::MovePreview preview = program::previewMove(model, waypoint, frames, from);
    if (!preview.reach.ok()) {
        return Error{ErrorCode::NoSolution, WaypointModel::reachAdvice(preview.reach), {}};
    }
    MoveRequest request;
    request.acceleration = waypoint.acceleration();
    request.q = preview.reach.q;
    if (waypoint.move == program::MoveKind::Joint) {
        request.kind = MoveRequest::Kind::MoveJ;
        request.speed =
            std::min({waypoint.jointSpeed, limits.jointSpeed,
                      jointSpeedWithin(model, from, preview.reach.q, tcpOffset, limits.tcpSpeed)});
        return request;
    }
    request.kind = MoveRequest::Kind::MoveL;
    request.speed = std::min(waypoint.toolSpeed, limits.tcpSpeed);
    request.pose = waypoint.ruling == program::Ruling::Joints
                       ? kinematics::forwardTcp(model.dh, waypoint.joints, tcpOffset)
                       : *program::targetForTcp(waypoint, frames, tcpOffset);
    return request;
}

}  // namespace tiller
