// SPDX-License-Identifier: MIT
#pragma once

// The interface through which all panels move the arm. It allows a panel to be tested without a robot.
// HoldMotion (hold_motion.h) describes the motion of a held button.

#include <cstdint>
#include <functional>
#include <vector>

#include "robot/control/compliance.h"
#include "robot/control/motion.h"
#include "robot/control/motion_path.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

struct MotionPort {
    using Id = RobotSession::MotionId;

    std::function<Result<Id>(const control::JogTarget&)> beginJog = {};
    std::function<Result<Id>(const MoveRequest&)> beginMove;
    /// Keeps a motion active. Returns false if the motion has been stopped or has reached its target.
    std::function<bool(Id)> hold;
    std::function<void(Id, control::StopCause)> endMotion;
    std::function<control::MotionLimits()> limits;
    std::function<Result<Id>(const control::Freedrive&)> beginFreedrive = {};
    /// Keeps a jog active with a new target. Returns false if the jog has been stopped.
    std::function<bool(Id, const control::JogTarget&)> holdWith = {};
    /// Like RobotSession::beginPath().
    std::function<Result<Id>(std::vector<control::PathEntry>, std::uint64_t stops)> beginPath = {};
    std::function<std::uint64_t()> stops = {};
    std::function<Result<control::MotionProgress>(Id)> progress = {};
    std::function<Result<void>(std::span<const MoveRequest>)> permits = {};
    std::function<Result<void>(std::span<const JointPositions>)> permitsPath = {};
};

/// Returns the port of a session. The session must outlive the port.
MotionPort motionPort(RobotSession& session);

}  // namespace tiller
