// SPDX-License-Identifier: MIT
#pragma once

// Waypoints in files of their own: CSV, with the columns of the clipboard's table, and JSON, with all there is to say of
// them and the frames they are given in.

#include <QByteArray>
#include <vector>

#include "robot/station/document/waypoint_clipboard.h"

namespace tiller::waypoint_exchange {

/// UTF-8, comma separated, quoted where it is needed (RFC 4180), one heading line.
QByteArray toCsv(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames);
/// Separated by commas, semicolons or tabs, whichever the first line has most of.
/// Errors   InvalidArgument naming line and column; nothing of a file with an error is used
Result<std::vector<project::Waypoint>> fromCsv(const QByteArray& bytes, const project::FrameList& frames,
                                               const waypoint_clipboard::Defaults& defaults);

/// A project with these waypoints and their frames only; without histories and places in patterns.
Result<QByteArray> toJson(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames,
                          RobotModelId robot);

struct Imported {
    std::vector<project::Waypoint> waypoints;  ///< with new ids
    std::vector<project::Frame> frames;        ///< those they need that the project does not have yet
};
/// A frame that the project has by name is taken as it stands in the project.
/// Errors   as project::parseProject
Result<Imported> fromJson(const QByteArray& bytes, const project::FrameList& frames);

}  // namespace tiller::waypoint_exchange
