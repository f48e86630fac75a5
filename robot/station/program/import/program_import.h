// SPDX-License-Identifier: MIT
#pragma once

// Imports programs of the teach pendant (.urp, .urpx) and URScript (.script) as steps. The import works on
// the URScript that runs on the robot: for .urp files, the translation of the nodes by
// robot/simulator/pendant. A statement becomes a step if the step generates an equivalent statement. All
// other statements become URScript text, in the same order.

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <functional>
#include <optional>
#include <vector>

#include "robot/core/result.h"
#include "robot/project/project_file.h"

namespace tiller::program {

inline constexpr qint64 kMaxImportedBytes = 16LL * 1024 * 1024;

struct ImportSource {
    QString file;         ///< name of the program file with its suffix, without a folder
    QByteArray content;   ///< content of the file
    QString programName;  ///< name of the new program; empty: the name of the file without its suffix
    /// Content of another file in the folder of the program, e.g. its installation. Empty if it does not
    /// exist.
    std::function<std::optional<QByteArray>(const QString& name)> files;
};

/// The result for one node of the teach pendant program, or one statement of the script.
struct ImportRow {
    enum class Result {
        Step,     ///< a step of kind `kind`
        Text,     ///< a URScript step; `reason` explains why
        Merged,   ///< part of another item; see `reason`
        Omitted,  ///< not imported, because it has no effect in the program; see `reason`
    };
    int line = 0;  ///< line in the program tree (.urp), or in the file; 0: none
    QString name;  ///< text in the program tree, or the statement
    Result result = Result::Step;
    QString kind;    ///< StepKind::id
    QUuid step;      ///< the step; null if the row is not one step
    QString reason;  ///< translated
    bool disabled = false;
};

struct ImportedProgram {
    project::Project project;  ///< project with the new waypoints, payloads and programs
    QUuid program;             ///< the main program
    int waypoints = 0;         ///< number of new waypoints
    int programs = 0;          ///< number of new programs, including subprograms
    std::vector<ImportRow> rows;
    QStringList notes;  ///< translated: conditions under which the program behaves like the original
    int count(ImportRow::Result result) const;  ///< Number of rows with this result.
};

/// Reads a program file. File names in a program are paths on the robot, so `files` of the result finds only
/// files in the folder of the program.
/// Errors   those of readWholeFile()
/// Threads  any. Blocks: for the file system
Result<ImportSource> readImportSource(const QString& path);

/// The translated result of a row, e.g. "MoveL" or "URScript (no step generates this statement)".
QString resultText(const ImportRow& row);

/// Adds a program to a copy of the project.
/// Errors   InvalidArgument: the project already has a program with this name; FileCorrupt, with file, line
///          and reason: the file is damaged, unfinished, or contains a node that cannot be translated
/// Threads  any. Blocks: never (a few seconds for a thousand steps)
Result<ImportedProgram> importProgram(const project::Project& project, const ImportSource& source);

}  // namespace tiller::program
