// SPDX-License-Identifier: MIT
#pragma once

// Texts for the error codes of the backend: the event, its cause and the suggested action.

#include <QString>

#include "robot/control/control_status.h"
#include "robot/core/error.h"
#include "robot/core/modes.h"

namespace tiller::texts {

/// Example: "Connection refused: 192.168.0.10:30004. Enable the interface on the robot under ...".
QString errorText(const Error& error);
/// Text for messages about a stop, e.g. "button or key released", "pointer left the button".
QString stopCauseText(control::StopCause cause);
/// Why a stop was not measured, e.g. "not measured: another program moves the arm".
QString unmeasuredText(control::UnmeasuredStop::Reason reason);
/// Why the arm cannot be moved in this robot mode, with the suggested action; empty if it can.
QString robotModeObstacle(RobotMode mode);
/// Like robotModeObstacle(), for a safety mode.
QString safetyModeObstacle(SafetyMode mode);
/// Why no command is sent to the robot in monitor-only mode, with the suggested action.
QString monitorOnlyObstacle();
/// Why a robot in Local control accepts no commands, with the suggested action.
QString remoteObstacle();
/// Why Tiller is not in control of the robot.
QString controlLossText(control::ControlLoss loss);

}  // namespace tiller::texts
