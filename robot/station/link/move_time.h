// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "robot/station/link/robot_session.h"

namespace tiller {

/// Duration of the move from the current arm position at the current speed slider [s].
double moveSeconds(const MoveRequest& request, const SessionState& state);

/// Text for the maximum speed of TCP and elbow in the move at the current speed slider, e.g. "50 mm/s", or
/// for the rotation speed if TCP and elbow hardly move, e.g. "15 °/s". Empty without motion.
QString moveSpeedText(const MoveRequest& request, const SessionState& state);

/// Maximum speed of a hold-to-run motion, as selected next to the jog buttons.
struct HeldSpeed {
    double tcp = std::numeric_limits<double>::infinity();       ///< maximum speed of TCP and elbow [m/s]
    double rotation = std::numeric_limits<double>::infinity();  ///< [rad/s]
    double joint = std::numeric_limits<double>::infinity();     ///< [rad/s]
};

/// Returns the same move, limited to this speed.
MoveRequest slowedTo(const HeldSpeed& speed, MoveRequest request, const SessionState& state);

}  // namespace tiller
