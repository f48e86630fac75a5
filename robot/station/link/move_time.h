// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "robot/station/link/robot_session.h"

namespace tiller {

/// How long a move from where the arm is now will take, at the speed slider as it stands [s].
double moveSeconds(const MoveRequest& request, const SessionState& state);

/// The highest speed of such a move, at the speed slider as it stands: of TCP and elbow ("50 mm/s"), or of the
/// turn where they hardly move ("15 °/s"). Empty where there is no way to go.
QString moveSpeedText(const MoveRequest& request, const SessionState& state);

/// The fastest that a held motion may be, as the operator chose it beside the jog keys.
struct HeldSpeed {
    double tcp = std::numeric_limits<double>::infinity();       ///< of TCP and elbow [m/s]
    double rotation = std::numeric_limits<double>::infinity();  ///< [rad/s]
    double joint = std::numeric_limits<double>::infinity();     ///< [rad/s]
};

/// The same move, no faster than that.
MoveRequest slowedTo(const HeldSpeed& speed, MoveRequest request, const SessionState& state);

}  // namespace tiller
