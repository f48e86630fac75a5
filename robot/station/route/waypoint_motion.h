// SPDX-License-Identifier: MIT
#pragma once

// Creates the hold-to-run move to a waypoint, within the speed limits of the user interface.

#include "robot/project/reachability.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

/// from       current position of the arm
/// tcpOffset  offset of the active TCP
/// limits     maximum speeds: tcpSpeed for TCP and elbow, jointSpeed for all joints
/// Errors     NoSolution, as text for the operator
Result<MoveRequest> moveRequestFor(const RobotModel& model, const project::Waypoint& waypoint,
                                   const project::FrameList& frames, const JointPositions& from,
                                   const Pose& tcpOffset, const control::MotionLimits& limits);

}  // namespace tiller
