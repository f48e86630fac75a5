// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Why the arm cannot be moved, in a sentence that ends with what to do.

#include <QString>

#include "widgets/session/session_state.h"

namespace tiller {

/// The session's own reason, or one made from link and modes; empty exactly when state.canMove().
QString cannotMoveReason(const SessionState& state);

/// What ends a motion when the arm can no longer be moved.
control::StopCause stopCauseFor(const SessionState& state);

}  // namespace tiller
