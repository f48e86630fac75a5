// SPDX-License-Identifier: MIT
#include "robot/collision/move_check.h"

#include <algorithm>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"

namespace tiller::collision {
namespace {

constexpr int kJointPlaces = 48;       // number of TCP positions for drawing a joint move
constexpr double kStepLength = 0.005;  // step along a line [m]
constexpr double kStepAngle = 0.02;    // [rad]
constexpr int kMaxMoveSteps = 2000;
constexpr double kJump = 0.5;  // joint change in one step that indicates another configuration [rad]
// Same thresholds as for slowing down a jog.
constexpr double kNearWrist = 0.03;     // |sin q5|
constexpr double kNearElbow = 0.05;     // |sin q3|
constexpr double kNearShoulder = 0.02;  // distance of the wrist centre from axis 1 [m]

MoveLimit::Singular nearSingularity(const DhParameters& dh, const JointPositions& q, double widened) {
    const kinematics::SingularityMeasure measure = kinematics::singularityMeasure(dh, q);
    return measure.wrist < widened * kNearWrist         ? MoveLimit::Singular::Wrist
           : measure.elbow < widened * kNearElbow       ? MoveLimit::Singular::Elbow
           : measure.shoulder < widened * kNearShoulder ? MoveLimit::Singular::Shoulder
                                                        : MoveLimit::Singular::None;
}

/// Index of a joint outside its range, or -1.
int outOfRange(const JointPositions& q) {
    int joint = 0;
    return q.values.cwiseAbs().maxCoeff(&joint) > kJointPositionLimit ? joint : -1;
}

/// Follows the line step by step, and returns where and why the motion ends early.
std::optional<MoveLimit> followLine(const RobotModel& model, const Pose& tcpOffset, const Move& move,
                                    MoveReport& report) {
    const Pose start = kinematics::forwardTcp(model.dh, move.from, tcpOffset);
    const Pose end = kinematics::forwardTcp(model.dh, move.to, tcpOffset);
    const Eigen::Quaterniond first(rotationMatrix(start.rotation));
    const Eigen::Quaterniond last(rotationMatrix(end.rotation));
    const double distance = (end.position - start.position).norm();
    const double angle = first.angularDistance(last);
    const int steps = std::clamp(
        static_cast<int>(std::ceil(std::max(distance / kStepLength, angle / kStepAngle))), 1, kMaxMoveSteps);
    std::optional<MoveLimit> near;
    const bool beginsSingular = nearSingularity(model.dh, move.from, 1) != MoveLimit::Singular::None;
    report.way = {move.from};
    report.places = {start.position};
    for (int i = 1; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const Pose pose(start.position + share * (end.position - start.position),
                        rotationVector(first.slerp(share, last).toRotationMatrix()));
        const JointPositions& before = report.way.back();
        MoveLimit limit;
        limit.share = share;
        limit.tcp = pose;
        const auto next = kinematics::inverseNearest(model.dh, pose, tcpOffset, before);
        if (!next) {
            limit.kind = MoveLimit::Kind::OutOfReach;
            return limit;
        }
        int joint = 0;
        if ((next->values - before.values).cwiseAbs().maxCoeff(&joint) > kJump) {
            // A full turn indicates that the joint would have exceeded its range.
            limit.kind = std::abs(next->values[joint] - before.values[joint]) > 6.0
                             ? MoveLimit::Kind::JointRange
                             : MoveLimit::Kind::Singularity;
            limit.joint = joint;
            limit.singular = nearSingularity(model.dh, before, 20);
            return limit;
        }
        const MoveLimit::Singular singular = nearSingularity(model.dh, *next, 1);
        if (!near && !beginsSingular && singular != MoveLimit::Singular::None) {
            near = limit;
            near->kind = MoveLimit::Kind::NearSingularity;
            near->singular = singular;
        }
        report.way.push_back(*next);
        report.places.push_back(pose.position);
    }
    return near;
}

}  // namespace

std::optional<MoveLimit> collisionOn(const RobotModel& model, const CollisionCheck& check,
                                     const Pose& tcpOffset, std::span<const JointPositions> way) {
    const std::optional<Contact> near = check.obstruction(way);
    if (!near) {
        return std::nullopt;
    }
    MoveLimit limit;
    limit.kind = MoveLimit::Kind::Collision;
    limit.isInside = check.isInside(way.front(), *near);
    // If there is a contact later on the path, it is more informative than the point where the safety
    // distance is violated.
    const std::optional<Contact> contact = limit.isInside ? std::nullopt : check.along(way);
    limit.contact = contact && contact->at > 0 ? *contact : *near;
    limit.safetyDistance = check.safetyDistance();
    const double stretches = static_cast<double>(way.size() - 1);
    limit.share = stretches > 0 ? limit.contact.at / stretches : 0;
    limit.tcp = kinematics::forwardTcp(model.dh, limit.contact.q, tcpOffset);
    return limit;
}

MoveReport examineMove(const RobotModel& model, const CollisionCheck& check, const Pose& tcpOffset,
                       const Move& move, double speedFraction) {
    MoveReport report;
    const double fraction = std::clamp(speedFraction, 0.02, 1.0);
    if (move.linear) {
        report.limit = followLine(model, tcpOffset, move, report);
        report.duration = kinematics::moveDuration(
                              kinematics::lineLength(kinematics::forwardTcp(model.dh, move.from, tcpOffset),
                                                     kinematics::forwardTcp(model.dh, move.to, tcpOffset)),
                              move.speed, move.acceleration) /
                          fraction;
    } else {
        report.way = {move.from, move.to};
        const Vector6 turn = move.to.values - move.from.values;
        for (int i = 0; i <= kJointPlaces; ++i) {
            const double share = static_cast<double>(i) / kJointPlaces;
            report.places.push_back(
                kinematics::forwardTcp(model.dh, JointPositions(move.from.values + share * turn), tcpOffset)
                    .position);
        }
        report.duration =
            kinematics::moveDuration(turn.cwiseAbs().maxCoeff(), move.speed, move.acceleration) / fraction;
        if (const int joint = outOfRange(move.to); joint >= 0) {
            MoveLimit limit;
            limit.kind = MoveLimit::Kind::JointRange;
            limit.joint = joint;
            limit.share = std::clamp(
                (std::copysign(kJointPositionLimit, move.to[joint]) - move.from[joint]) / turn[joint], 0.0,
                1.0);
            limit.tcp = kinematics::forwardTcp(
                model.dh, JointPositions(move.from.values + limit.share * turn), tcpOffset);
            report.limit = limit;
        }
    }
    const Vector6 turns = (move.linear ? report.way.back() : move.to).values - move.from.values;
    turns.cwiseAbs().maxCoeff(&report.largestTurnJoint);
    report.largestTurn = turns[report.largestTurnJoint];

    // `way` ends at the limit of a line. Scale the position, so that `share` refers to the requested move.
    const bool endsBefore = report.limit && report.limit->ends();
    const double followed = move.linear && endsBefore ? report.limit->share : 1.0;
    if (std::optional<MoveLimit> limit = collisionOn(model, check, tcpOffset, report.way)) {
        limit->share *= followed;
        if (!endsBefore || limit->share <= report.limit->share) {
            report.limit = limit;
        }
    }
    return report;
}

}  // namespace tiller::collision
