// SPDX-License-Identifier: MIT
#include "robot/station/route/waypoint_motion.h"

#include <algorithm>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"
#include "robot/station/text/reach_words.h"

namespace tiller {

Result<MoveRequest> moveRequestFor(const RobotModel& model, const project::Waypoint& waypoint,
                                   const project::FrameList& frames, const JointPositions& from,
                                   const Pose& tcpOffset, const control::MotionLimits& limits) {
    const project::MovePreview preview = project::previewMove(model, waypoint, frames, from);
    if (!preview.reach.ok()) {
        return Error{ErrorCode::NoSolution, reachAdvice(preview.reach), {}};
    }
    MoveRequest request;
    request.toProject = true;
    request.acceleration = waypoint.acceleration();
    request.q = preview.reach.q;
    if (waypoint.move == project::MoveKind::Joint) {
        request.kind = MoveRequest::Kind::MoveJ;
        request.speed = std::min(
            {waypoint.jointSpeed, limits.jointSpeed,
             kinematics::jointSpeedBound(model.dh, from, preview.reach.q, tcpOffset, limits.tcpSpeed).speed});
        return request;
    }
    request.kind = MoveRequest::Kind::MoveL;
    request.speed = std::min(waypoint.toolSpeed, limits.tcpSpeed);
    request.pose = waypoint.priority == project::TargetKind::Joints
                       ? kinematics::forwardTcp(model.dh, waypoint.joints, tcpOffset)
                       : *project::targetForTcp(waypoint, frames, tcpOffset);
    return request;
}

}  // namespace tiller
