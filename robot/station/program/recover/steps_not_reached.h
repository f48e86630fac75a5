// SPDX-License-Identifier: MIT
#pragma once

// The steps that a simulated run did not reach.

#include <QString>
#include <vector>

#include "robot/project/project_file.h"
#include "robot/station/program/preview/preview.h"
#include "robot/station/program/program_script.h"
#include "robot/station/program/recover/recovery_map.h"

namespace tiller::program {

/// The step with this number in a script; null if it was deleted.
const project::ProgramStep* numberedStep(const project::Project& project, const NumberedStep& at);

/// Numbers of the steps that the preview did not run, e.g. because they are in another branch. These steps
/// may contain faster and longer moves, and their problems are unknown. Empty if none of them moves the arm
/// or takes time.
/// script  script of the preview
std::vector<int> stepsNotRun(const project::Project& project, const ProgramScript& script,
                             const Preview& preview);

/// Numbers of the steps that the recoverability check did not reach.
/// script  script of the check
std::vector<int> stepsNotChecked(const project::Project& project, const ProgramScript& script,
                                 const RecoveryMap& map);

struct UncheckedStep {
    int number = 0;
    QString reason;  ///< not translated
};
/// All steps without a mark, with the reasons.
/// script  script of the check
std::vector<UncheckedStep> uncheckedSteps(const project::Project& project, const ProgramScript& script,
                                          const RecoveryMap& map);

/// A list of step numbers, e.g. "step 2" or "steps 5 to 9, 12".
QString stepNumbersText(const std::vector<int>& numbers);

}  // namespace tiller::program
