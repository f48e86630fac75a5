// SPDX-License-Identifier: MIT
#pragma once

// What an operator keeps between two days: the waypoints and frames of a cell, its tools, payloads, positions,
// patterns and recorded paths, and what stands around the arm, in one JSON file ("cell-7.tiller"). Lengths in
// metres, angles in radians, orientations as rotation vectors, masses in kilograms, times in seconds:
//
//   { "format": "tiller-project", "version": 2, "robot": "UR5e",
//     "frames":    [ { "id", "name", "pose": [x, y, z, rx, ry, rz] } ],
//     "waypoints": [ { "id", "name", "move": "J"|"L", "rules": "joints"|"pose", "frame": null|id,
//                      "tcpOffset": [6], "joints": [6], "pose": [6],
//                      "jointSpeed", "toolSpeed", "blend",
//                      "group"?, "colour"?, "note"?, "actions"?: [ { "do", "group", "pin", "value", "seconds" } ],
//                      "place"?: { "pattern": id, "column", "row", "layer" },
//                      "history"?: [ { "at", "who", "what", "before": { ... } } ] } ],
//     "tools"?:     [ { "id", "name", "tcpOffset": [6], "radius"?, "note"? } ],  "activeTool"?: id,
//     "payloads"?:  [ { "id", "name", "mass", "centre": [3], "inertia"?: [6], "note"? } ], "activePayload"?: id,
//     "positions"?: [ { "id", "name", "joints": [6], "note"? } ],  "home"?: id,
//     "safeHeight"?: { "frame": null|id, "height" },
//     "patterns"?:  [ { "id", "name", "first": { a waypoint }, "columnEnd": [3], "rowEnd": [3],
//                       "columns", "rows", "layers", "layerStep", "order": "rows"|"meander",
//                       "excluded"?: [ { "column", "row" } ], "corners"?: [null|id, null|id, null|id], "note"? } ],
//     "cell"?:      { "floor"?: height, "boxes"?: [ { "id", "name", "frame", "pose": [6], "size": [3],
//                                                              "enabled"?: false } ],
//                     "planes"?: [ { "id", "name", "frame", "pose": [6], "enabled"?: false } ],
//                     "safetyDistance"?: 0.01 },
//     "paths"?:     [ { "id", "name", "tcpOffset": [6], "tolerance", "points": [ { "t", "q": [6] } ], "note"? } ],
//     "programs"?:  [ { "id", "name", "parameters"?: [name], "steps"?: [ a step ], "note"? } ] }
// and a step of a program is { "id", "do": kind, "disabled"?: true, "steps"?: [ a step ], and the fields of its kind }.
//
// Version 1 had frames and waypoints only; what has a question mark is left out where there is nothing to say.
// "format" was "tiller-session" before: such files are read alike, and get the new name when they are saved.
// A file is never half written, and one that cannot be read completely is never written over: saving on top
// of it first puts it aside. Fields this version does not know are kept and saved again.

#include <QByteArray>
#include <QJsonObject>
#include <QList>
#include <QString>
#include <QVector>
#include <optional>

#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/project/cell_geometry.h"
#include "robot/project/named_position.h"
#include "robot/project/pattern.h"
#include "robot/project/program.h"
#include "robot/project/recorded_path.h"
#include "robot/project/tooling.h"
#include "robot/project/waypoint_list.h"

namespace tiller::project {

inline constexpr int kProjectFileVersion = 2;
/// Larger files are not read: a project of a thousand waypoints takes half a megabyte.
inline constexpr qint64 kMaxProjectFileBytes = 64LL * 1024 * 1024;

struct Project {
    std::optional<RobotModelId> robot;  ///< the arm it was taught with
    FrameList frames;
    WaypointList waypoints;
    Tooling tooling;
    Positions positions;
    PatternList patterns;
    CellGeometry cell;
    PathList paths;
    ProgramList programs;
    QJsonObject extra;  ///< fields of the file that this version does not know
    friend bool operator==(const Project&, const Project&) = default;
};

/// One thing that is wrong with a file.
struct FileProblem {
    QString where;  ///< "line 12, column 3", "waypoints[3].joints[2]"
    QString what;   ///< "is not a number"
    /// For people.
    QString toString() const { return where.isEmpty() ? what : where + QStringLiteral(": ") + what; }
};

/// What could be read of a damaged file, and what could not.
struct RecoveredProject {
    Project document;
    QVector<FileProblem> problems;
    int lostWaypoints = 0;  ///< entries that were left out
    int lostFrames = 0;
    int lostParts = 0;       ///< tools, payloads, positions, patterns, boxes, planes, paths and programs
    QByteArray fingerprint;  ///< of the file's content; empty when it was not read from a file
};

/// A project and the content it was read from.
struct OpenedProject {
    Project document;
    QByteArray fingerprint;  ///< as fingerprintOf() of the file's content
};

/// Identifies the content of a file, to see later whether another program has changed it.
QByteArray fingerprintOf(const QByteArray& content);

/// Everything of the file, or the first thing that is wrong with it.
/// Errors   FileNotReadable; FileCorrupt with place and reason; VersionUnsupported for a newer file
/// Threads  any. Blocks: for the file system. Real-time: no
/// Only regular files of at most kMaxProjectFileBytes are read.
Result<Project> loadProject(const QString& path);
Result<OpenedProject> openProject(const QString& path);  ///< As loadProject().
Result<Project> parseProject(const QByteArray& bytes);   ///< As loadProject().

/// As much of the file as makes sense: every waypoint that is whole, also from a file cut off in the middle.
/// Never touches the file.
/// Errors   FileNotReadable; FileCorrupt when it is not a project at all; VersionUnsupported
Result<RecoveredProject> recoverProject(const QString& path);
Result<RecoveredProject> recoverFromBytes(const QByteArray& bytes);  ///< As recoverProject().

/// What saving did.
struct SaveReport {
    QString keptCopy;             ///< "cell-7.tiller.damaged-1"; empty if no damaged file was there
    QByteArray fingerprint;       ///< of the content written
    bool changedByOther = false;  ///< nothing was written: the file holds something this program has not read
};

/// Writes a new file and replaces the old one in one step: a crash, a full disk or a power failure leaves the old one
/// as it was.
/// known    fingerprints of the contents that may be replaced; without it, any content. A missing file is created.
/// Errors   InvalidArgument for values no file may hold (not finite, no name); FileNotWritable, DiskFull
/// Threads  any. Blocks: for the file system. Real-time: no
Result<SaveReport> saveProject(const QString& path, const Project& document,
                               const std::optional<QList<QByteArray>>& known = std::nullopt);
/// Errors   InvalidArgument
/// Threads  any. Blocks: never. Real-time: no
Result<QByteArray> serializeProject(const Project& document);

}  // namespace tiller::project
