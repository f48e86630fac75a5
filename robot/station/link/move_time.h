// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "robot/station/link/robot_session.h"

namespace tiller {

/// Duration of a move from the position of the arm at the present speed slider [s].
double moveSeconds(const MoveRequest& request, const SessionState& state);

/// Maximum speed of such a move at the present speed slider: of TCP and elbow ("50 mm/s"), or of the rotation if
/// they hardly move ("15 °/s"). Empty if there is no path.
QString moveSpeedText(const MoveRequest& request, const SessionState& state);

/// Maximum speed of a held motion, as chosen next to the jog keys.
struct HeldSpeed {
    double tcp = std::numeric_limits<double>::infinity();       ///< of TCP and elbow [m/s]
    double rotation = std::numeric_limits<double>::infinity();  ///< [rad/s]
    double joint = std::numeric_limits<double>::infinity();     ///< [rad/s]
};

/// The same move, no faster than that.
MoveRequest slowedTo(const HeldSpeed& speed, MoveRequest request, const SessionState& state);

}  // namespace tiller
