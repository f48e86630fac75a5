// SPDX-License-Identifier: MIT
#include "robot/station/program/run/start_step.h"

#include "robot/station/program/program_text.h"

namespace tiller::program {

StartStepChoice chooseStartStep(const project::Project& project, const QUuid& program, const QUuid& step,
                                ScriptOptions options, const ProgramScript& script, const Preview* preview) {
    options.from = step;
    const ProgramScript rest = writeScript(project, program, options);
    if (!rest.ok()) {
        return {{}, rest.problems.empty() ? QString() : rest.problems.front().text};
    }
    if (preview == nullptr || preview->path.empty()) {
        return {{}, ProgramText::tr("Preview the program first.")};
    }
    const int number = script.numberOf(step);
    const StepTiming timing = number > 0 && number <= static_cast<int>(preview->startJoints.size())
                                  ? preview->timings[static_cast<std::size_t>(number - 1)]
                                  : StepTiming();
    if (timing.count == 0) {
        return {{}, ProgramText::tr("The preview does not reach this step. Select a different step.")};
    }
    return {StartStep{step, preview->startJoints[static_cast<std::size_t>(number - 1)]}, {}};
}

}  // namespace tiller::program
