// SPDX-License-Identifier: MIT
#pragma once

// Generates the URScript of a program and reports its problems. Generating the script also checks the
// program. The script is one self-contained `def` that can be sent, saved as .script, or run in the simulated
// controller.

#include <QSet>
#include <QStringList>
#include <QUuid>
#include <limits>
#include <vector>

#include "robot/core/robot_model.h"
#include "robot/core/version.h"
#include "robot/project/project_file.h"
#include "robot/script/step_gate.h"
#include "robot/station/program/program_problem.h"

namespace tiller::program {

/// Output integer register with the number of the running step. It is 0 at the end, or the negated number of
/// the failed step if no On error section handled the failure.
inline constexpr int kStepRegister = script::kStepRegister;

/// A step, identified by program and step ID, as numbered in the step register.
struct NumberedStep {
    QUuid program;
    QUuid step;
};

struct ProgramScript {
    QString name;  ///< name of the `def`
    QString text;  ///< empty if there are errors
    std::vector<NumberedStep>
        steps;  ///< step 1 is at index 0; steps of called programs follow those of the main program
    std::vector<int> stepOfLine;  ///< step number by line index; 0: the line belongs to no step
    /// A line that differs in a run with a step gate.
    struct GateLine {
        std::size_t line = 0;  ///< index
        QString text;
        int step = 0;  ///< number of the step that begins in this line; 0: none
    };
    std::vector<GateLine> gateLines;
    std::vector<int> cycles;  ///< step numbers of the outermost endless loops
    std::optional<Pose> tcp;  ///< TCP required by the waypoints if the script does not set one
    /// Variables whose values can be changed while the program waits at a step gate. Empty if changesMayMove.
    std::vector<script::GateVariable> variables;
    QStringList declared;  ///< names of all variables that the steps set
    /// The program contains URScript text in a thread or in a parallel watch, which could move the arm after
    /// a change of a variable while the program waits.
    bool changesMayMove = false;
    std::vector<ProgramProblem> problems;

    bool ok() const { return !text.isEmpty(); }  ///< True if the program can run.
    /// The text with the calls of script::stepGateScript(). The lines have the same numbers as in `text`.
    /// breakpoints  steps before which the program pauses; those without a gate line are ignored
    QString gatedText(const QSet<QUuid>& breakpoints = {}) const;
    /// True if the program can pause before this step. No program can pause in a force section or a parallel
    /// watch.
    bool canPauseBefore(const QUuid& step) const;
    /// Number of a step of the main program; 0 if there is no step with this id.
    int numberOf(const QUuid& step) const;
    /// Number of the step to which a script line belongs, or 0. Lines count from 1.
    int stepAt(int line) const;
};

/// Maximum speeds of the moves of a script. URScript text of the user is not limited.
struct SpeedLimits {
    double tool = std::numeric_limits<double>::infinity();   ///< limit of linear and circular moves [m/s]
    double joint = std::numeric_limits<double>::infinity();  ///< limit of joint moves [rad/s]
};

/// Sets a variable each time a step begins.
struct StepAssignment {
    QUuid step;  ///< a step before which the program can pause, see ProgramScript::canPauseBefore()
    QString variable;
    QString value;  ///< as typed, see typedValue()
};

struct ScriptOptions {
    SoftwareVersion version{5, 22, 0, 0};
    std::optional<RobotModelId> model;  ///< empty: the model of the project; without a model, a UR5e
    /// First step to run, at the top level of the program; null: run from the beginning. A problem is
    /// reported if earlier steps set a variable or the payload for this or a later step, or start a parallel
    /// watch.
    QUuid from;
    SpeedLimits limits = {};
    /// Assignments for ProgramScript::variables. A problem is reported if one is not possible.
    std::vector<StepAssignment> assignments = {};
};

/// Generates the script of a program of the project. If the program cannot run or does not exist, returns an
/// empty text and the problems.
/// Threads  any. Blocks: never (a few milliseconds for a thousand steps)
ProgramScript writeScript(const project::Project& project, const QUuid& program,
                          const ScriptOptions& options = {});

}  // namespace tiller::program
