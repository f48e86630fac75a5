// SPDX-License-Identifier: MIT
#pragma once

// Generates the URScript of a program and reports its problems: generating the script is also the check of
// the program. The script is one self-contained `def`: it can be sent, saved as .script, or run in the
// simulated controller.

#include <vector>

#include "robot/core/robot_model.h"
#include "robot/core/version.h"
#include "robot/project/project_file.h"
#include "robot/station/program/program_problem.h"

namespace tiller::program {

/// Output integer register with the running step: its number, 0 at the end, or the negative number of the
/// failed step if no On error section handled the failure. The control program does not use this register.
inline constexpr int kStepRegister = 47;

/// A step by program and id, as numbered in the step register.
struct NumberedStep {
    QUuid program;
    QUuid step;
};

struct ProgramScript {
    QString name;  ///< name of the `def`
    QString text;  ///< empty when there are errors
    std::vector<NumberedStep>
        steps;  ///< number 1 is at index 0; steps of called programs follow those of the main program
    std::vector<int> stepOfLine;  ///< step number by line, from 0; 0 where a line belongs to no step
    std::optional<Pose> tcp;      ///< required by the waypoints, where the script does not set one
    std::vector<ProgramProblem> problems;

    bool ok() const { return !text.isEmpty(); }  ///< The program can run.
    /// The number of a step of the main program; 0 if it has no step with that id.
    int numberOf(const QUuid& step) const;
    /// The step that a line of the script belongs to; lines count from 1; 0: none.
    int stepAt(int line) const;
};

struct ScriptOptions {
    SoftwareVersion version{5, 22, 0, 0};
    std::optional<RobotModelId> model;  ///< empty: the model of the project, otherwise a UR5e
    QUuid from;  ///< first step to run, at the top level of the program. Null: from the beginning
};

/// Generates the script of a program of the project.
/// Returns  an empty text and the problems if it cannot run, also if the program does not exist
/// Threads  any. Blocks: never (some milliseconds for a thousand steps)
ProgramScript writeScript(const project::Project& project, const QUuid& program,
                          const ScriptOptions& options = {});

}  // namespace tiller::program
