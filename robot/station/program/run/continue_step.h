// SPDX-License-Identifier: MIT
#pragma once

// The step at which a stopped program continues, according to the recoverability check.

#include <QString>
#include <optional>

#include "robot/station/program/recover/recovery_map.h"
#include "robot/station/program/run/start_step.h"

namespace tiller::program {

struct Continuation {
    std::optional<StartStep> start;  ///< empty: the program must not continue, or the result is unknown
    int number = 0;                  ///< number of this step in the complete script
    bool isUnknown = false;          ///< the check did not reach the step
    QString text;                    ///< sentences with the mark and its reason; empty if unknown
};

/// script   script of the check
/// stopped  script of the stopped run, which may begin at a later step
/// step     number of the last step in `stopped`
Continuation chooseContinuation(const project::Project& project, const ProgramScript& script,
                                const RecoveryMap& map, const ProgramScript& stopped, int step,
                                StopKind kind);

}  // namespace tiller::program
