// SPDX-License-Identifier: MIT
#pragma once

// From a waypoint to the bounded move that brings the arm there while a key is held, within the interface's
// own caps.

#include "robot/project/reachability.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

/// from       where the arm stands now
/// tcpOffset  the active one
/// limits     the caps: TCP and elbow never faster than tcpSpeed, no joint faster than jointSpeed
/// Errors     NoSolution, in words an operator can use
Result<MoveRequest> moveRequestFor(const RobotModel& model, const project::Waypoint& waypoint,
                                   const project::FrameList& frames, const JointPositions& from,
                                   const Pose& tcpOffset, const control::MotionLimits& limits);

}  // namespace tiller
