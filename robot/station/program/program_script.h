// SPDX-License-Identifier: MIT
#pragma once

// A program as URScript, and what is wrong with it: writing the script is what checks the program. The script is one
// `def` without anything from outside: it can be sent, saved as .script, or run in the simulated controller.

#include <vector>

#include "robot/core/robot_model.h"
#include "robot/core/version.h"
#include "robot/project/project_file.h"
#include "robot/station/program/program_problem.h"

namespace tiller::program {

/// Output integer register that shows the running step: its number, 0 at the end, and the negative number of the step
/// that failed where no On error section took over. The control program does not use it.
inline constexpr int kStepRegister = 47;

/// A step by program and id, as numbered in the step register.
struct NumberedStep {
    QUuid program;
    QUuid step;
};

struct ProgramScript {
    QString name;  ///< of the `def`
    QString text;  ///< empty when there are errors
    std::vector<NumberedStep>
        steps;  ///< number 1 is at index 0; those of called programs follow the main program's
    std::vector<int> stepOfLine;  ///< by line, from 0; 0 where a line belongs to no step
    std::optional<Pose> tcp;      ///< that the waypoints need, where the script does not set one
    std::vector<ProgramProblem> problems;

    bool ok() const { return !text.isEmpty(); }  ///< It can run.
    /// The number of a step of the main program; 0 when there is none with that id.
    int numberOf(const QUuid& step) const;
    /// The step that a line of the script belongs to; lines count from 1; 0 where there is none.
    int stepAt(int line) const;
};

struct ScriptOptions {
    SoftwareVersion version{5, 22, 0, 0};
    std::optional<RobotModelId> model;  ///< nothing: the project's, else a UR5e
    QUuid from;  ///< begin at this step; it must be at the top level of the program. Null: at the first
};

/// The script of a program of the project.
/// Returns  an empty text and the problems where it cannot run, also when there is no such program
/// Threads  any. Blocks: never (some milliseconds for a thousand steps)
ProgramScript writeScript(const project::Project& project, const QUuid& program,
                          const ScriptOptions& options = {});

}  // namespace tiller::program
