// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Waypoints as a table of text, fields separated by tabs: into a spreadsheet and back. Lengths in mm, angles
// in degrees, orientations as roll, pitch and yaw.

#include <QString>
#include <vector>

#include "robot/core/result.h"
#include "robot/project/waypoint_list.h"

namespace tiller::waypoint_clipboard {

/// One heading line and one line for each.
QString toText(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames);

/// With or without the heading line; with it, the columns may come in any order and optional ones may be
/// missing. New ids; names as they stand.
/// Errors   InvalidArgument naming line and column; nothing of a text with an error is used
Result<std::vector<project::Waypoint>> fromText(const QString& text, const project::FrameList& frames);

}  // namespace tiller::waypoint_clipboard
