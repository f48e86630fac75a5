// SPDX-License-Identifier: MIT
#pragma once

// Converts a project that was taught with one robot model to another model. The same joint positions result
// in different TCP poses, so either the poses or the joint positions are kept and the others are recomputed.

#include <QStringList>

#include "robot/project/project_file.h"

namespace tiller::project {

/// True if the same joint positions result in the same poses with both models.
bool isSameGeometry(RobotModelId a, RobotModelId b);

/// True if the project contains data that depend on the arm: waypoints, positions, patterns or paths.
bool hasTaughtPlaces(const Project& project);

/// True if the project was taught with an arm of different geometry. False if the file does not contain the
/// model.
bool isOfOtherModel(const Project& project, RobotModelId connected);

enum class Keep {
    Poses,  ///< keep poses; inverse kinematics selects the joint positions nearest to the old joint positions
    Joints,  ///< keep joint positions; poses are recomputed by forward kinematics
};

struct ModelChange {
    Project project;  ///< the converted project; Project::robot is the new model
    /// Names of waypoints that the new arm cannot reach. They keep their pose as the target, so that they are
    /// still marked as unreachable.
    QStringList unreachable;
    /// Names of positions and paths that the new arm cannot reach. They are removed, because they contain
    /// only joint positions, which would result in different poses.
    QStringList removed;
};

/// Converts a project to another arm. Frames, tools, payloads and the cell do not change.
/// from     arm used for teaching
/// to       arm to be used, with its calibration if known
/// Threads  any. Blocks: never. Real-time: no (tens of microseconds per waypoint and path point)
ModelChange changeModel(const Project& project, const RobotModel& from, const RobotModel& to, Keep keep);

}  // namespace tiller::project
