// SPDX-License-Identifier: MIT
#pragma once

// Determines from which step a program can continue after a stop. Checks stops at the beginning of each step
// and at regular intervals. A program continues from the top-level step that contains the stop
// (ScriptOptions::from), with the arm at the start position of that step. The check runs that step again in
// the simulated controller with the outputs and registers that the stop has left. It compares outputs,
// registers, variables, steps and position with those of the uninterrupted run. Workpieces and contacts are
// not simulated, and a waiting input does not change while the program is stopped.

#include <QString>
#include <QUuid>
#include <array>
#include <vector>

#include "robot/core/joints.h"
#include "robot/station/program/preview/preview.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

enum class StopKind {
    Protective,  ///< the arm stops, and the controller keeps outputs and registers
    Operator,    ///< same as Protective, but the brakes do not displace the arm
    LinkLoss,    ///< the program continues for up to kMaxLinkLossTime, possibly into later steps
    PowerLoss,   ///< outputs off; registers, TCP and payload as after a controller start
};
inline constexpr std::array kStopKinds{StopKind::Protective, StopKind::Operator, StopKind::LinkLoss,
                                       StopKind::PowerLoss};
inline constexpr double kMaxLinkLossTime = 0.25;  ///< [s]

/// The possible marks, from best to worst.
enum class Recovery {
    NotReached,  ///< no such stop in the simulated program
    Continue,    ///< the arm is at the start position of the step to run
    MoveBack,    ///< the arm must move to the start position of the step to run
    Unsafe,      ///< the program must not continue
};

struct StopMark {
    Recovery recovery = Recovery::NotReached;
    QString reason;  ///< a translated sentence; empty for Continue and NotReached
};
using StopMarks = std::array<StopMark, kStopKinds.size()>;  ///< index: StopKind

/// A stop in the simulated program.
struct StopPoint {
    double time = 0;  ///< since the start [s]
    int step = 0;     ///< number of the running step, see ProgramScript
    StopMarks marks;
};

/// All stops in one step, with the worst mark for each kind of stop.
struct StepRecovery {
    StopMarks marks;
    int from = 0;          ///< number of the step to run after a stop; 0: not reached
    QUuid fromStep;        ///< ID of step `from`, which is at the top level of the program
    JointPositions start;  ///< start position of step `from` [rad]

    const StopMark& of(StopKind kind) const { return marks[static_cast<std::size_t>(kind)]; }
};

struct RecoveryMap {
    bool isComplete = false;          ///< false if the check was cancelled or the program cannot run
    std::vector<StepRecovery> steps;  ///< step number 1 is at index 0
    std::vector<StopPoint> points;    ///< in chronological order
};

struct RecoveryOptions {
    PreviewOptions preview;  ///< options of the simulated program; `answers` are not used
    double interval = 0.1;   ///< time between two stops in a step [s]
};

/// Simulates the program from its beginning. For an endless loop at the top level, two iterations are
/// checked, and the program continues at the loop.
/// script         script of the complete program, without errors
/// scriptOptions  options of the script
/// Threads        any. Blocks: seconds; up to a minute if a program has many different states
RecoveryMap checkRecovery(const project::Project& project, const QUuid& program, const ProgramScript& script,
                          const ScriptOptions& scriptOptions = {}, const RecoveryOptions& options = {});

/// The worst mark of all stops except power loss, e.g. "✔ Continue".
QString recoveryMark(const StepRecovery& recovery);
/// A heading, and one line for each kind of stop with mark and reason.
QString recoveryDetails(const StepRecovery& recovery);
/// Number of steps with a stop, and number of those that can continue after any stop except power loss.
struct RecoveryCount {
    int steps = 0;
    int recoverable = 0;
};
RecoveryCount countRecoverable(const RecoveryMap& map);

QString recoveryText(Recovery recovery);  ///< Returns the translated text, e.g. "can continue".
QString stopKindText(StopKind kind);      ///< Returns the translated name, e.g. "Protective stop".

}  // namespace tiller::program
