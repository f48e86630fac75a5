// SPDX-License-Identifier: MIT
#pragma once

// Whether the arm can get to a waypoint, where its joints would then be, and how long the way takes.

#include <optional>

#include "robot/core/robot_model.h"
#include "robot/project/waypoint_list.h"

namespace tiller::project {

struct Reach {
    enum class Obstacle {
        None,
        OutOfReach,    ///< no joint positions give that pose
        JointLimit,    ///< a joint would have to leave its range
        FrameMissing,  ///< its frame is not in the project
        OnTheWay,      ///< start and end can be reached, the straight line between them cannot
        OtherModel,    ///< taught with another robot model: see model_change.h. reach() does not return it
    };
    Obstacle obstacle = Obstacle::OutOfReach;
    JointPositions q;  ///< target; valid for None and OnTheWay

    bool ok() const { return obstacle == Obstacle::None; }  ///< It can be reached.
};

/// The target of a waypoint. A pose is solved nearest to the joints it was taught with.
/// Threads  any. Blocks: never
Reach reach(const RobotModel& model, const Waypoint& waypoint, const FrameList& frames);

/// What a move from here would be, to be shown before it is made.
struct MovePreview {
    Reach reach;
    int largestTurnJoint = 0;  ///< 0 ... 5
    double largestTurn = 0;    ///< [rad], with sign
    double duration = 0;       ///< [s] at `speedFraction`
};

/// speedFraction  speed slider, 0 < fraction <= 1
/// A MoveL is followed in steps along its line; `reach` says OnTheWay when a step cannot be reached or a
/// joint would jump.
MovePreview previewMove(const RobotModel& model, const Waypoint& waypoint, const FrameList& frames,
                        const JointPositions& from, double speedFraction = 1.0);

/// TCP pose in the base frame that brings the flange to where the waypoint wants it, when another TCP than
/// the waypoint's own is active.
std::optional<Pose> targetForTcp(const Waypoint& waypoint, const FrameList& frames,
                                 const Pose& activeTcpOffset);

}  // namespace tiller::project
