// SPDX-License-Identifier: MIT
#pragma once

// A project that was taught with one robot model and is to be used with another one. The same joints bring another arm
// to another place, so one of the two has to be kept and the other computed again: the Cartesian places, or the joints.

#include <QStringList>

#include "robot/project/project_file.h"

namespace tiller::project {

/// True when the same joints bring both arms to the same place.
bool isSameGeometry(RobotModelId a, RobotModelId b);

/// True when the project has anything that is tied to an arm: waypoints, positions, patterns or paths.
bool hasTaughtPlaces(const Project& project);

/// True when the project has places that were taught with an arm of another geometry. False where the file does not
/// name its arm.
bool isOfOtherModel(const Project& project, RobotModelId connected);

enum class Keep {
    Poses,   ///< joints are recomputed by inverse kinematics, nearest to those there were
    Joints,  ///< poses are recomputed by forward kinematics
};

struct ModelChange {
    Project project;  ///< for the new arm; Project::robot names it
    /// Names of waypoints that the new arm cannot reach. They keep their pose, which rules from now on, so that they
    /// stay marked as out of reach.
    QStringList unreachable;
    /// Names of positions and paths that the new arm cannot reach. They have joints only, which would bring it
    /// somewhere else, so they are left out.
    QStringList removed;
};

/// The project for another arm. Frames, tools, payloads and the cell stay as they are.
/// from     with which it was taught
/// to       the one to use it with, with its own calibration where that is known
/// Threads  any. Blocks: never. Real-time: no (some ten microseconds per waypoint and point of a path)
ModelChange changeModel(const Project& project, const RobotModel& from, const RobotModel& to, Keep keep);

}  // namespace tiller::project
