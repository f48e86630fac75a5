// SPDX-License-Identifier: MIT
#pragma once

// A path of joint, linear, process and circular moves with blends. It is sent to the robot as script text,
// and the controller computes the blends.

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
    std::optional<Target> via;  ///< MoveC: intermediate point of the arc (orientation ignored)
    double speed = 0;           ///< MoveJ [rad/s], others [m/s]; > 0
    double acceleration = 0;    ///< MoveJ [rad/s2], others [m/s2]; > 0
    double blend = 0;           ///< blend radius at the target [m]; the last entry uses 0
    bool fixedToArc = false;    ///< MoveC: constant orientation relative to the arc
};

using MotionPath = std::vector<PathEntry>;

/// Errors  InvalidArgument, LimitExceeded; the message contains the entry number (from 1) and the argument
Result<void> checkPath(const MotionPath& path);
/// URScript text, one move per line, with full-precision numbers.
QString pathMove(const PathEntry& entry);

}  // namespace tiller::control
