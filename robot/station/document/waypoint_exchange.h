// SPDX-License-Identifier: MIT
#pragma once

// Reads and writes waypoint files: CSV with the columns of the clipboard table, and JSON with all waypoint
// properties and the frames used.

#include <QByteArray>
#include <vector>

#include "robot/station/document/waypoint_clipboard.h"

namespace tiller::waypoint_exchange {

/// Writes UTF-8, comma separated, quoted if necessary (RFC 4180), with one heading line.
QByteArray toCsv(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames);
/// Reads the columns written by toCsv(). The separator is the most frequent of comma, semicolon and tab in
/// the first line.
/// Errors   InvalidArgument with line and column; a file with an error is refused as a whole
Result<std::vector<project::Waypoint>> fromCsv(const QByteArray& bytes, const project::FrameList& frames,
                                               const waypoint_clipboard::Defaults& defaults);

/// Returns a project with only these waypoints and their frames, without histories and pattern links.
Result<QByteArray> toJson(const std::vector<project::Waypoint>& waypoints, const project::FrameList& frames,
                          RobotModelId robot);

struct Imported {
    std::vector<project::Waypoint> waypoints;  ///< imported waypoints, with new IDs
    std::vector<project::Frame> frames;        ///< frames of these waypoints that the project does not have
};
/// If the project has a frame with the same name, that frame is used instead.
/// Errors   as for project::parseProject
Result<Imported> fromJson(const QByteArray& bytes, const project::FrameList& frames);

}  // namespace tiller::waypoint_exchange
