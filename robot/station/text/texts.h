// SPDX-License-Identifier: MIT
#pragma once

// Texts for error codes of the backend: event, cause and suggested action.

#include <QString>

#include "robot/control/control_status.h"
#include "robot/core/error.h"
#include "robot/core/modes.h"

namespace tiller::texts {

/// "Connection refused: 192.168.0.10:30004. Enable the interface on the robot: ..."
QString errorText(const Error& error);
/// "released", "pointer left the button"; for messages about a stop.
QString stopCauseText(control::StopCause cause);
/// The reason why the arm cannot be moved in this robot mode, with the suggested action; empty if it can.
QString robotModeObstacle(RobotMode mode);
/// As above, for a safety mode.
QString safetyModeObstacle(SafetyMode mode);
/// The reason why no command is sent to the robot in monitor-only mode, with the solution.
QString monitorOnlyObstacle();
/// The reason why a robot in Local control accepts no commands, with the suggested action.
QString remoteObstacle();
/// The reason why the robot is not under control.
QString controlLossText(control::ControlLoss loss);

}  // namespace tiller::texts
