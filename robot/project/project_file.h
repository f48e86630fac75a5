// SPDX-License-Identifier: MIT
#pragma once

// The project file: waypoints and frames of a cell, its tools, payloads, positions, patterns and recorded
// paths, and the surroundings of the arm, in one JSON file ("cell-7.tiller"). Lengths in metres, angles in
// radians, orientations as rotation vectors, masses in kilograms, times in seconds:
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
// Version 1 had frames and waypoints only. Fields with a question mark are omitted if empty. "format" was
// "tiller-session" in earlier versions; such files can be read, and are converted when saved. Files are
// written atomically. A file that cannot be read completely is never overwritten: saving first renames it.
// Unknown fields are preserved when saving.

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
/// Maximum file size. A project with a thousand waypoints takes about half a megabyte.
inline constexpr qint64 kMaxProjectFileBytes = 64LL * 1024 * 1024;

struct Project {
    std::optional<RobotModelId> robot;  ///< the arm used for teaching
    FrameList frames;
    WaypointList waypoints;
    Tooling tooling;
    Positions positions;
    PatternList patterns;
    CellGeometry cell;
    PathList paths;
    ProgramList programs;
    QJsonObject extra;  ///< unknown fields of the file, preserved when saving
    friend bool operator==(const Project&, const Project&) = default;
};

/// One problem in a file.
struct FileProblem {
    QString where;  ///< e.g. "line 12, column 3", "waypoints[3].joints[2]"
    QString what;   ///< e.g. "is not a number"
    /// Returns the problem as text for users.
    QString toString() const { return where.isEmpty() ? what : where + QStringLiteral(": ") + what; }
};

/// The readable part of a damaged file, with the number of lost entries.
struct RecoveredProject {
    Project document;
    QVector<FileProblem> problems;
    int lostWaypoints = 0;  ///< number of skipped entries
    int lostFrames = 0;
    int lostParts = 0;       ///< tools, payloads, positions, patterns, boxes, planes, paths and programs
    int lostObstacles = 0;   ///< lost boxes and planes; the arm does not avoid them
    QByteArray fingerprint;  ///< fingerprint of the content; empty if not read from a file
};

/// A project and the content from which it was read.
struct OpenedProject {
    Project document;
    QByteArray fingerprint;  ///< fingerprintOf() of the file content
};

/// Identifies the content of a file, to detect changes by other programs.
QByteArray fingerprintOf(const QByteArray& content);

/// Reads the complete file, or returns the first problem. Only regular files of at most kMaxProjectFileBytes
/// are read.
/// Errors   FileNotReadable; FileCorrupt with location and reason; VersionUnsupported for a newer file
/// Threads  any. Blocks: for the file system. Real-time: no
Result<Project> loadProject(const QString& path);
Result<OpenedProject> openProject(const QString& path);  ///< Like loadProject().
Result<Project> parseProject(const QByteArray& bytes);   ///< Like loadProject().

/// Reads all valid entries, even from a truncated file. Never changes the file.
/// Errors   FileNotReadable; FileCorrupt if the file is not a project; VersionUnsupported
Result<RecoveredProject> recoverProject(const QString& path);
Result<RecoveredProject> recoverFromBytes(const QByteArray& bytes);  ///< Like recoverProject().

/// The result of saving.
struct SaveReport {
    QString keptCopy;             ///< e.g. "cell-7.tiller.damaged-1"; empty if there was no damaged file
    QByteArray fingerprint;       ///< fingerprint of the written content
    bool changedByOther = false;  ///< not written: the file has content that this program has not read
};

/// Replaces the file atomically. After a crash, a full disk or a power failure, the old file is intact.
/// known    fingerprints of the contents that may be replaced; without this argument, any content. A missing
///          file is created
/// Errors   InvalidArgument for invalid values (not finite, no name); FileNotWritable, DiskFull
/// Threads  any. Blocks: for the file system. Real-time: no
Result<SaveReport> saveProject(const QString& path, const Project& document,
                               const std::optional<QList<QByteArray>>& known = std::nullopt);
/// Errors   InvalidArgument
/// Threads  any. Blocks: never. Real-time: no
Result<QByteArray> serializeProject(const Project& document);

}  // namespace tiller::project
