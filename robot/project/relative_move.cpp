// SPDX-License-Identifier: MIT
#include "robot/project/relative_move.h"

#include <QStringList>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller::project {

std::optional<Pose> placeOf(const Waypoint& waypoint, const RobotModel& model, const FrameList& frames) {
    return waypoint.priority == TargetKind::Joints
               ? std::optional(kinematics::forwardTcp(model.dh, waypoint.joints, waypoint.tcpOffset))
               : poseInBase(waypoint, frames);
}

Pose movedPose(const Pose& T_base_tcp, const RelativeMove& move, const Pose& T_base_frame) {
    const bool tool = move.axes == RelativeMove::Axes::Tool;
    const Pose& T_base_axes = tool ? T_base_tcp : T_base_frame;
    const Eigen::Matrix3d R_axes = rotationMatrix(T_base_axes.rotation);
    if (move.kind == RelativeMove::Kind::Offset) {
        Pose moved = T_base_tcp;
        moved.position += R_axes * move.offset;
        return moved;
    }
    const Eigen::Matrix3d R = rotationMatrix(T_base_tcp.rotation);
    const Eigen::Vector3d from = T_base_tcp.position - T_base_axes.position;
    const Eigen::Vector3d axis = R_axes.col(move.axis);
    if (move.kind == RelativeMove::Kind::Turn) {
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(move.angle, axis).toRotationMatrix();
        return Pose(T_base_axes.position + turn * from, rotationVector(turn * R));
    }
    const Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity() - 2 * axis * axis.transpose();
    Eigen::Matrix3d mirrored = mirror * R;
    mirrored.col(0) *= -1;  // restore a right-handed frame
    return Pose(T_base_axes.position + mirror * from, rotationVector(mirrored));
}

Result<std::vector<Waypoint>> movedBy(const std::vector<Waypoint>& waypoints, const RelativeMove& move,
                                      const RobotModel& model, const FrameList& frames) {
    const std::optional<Pose> T_base_frame = frames.pose(move.frame);
    if (!T_base_frame) {
        return Error{ErrorCode::InvalidArgument,
                     QStringLiteral("the frame selected for the move is not in the project"),
                     {}};
    }
    std::vector<Waypoint> result;
    QStringList outOfReach;
    for (const Waypoint& point : waypoints) {
        const std::optional<Pose> place = placeOf(point, model, frames);
        if (!place) {
            return Error{ErrorCode::InvalidArgument,
                         QStringLiteral("the frame of waypoint '%1' is not in the project").arg(point.name),
                         {}};
        }
        const Pose target = movedPose(*place, move, *T_base_frame);
        const auto q = kinematics::inverseNearest(model.dh, target, point.tcpOffset, point.joints);
        if (!q && point.priority == TargetKind::Joints) {
            outOfReach << point.name;
            continue;
        }
        result.push_back(
            taughtAt(point, q.value_or(point.joints), target, point.tcpOffset, frames).value_or(point));
    }
    if (!outOfReach.isEmpty()) {
        return Error{ErrorCode::NoSolution, outOfReach.join(QStringLiteral(", ")), {}};
    }
    return result;
}

}  // namespace tiller::project
