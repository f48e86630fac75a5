// SPDX-License-Identifier: MIT
#include "robot/station/program/run/continue_step.h"

#include <algorithm>

#include "robot/station/program/program_edit.h"
#include "robot/station/program/program_text.h"

namespace tiller::program {

Continuation chooseContinuation(const project::Project& project, const ProgramScript& script,
                                const RecoveryMap& map, const ProgramScript& stopped, int step,
                                StopKind kind) {
    if (step < 1 || step > static_cast<int>(stopped.steps.size()) ||
        map.steps.size() != script.steps.size()) {
        return {};
    }
    const NumberedStep& last = stopped.steps[static_cast<std::size_t>(step - 1)];
    const auto found = std::find_if(script.steps.begin(), script.steps.end(), [&](const NumberedStep& each) {
        return each.program == last.program && each.step == last.step;
    });
    if (found == script.steps.end()) {
        return {};
    }
    const StepRecovery& recovery = map.steps[static_cast<std::size_t>(found - script.steps.begin())];
    const StopMark& mark = recovery.of(kind);
    Continuation result;
    result.number = recovery.from;
    switch (mark.recovery) {
        case Recovery::NotReached:
            result.isUnknown = true;
            result.text =
                ProgramText::tr(
                    "The recoverability check did not reach step %1 (%2). Check again with the "
                    "inputs of the run to find out whether the program can continue.")
                    .arg(found - script.steps.begin() + 1)
                    .arg(stepName(project, script, static_cast<int>(found - script.steps.begin()) + 1));
            break;
        case Recovery::Unsafe:
            result.text =
                ProgramText::tr("Simulated: the program cannot continue safely. %1").arg(mark.reason);
            break;
        case Recovery::Continue:
        case Recovery::MoveBack:
            result.start = StartStep{recovery.fromStep, recovery.start};
            result.text = ProgramText::tr("Simulated: the program can continue from step %1 (%2).")
                              .arg(recovery.from)
                              .arg(stepName(project, script, recovery.from));
            break;
    }
    return result;
}

}  // namespace tiller::program
