// SPDX-License-Identifier: MIT
#include "robot/project/reachability.h"

#include <algorithm>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"

namespace tiller::project {
namespace {

bool insideJointRange(const JointPositions& q) {
    return q.values.cwiseAbs().maxCoeff() <= kJointPositionLimit;
}

/// Follows the straight line from `start` to `end` in steps.
/// Returns  the joint positions at the end; empty if a step is unreachable or a joint position would jump
std::optional<JointPositions> followLine(const DhParameters& dh, const Pose& start, const Pose& end,
                                         const Pose& tcpOffset, const JointPositions& from) {
    constexpr double kStepLength = 0.005;  // [m]
    constexpr double kStepAngle = 0.02;    // [rad]
    constexpr double kJump = 0.5;  // [rad] in one step; more indicates another configuration or a singularity
    constexpr int kMaxSteps = 2000;

    const PoseDifference way = poseDifference(start, end);
    const int steps =
        std::clamp(static_cast<int>(std::ceil(std::max(way.distance / kStepLength, way.angle / kStepAngle))),
                   1, kMaxSteps);
    const Eigen::Quaterniond first(rotationMatrix(start.rotation));
    const Eigen::Quaterniond last(rotationMatrix(end.rotation));
    JointPositions q = from;
    for (int i = 1; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        const Pose pose(start.position + part * (end.position - start.position),
                        rotationVector(first.slerp(part, last).toRotationMatrix()));
        const auto next = kinematics::inverseNearest(dh, pose, tcpOffset, q);
        if (!next || (next->values - q.values).cwiseAbs().maxCoeff() > kJump) {
            return std::nullopt;
        }
        q = *next;
    }
    return q;
}

}  // namespace

Reach reach(const RobotModel& model, const Waypoint& waypoint, const FrameList& frames) {
    Reach result;
    if (waypoint.priority == TargetKind::Joints) {
        result.q = waypoint.joints;
        result.obstacle =
            insideJointRange(waypoint.joints) ? Reach::Obstacle::None : Reach::Obstacle::JointLimit;
        return result;
    }
    const std::optional<Pose> pose = poseInBase(waypoint, frames);
    if (!pose) {
        result.obstacle = Reach::Obstacle::FrameMissing;
        return result;
    }
    if (const auto q = kinematics::inverseNearest(model.dh, *pose, waypoint.tcpOffset, waypoint.joints)) {
        result.q = *q;
        result.obstacle = Reach::Obstacle::None;
    }
    return result;
}

MovePreview previewMove(const RobotModel& model, const Waypoint& waypoint, const FrameList& frames,
                        const JointPositions& from, double speedFraction) {
    MovePreview preview;
    preview.reach = reach(model, waypoint, frames);
    if (!preview.reach.ok()) {
        return preview;
    }
    const double fraction = std::clamp(speedFraction, 0.02, 1.0);
    if (waypoint.move == MoveKind::Linear) {
        const Pose start = kinematics::forwardTcp(model.dh, from, waypoint.tcpOffset);
        const Pose end = kinematics::forwardTcp(model.dh, preview.reach.q, waypoint.tcpOffset);
        if (const auto q = followLine(model.dh, start, end, waypoint.tcpOffset, from)) {
            preview.reach.q = *q;
        } else {
            preview.reach.obstacle = Reach::Obstacle::OnTheWay;
        }
        preview.duration = kinematics::moveDuration(poseDifference(start, end).distance,
                                                    waypoint.toolSpeed * fraction, kDefaultToolAcceleration);
    }
    const Vector6 turns = preview.reach.q.values - from.values;
    turns.cwiseAbs().maxCoeff(&preview.largestTurnJoint);
    preview.largestTurn = turns[preview.largestTurnJoint];
    if (waypoint.move == MoveKind::Joint) {
        preview.duration = kinematics::moveDuration(
            std::abs(preview.largestTurn), waypoint.jointSpeed * fraction, kDefaultJointAcceleration);
    }
    return preview;
}

std::optional<Pose> targetForTcp(const Waypoint& waypoint, const FrameList& frames,
                                 const Pose& activeTcpOffset) {
    const std::optional<Pose> pose = poseInBase(waypoint, frames);
    if (!pose || activeTcpOffset == waypoint.tcpOffset) {
        return pose;
    }
    return Pose(pose->transform() * waypoint.tcpOffset.transform().inverse(Eigen::Isometry) *
                activeTcpOffset.transform());
}

}  // namespace tiller::project
