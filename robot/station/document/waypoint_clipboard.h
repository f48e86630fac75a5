// SPDX-License-Identifier: MIT
#pragma once

// Converts waypoints to and from tab-separated text, for exchange with spreadsheets. Lengths in mm, angles in
// degrees, orientations as roll, pitch and yaw.

#include <QString>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/project/waypoint_list.h"

namespace tiller::waypoint_clipboard {

/// Returns one heading line, then one line per waypoint.
QString toText(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames);

/// Values for fields that are missing in a line.
struct Defaults {
    const RobotModel* robot = nullptr;  ///< model for solving poses; null: a UR5e
    JointPositions near;                ///< the solution nearest to these positions is selected [rad]
    Pose tcpOffset;
};

/// The heading line is optional. With a heading line, the columns may be in any order, and only the joints or
/// the pose are required. Without it, the text has either all columns in the order of toText(), or the six
/// numbers of a pose, optionally preceded by a name. Missing joints are computed from the pose as the nearest
/// solution, and a missing pose from the joints. Waypoints get new IDs. Names may be empty or already exist
/// in the project.
/// Errors   InvalidArgument with line and column; a text with an error is refused as a whole
Result<std::vector<project::Waypoint>> fromText(const QString& text, const project::FrameList& frames,
                                                const Defaults& defaults = {});

}  // namespace tiller::waypoint_clipboard
