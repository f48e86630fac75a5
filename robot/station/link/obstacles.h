// SPDX-License-Identifier: MIT
#pragma once

// Why the robot cannot perform an action in its current state, as sentences that end with the suggested
// action.

#include <QString>

#include "robot/station/link/session_state.h"

namespace tiller {

/// The reason reported by the session, or a reason derived from connection and modes. Empty only if
/// state.canMove().
QString cannotMoveReason(const SessionState& state);

/// Why the current position of the arm is unknown; empty if it is known.
QString dataObstacle(const SessionState& state);
/// Why the current position cannot be stored now; empty if it can. Storing is refused while the arm moves,
/// because the operator does not know the position at the time of the press.
QString storeObstacle(const SessionState& state);

/// The cause to report when the arm can no longer be moved.
control::StopCause stopCauseFor(const SessionState& state);

/// Why this robot accepts no commands for power, recovery and programs over the network; empty if it does.
QString serviceObstacle(const SessionState& state);
/// Like serviceObstacle() above, but for one command, because some robots do not support all commands.
QString serviceObstacle(const SessionState& state, dashboard::RobotCommand command);

}  // namespace tiller
