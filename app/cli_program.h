// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the commands about programs share.

#include <QStringList>

#include "robot/core/result.h"
#include "robot/project/project_file.h"
#include "robot/station/program/program_script.h"

namespace tiller::app {

/// A program of a project, and its script.
struct LoadedProgram {
    project::Project project;
    QUuid program;
    program::ScriptOptions options;
    program::ProgramScript script;  ///< see ProgramScript::ok()
};

/// name  of the program; empty: the only one of the project.  fromStep  number of the step to begin at; 0: the first
/// Errors   as project::loadProject(); InvalidArgument: no such program or step, with those there are
Result<LoadedProgram> loadProgram(const QString& path, const QString& name, int fromStep);

/// "step 3 (MoveL): The arm cannot reach ...".
QString problemText(const LoadedProgram& loaded, int step, const QString& text);
/// The name of the step's kind; empty: none has that number.
QString stepName(const LoadedProgram& loaded, int number);

/// Runs a program: simulated, or on a robot.
int run(const QStringList& arguments);
/// A program as URScript.
int script(const QStringList& arguments);

}  // namespace tiller::app
