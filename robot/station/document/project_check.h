// SPDX-License-Identifier: MIT
#pragma once

// Checks a whole project without a robot: whether the arm reaches each waypoint and keeps the safety distance
// at the waypoints, on the paths between them, and along recorded paths. The check uses the nominal
// kinematics of the robot model, from which a calibrated arm deviates by a few millimetres.

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
        Unreachable,   ///< unreachable waypoint: see `reach`
        TooClose,      ///< waypoint closer than the safety distance: see `contact`
        Blocked,       ///< the path from the previous waypoint ends early: see `limit`
        Slow,          ///< the path from the previous waypoint is near a singularity: see `limit`
        RecordedPath,  ///< a recorded path violates the safety distance: see `limit`
        Unplaced,      ///< object without a known position, not checked: see `object`
    };
    Kind kind = Kind::Unreachable;
    int row = 0;                       ///< index of the waypoint or recorded path, from 0; -1 for Unplaced
    project::Reach reach;              ///< valid for Unreachable
    collision::Contact contact;        ///< valid for TooClose
    collision::MoveLimit limit;        ///< valid for Blocked, Slow and RecordedPath
    collision::UnplacedObject object;  ///< valid for Unplaced

    /// False for findings that only slow the arm down.
    bool isError() const { return kind != Kind::Slow; }
};

/// Returns the findings: unplaced objects, then waypoints in list order, then recorded paths. Paths between
/// waypoints are those of Run route: in list order, each with the move type, speed and TCP of its waypoint.
/// Paths to and from an unreachable waypoint are not checked.
/// robot    the robot model of all positions in the project
/// Threads  any. Blocks: never. Takes a few milliseconds per waypoint
std::vector<ProjectFinding> checkProject(const project::Project& project, const RobotModel& robot);

}  // namespace tiller
