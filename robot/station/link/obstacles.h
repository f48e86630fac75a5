// SPDX-License-Identifier: MIT
#pragma once

// The reason why the robot cannot do something in its present state, as a sentence that ends with the suggested
// action.

#include <QString>

#include "robot/station/link/session_state.h"

namespace tiller {

/// The reason given by the session, or one derived from link and modes; empty exactly if state.canMove().
QString cannotMoveReason(const SessionState& state);

/// The stop cause to use when the arm can no longer be moved.
control::StopCause stopCauseFor(const SessionState& state);

/// The reason why this robot accepts no commands for power, recovery and programs over the network; empty if
/// it does.
QString serviceObstacle(const SessionState& state);
/// The same for one command, because some robots do not support all of them.
QString serviceObstacle(const SessionState& state, dashboard::RobotCommand command);

}  // namespace tiller
