// SPDX-License-Identifier: MIT
#pragma once

// A path of many moves, joint, linear, process and circular, blended into each other. Sent to the robot as
// script text, so that blends are the controller's own.

#include <QString>
#include <optional>
#include <variant>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/result.h"
#include "robot/core/spatial.h"
#include "robot/core/version.h"

namespace tiller::control {

struct PathEntry {
    enum class Kind : std::uint8_t { MoveJ, MoveL, MoveP, MoveC };
    using Target = std::variant<JointPositions, Pose>;  ///< [rad], or pose in the base frame [m, rad]

    Kind kind = Kind::MoveJ;
    Target target;
    std::optional<Target> via;  ///< MoveC: the point the arc goes through (only its position counts)
    double speed = 0;           ///< MoveJ [rad/s], others [m/s]; 0 < speed
    double acceleration = 0;    ///< MoveJ [rad/s2], others [m/s2]; 0 < acceleration
    double blend = 0;           ///< radius around the target [m]; the last entry's is taken as 0
    bool fixedToArc = false;    ///< MoveC: the orientation stays fixed to the arc
};

using MotionPath = std::vector<PathEntry>;

/// Errors  InvalidArgument, LimitExceeded; the message names the entry (counted from 1) and the argument
Result<void> checkPath(const MotionPath& path);
/// One move a line, with numbers that lose nothing.
QString pathMove(const PathEntry& entry);

}  // namespace tiller::control
