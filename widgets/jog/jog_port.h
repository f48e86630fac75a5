// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The few doors through which the jog column moves the arm, so that it can be tried without a robot.

#include <functional>

#include "robot/control/compliance.h"
#include "widgets/session/robot_session.h"

namespace tiller {

struct JogPort {
    std::function<Result<RobotSession::MotionId>(const control::JogTarget&)> beginJog;
    std::function<Result<RobotSession::MotionId>(const MoveRequest&)> beginMove;
    std::function<bool(RobotSession::MotionId)> hold;
    std::function<void(RobotSession::MotionId, control::StopCause)> endMotion;
    std::function<control::MotionLimits()> limits;
    std::function<Result<RobotSession::MotionId>(const control::Freedrive&)> beginFreedrive = {};
    /// Keeps a jog alive with another target; false once it has been stopped.
    std::function<bool(RobotSession::MotionId, const control::JogTarget&)> holdWith = {};
};

/// The doors of a session, which must outlive the port.
JogPort sessionPort(RobotSession& session);

}  // namespace tiller
