// SPDX-License-Identifier: MIT
#pragma once

// Determines whether the arm can reach a waypoint, the joint positions there, and the duration of the move.

#include <optional>

#include "robot/core/robot_model.h"
#include "robot/project/waypoint_list.h"

namespace tiller::project {

struct Reach {
    enum class Obstacle {
        None,
        OutOfReach,    ///< no joint positions lead to this pose
        JointLimit,    ///< a joint would exceed its range
        FrameMissing,  ///< the frame is not in the project
        OnTheWay,      ///< start and end are reachable, but not the straight line between them
        OtherModel,    ///< taught with another robot model: see model_change.h. Not returned by reach()
    };
    Obstacle obstacle = Obstacle::OutOfReach;
    JointPositions q;  ///< target; valid for None and OnTheWay

    bool ok() const { return obstacle == Obstacle::None; }  ///< True if the target is reachable.
};

/// The target of a waypoint. A pose is solved nearest to the taught joint positions.
/// Threads  any. Blocks: never
Reach reach(const RobotModel& model, const Waypoint& waypoint, const FrameList& frames);

/// Preview of a move from the current position.
struct MovePreview {
    Reach reach;
    int largestTurnJoint = 0;  ///< 0 ... 5
    double largestTurn = 0;    ///< [rad], with sign
    double duration = 0;       ///< [s] at `speedFraction`
};

/// speedFraction  speed slider, 0 < fraction <= 1
/// A MoveL is followed in steps along its line; `reach` is OnTheWay if a step is unreachable or a joint would jump.
MovePreview previewMove(const RobotModel& model, const Waypoint& waypoint, const FrameList& frames,
                        const JointPositions& from, double speedFraction = 1.0);

/// TCP pose in the base frame for which the flange reaches the waypoint's flange pose, if a TCP other than the
/// waypoint's is active.
std::optional<Pose> targetForTcp(const Waypoint& waypoint, const FrameList& frames,
                                 const Pose& activeTcpOffset);

}  // namespace tiller::project
