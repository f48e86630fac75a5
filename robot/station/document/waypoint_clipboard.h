// SPDX-License-Identifier: MIT
#pragma once

// Waypoints as a table of text with tab-separated fields, to exchange with spreadsheets. Lengths in mm,
// angles in degrees, orientations as roll, pitch and yaw.

#include <QString>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/project/waypoint_list.h"

namespace tiller::waypoint_clipboard {

/// One heading line, then one line per waypoint.
QString toText(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames);

/// Values for fields that a line does not contain.
struct Defaults {
    const RobotModel* robot = nullptr;  ///< model for solving poses; null: a UR5e
    JointPositions near;                ///< reference for choosing the nearest solution [rad]
    Pose tcpOffset;
};

/// The heading line is optional. With it, the columns may be in any order, and only the joints or the pose
/// are required. Without it, the text has either all columns in the order of toText(), or the six numbers of
/// a pose, optionally preceded by a name. A pose without joints defines the waypoint, and its joints are the
/// nearest solution; joints without a pose define it likewise. Waypoints get new ids; names are kept, or
/// numbered.
/// Errors   InvalidArgument with line and column; a text with an error is rejected as a whole
Result<std::vector<project::Waypoint>> fromText(const QString& text, const project::FrameList& frames,
                                                const Defaults& defaults = {});

}  // namespace tiller::waypoint_clipboard
