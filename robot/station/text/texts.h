// SPDX-License-Identifier: MIT
#pragma once

// What codes of the backend say to a person: what happened, why, and what to do now.

#include <QString>

#include "robot/control/control_status.h"
#include "robot/core/error.h"
#include "robot/core/modes.h"

namespace tiller::texts {

/// "The robot at 192.168.0.10:30004 refused the connection. Switch the service on: ..."
QString errorText(const Error& error);
/// "released", "pointer left the key"; for "Jog stopped: ...".
QString stopCauseText(control::StopCause cause);
/// Why the arm cannot be moved in this robot mode, with the next step; empty when it can.
QString robotModeObstacle(RobotMode mode);
/// As above, for a safety mode.
QString safetyModeObstacle(SafetyMode mode);
/// Why no command is sent to the robot in monitor-only mode, with the way out.
QString monitorOnlyObstacle();
/// Why a robot that is in Local cannot be commanded, with the next step.
QString remoteObstacle();
/// Why control is not ours.
QString controlLossText(control::ControlLoss loss);

}  // namespace tiller::texts
