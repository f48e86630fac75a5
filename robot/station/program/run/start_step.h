// SPDX-License-Identifier: MIT
#pragma once

// A run that begins at a selected step instead of the beginning of the program.

#include <QString>
#include <optional>

#include "robot/station/program/preview/preview.h"

namespace tiller::program {

struct StartStep {
    QUuid step;        ///< ID of the step, at the top level of the program
    JointPositions q;  ///< position of the arm at the beginning of the step [rad]
};

struct StartStepChoice {
    std::optional<StartStep> start;
    QString obstacle;  ///< why the program cannot start at this step, as a sentence; empty if it can
};

/// Determines the arm position at a step from a preview of the complete program.
/// options  those of the preview, without ScriptOptions::from
/// script   script of the preview
/// preview  null: not available
StartStepChoice chooseStartStep(const project::Project& project, const QUuid& program, const QUuid& step,
                                ScriptOptions options, const ProgramScript& script, const Preview* preview);

/// Determines whether a stopped program can continue with its last step from the arm position after the stop,
/// without a check of its recoverability. The program can continue in moves to a target and in waits at the
/// top level.
/// stopped  script of the stopped run, which may begin at a later step
/// step     number of the last step in `stopped`
/// q        arm position after the stop [rad]
/// Returns  no start and no obstacle if the program was stopped in its first step
StartStepChoice chooseStoppedStep(const project::Project& project, const QUuid& program,
                                  ScriptOptions options, const ProgramScript& stopped, int step,
                                  const JointPositions& q);

}  // namespace tiller::program
