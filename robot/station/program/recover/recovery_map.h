// SPDX-License-Identifier: MIT
#pragma once

// Determines from which step a program can continue after a stop, for stops at the beginning of each step and
// at regular intervals. A program continues by running from the step at the top level of the program that
// contains the stop (ScriptOptions::from), with the arm at the start position of that step. The check runs the
// step again in the simulated controller with the outputs and registers that the stop has left, and compares
// outputs, registers, variables, steps and position with those of the undisturbed run. Everything is simulated:
// parts and contacts are unknown, and a waiting input does not change while the program is stopped.

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
    Operator,    ///< as Protective
    LinkLoss,    ///< the program runs for up to kMaxLinkLossTime after the fault, perhaps into later steps
    PowerLoss,   ///< outputs switch off; registers, TCP and payload have the values of a started controller
};
inline constexpr std::array kStopKinds{StopKind::Protective, StopKind::Operator, StopKind::LinkLoss,
                                       StopKind::PowerLoss};
inline constexpr double kMaxLinkLossTime = 0.25;  ///< [s]

/// From good to bad.
enum class Recovery {
    NotReached,  ///< the simulated program has no such stop
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

/// All stops in one step. For each kind of stop, the worst mark.
struct StepRecovery {
    StopMarks marks;
    int from = 0;          ///< number of the step to run after a stop; 0: not reached
    QUuid fromStep;        ///< that step, at the top level of the program
    JointPositions start;  ///< its start position [rad]

    const StopMark& of(StopKind kind) const { return marks[static_cast<std::size_t>(kind)]; }
};

struct RecoveryMap {
    bool isComplete = false;          ///< false if the check was cancelled or the program cannot run
    std::vector<StepRecovery> steps;  ///< step number 1 is at index 0
    std::vector<StopPoint> points;    ///< in chronological order
};

struct RecoveryOptions {
    PreviewOptions preview;  ///< of the simulated program; `answers` are not used
    double interval = 0.1;   ///< time between two stops in a step [s]
};

/// Simulates the program from its beginning. In an endless loop at the top level, the first two iterations are
/// checked, and the program continues at the loop.
/// script   of the complete program, without errors
/// options  of the script
/// Threads  any. Blocks: seconds, and up to a minute if a program has many different states
RecoveryMap checkRecovery(const project::Project& project, const QUuid& program, const ProgramScript& script,
                          const ScriptOptions& scriptOptions = {}, const RecoveryOptions& options = {});

/// The worst mark of the stops without a power loss, e.g. "✔ Continue".
QString recoveryMark(const StepRecovery& recovery);
/// One line for each kind of stop with its mark and the reason.
QString recoveryDetails(const StepRecovery& recovery);
/// Number of steps with a stop, and of those that can continue after each stop without a power loss.
struct RecoveryCount {
    int steps = 0;
    int recoverable = 0;
};
RecoveryCount countRecoverable(const RecoveryMap& map);

QString recoveryText(Recovery recovery);  ///< Translated, e.g. "can continue".
QString stopKindText(StopKind kind);      ///< Translated, e.g. "Protective stop".

}  // namespace tiller::program
