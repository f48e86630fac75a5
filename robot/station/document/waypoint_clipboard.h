// SPDX-License-Identifier: MIT
#pragma once

// Waypoints as a table of text, fields separated by tabs: into a spreadsheet and back. Lengths in mm, angles
// in degrees, orientations as roll, pitch and yaw.

#include <QString>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/project/waypoint_list.h"

namespace tiller::waypoint_clipboard {

/// One heading line and one line for each.
QString toText(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames);

/// What a line gets that does not say it.
struct Defaults {
    const RobotModel* robot = nullptr;  ///< whose joints a pose is solved for; null: a UR5e
    JointPositions near;                ///< of the solutions, the nearest to these is taken [rad]
    Pose tcpOffset;
};

/// With or without the heading line; with it, the columns may come in any order, and only the joints or the pose
/// must be among them. Without it: all columns in the order they are written in, or the six figures of a pose, with a
/// name before them or not. A pose without joints rules, and its joints are the nearest that get there; joints
/// without a pose rule. New ids; names as they stand, or numbered.
/// Errors   InvalidArgument naming line and column; nothing of a text with an error is used
Result<std::vector<project::Waypoint>> fromText(const QString& text, const project::FrameList& frames,
                                                const Defaults& defaults = {});

}  // namespace tiller::waypoint_clipboard
