// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Functions shared by the commands for programs.

#include <QStringList>
#include <vector>

#include "robot/core/result.h"
#include "robot/project/project_file.h"
#include "robot/station/program/program_script.h"

namespace tiller::app {

/// A program of a project and its generated script.
struct LoadedProgram {
    project::Project project;
    QUuid program;
    program::ScriptOptions options;
    program::ProgramScript script;  ///< may contain problems; see ProgramScript::ok()
};

/// Sets a variable before the step with this number.
struct NumberedAssignment {
    QString variable;
    QString value;
    int step = 0;
};

/// name         name of the program; if empty, the only program of the project
/// fromStep     number of the first step to run; 0 for the first step of the program
/// assignments  for ScriptOptions::assignments
/// Errors       those of project::loadProject(); InvalidArgument with the existing names or numbers if the
/// program or the step does not exist
Result<LoadedProgram> loadProgram(const QString& path, const QString& name, int fromStep,
                                  const std::vector<NumberedAssignment>& assignments = {});

/// Formats a problem with a step, e.g. "step 3 (MoveL): The arm cannot reach ...".
QString problemText(const LoadedProgram& loaded, int step, const QString& text);
/// Returns the type of this step; empty if no step has this number.
QString stepName(const LoadedProgram& loaded, int number);

}  // namespace tiller::app
