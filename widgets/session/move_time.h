// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/session/robot_session.h"

namespace tiller {

/// How long a move from where the arm is now will take, at the speed slider as it stands [s].
double moveSeconds(const MoveRequest& request, const SessionState& state);

}  // namespace tiller
