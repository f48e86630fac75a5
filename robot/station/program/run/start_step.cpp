// SPDX-License-Identifier: MIT
#include "robot/station/program/run/start_step.h"

#include <algorithm>
#include <array>

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

StartStepChoice chooseStoppedStep(const project::Project& project, const QUuid& program,
                                  ScriptOptions options, const ProgramScript& stopped, int step,
                                  const JointPositions& q) {
    // Running these steps again after a stop in the middle has the same result as completing them.
    static constexpr std::array kRepeatable{"moveJ", "moveL", "wait", "waitInput", "waitCondition"};
    const project::Program* owner = project.programs.find(program);
    if (owner == nullptr || step < 1 || step > static_cast<int>(stopped.steps.size())) {
        return {};
    }
    const NumberedStep& last = stopped.steps[static_cast<std::size_t>(step - 1)];
    const auto isEnabled = [](const project::ProgramStep& each) {
        return !each.disabled && each.kind != QLatin1String("comment");
    };
    const auto found = std::find_if(owner->steps.begin(), owner->steps.end(),
                                    [&](const auto& each) { return each.id == last.step; });
    if (last.program != program || found == owner->steps.end()) {
        return {{},
                ProgramText::tr("A program cannot continue inside a section or a called program. The next "
                                "run starts from the beginning.")};
    }
    if (found == std::find_if(owner->steps.begin(), owner->steps.end(), isEnabled)) {
        return {};
    }
    if (std::none_of(kRepeatable.begin(), kRepeatable.end(),
                     [&](const char* kind) { return found->kind == QLatin1String(kind); })) {
        return {{},
                ProgramText::tr("A program cannot continue in the middle of this step. The next run starts "
                                "from the beginning.")};
    }
    options.from = last.step;
    const ProgramScript rest = writeScript(project, program, options);
    if (!rest.ok()) {
        return {{}, rest.problems.empty() ? QString() : rest.problems.front().text};
    }
    return {StartStep{last.step, q}, {}};
}

}  // namespace tiller::program
