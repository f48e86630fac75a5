// SPDX-License-Identifier: MIT
#pragma once

// Checks a whole project without a robot: whether the arm reaches each waypoint and keeps the safety distance
// at the waypoints, on the paths between them, and along recorded paths. Uses the nominal kinematics of the
// robot model, from which a real calibrated arm deviates by a few millimetres.

#include <QUuid>
#include <vector>

#include "robot/collision/move_check.h"
#include "robot/core/robot_model.h"
#include "robot/project/project_file.h"
#include "robot/project/reachability.h"

namespace tiller {

/// One problem found in a project.
struct ProjectFinding {
    enum class Kind {
        Unreachable,   ///< the arm cannot reach the waypoint: see `reach`
        TooClose,      ///< the waypoint violates the safety distance: see `contact`
        Blocked,       ///< the path from the previous waypoint ends early: see `limit`
        Slow,          ///< the path from the previous waypoint is near a singularity: see `limit`
        RecordedPath,  ///< a recorded path violates the safety distance: see `limit`
        Unplaced,      ///< an object has no known position and is not checked: see `object`
    };
    Kind kind = Kind::Unreachable;
    int row = 0;                 ///< index of the waypoint or the recorded path, from 0; -1 for Unplaced
    project::Reach reach;        ///< for Unreachable
    collision::Contact contact;  ///< for TooClose
    collision::MoveLimit limit;  ///< for Blocked, Slow and RecordedPath
    collision::UnplacedObject object;  ///< for Unplaced

    /// False for findings that only slow down the arm.
    bool isError() const { return kind != Kind::Slow; }
};

/// Returns the findings: first unplaced objects, then those of the waypoints in list order, then those of the
/// recorded paths. Paths between waypoints are those of Run route: in the order of the list, each with the
/// move type, speed and TCP of its waypoint. Paths to and from an unreachable waypoint are not checked.
/// robot    the model that all positions of the project are for
/// Threads  any. Blocks: never. Takes a few milliseconds per waypoint
std::vector<ProjectFinding> checkProject(const project::Project& project, const RobotModel& robot);

}  // namespace tiller
