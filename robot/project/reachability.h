// SPDX-License-Identifier: MIT
#pragma once

// Determines whether the arm can reach a waypoint, the joint positions at the waypoint, and the duration of
// the move.

#include <optional>

#include "robot/core/robot_model.h"
#include "robot/project/waypoint_list.h"

namespace tiller::project {

struct Reach {
    enum class Obstacle {
        None,
        OutOfReach,    ///< no joint positions exist for this pose
        JointLimit,    ///< a joint would exceed its range
        FrameMissing,  ///< the frame is not in the project
        OnTheWay,      ///< start and end are reachable, but not the line between them
        OtherModel,    ///< taught with another robot model: see model_change.h. Not returned by reach()
    };
    Obstacle obstacle = Obstacle::OutOfReach;
    JointPositions q;  ///< target; valid for None and OnTheWay

    bool ok() const { return obstacle == Obstacle::None; }  ///< True if the target is reachable.
};

/// Computes the target of a waypoint. For a pose target, returns the solution nearest to the taught joint
/// positions.
/// Threads  any. Blocks: never
Reach reach(const RobotModel& model, const Waypoint& waypoint, const FrameList& frames);

/// Preview of a move from the current position.
struct MovePreview {
    Reach reach;
    int largestTurnJoint = 0;  ///< 0 ... 5
    double largestTurn = 0;    ///< [rad], with sign
    double duration = 0;       ///< [s] at `speedFraction`
};

/// A MoveL is checked in steps along its line. `reach` is OnTheWay if a step is unreachable or a joint
/// position would jump.
/// speedFraction  speed slider, 0 < fraction <= 1
MovePreview previewMove(const RobotModel& model, const Waypoint& waypoint, const FrameList& frames,
                        const JointPositions& from, double speedFraction = 1.0);

/// TCP pose in the base frame at which the flange has the waypoint's flange pose, if the active TCP is not
/// that of the waypoint.
std::optional<Pose> targetForTcp(const Waypoint& waypoint, const FrameList& frames,
                                 const Pose& activeTcpOffset);

}  // namespace tiller::project
