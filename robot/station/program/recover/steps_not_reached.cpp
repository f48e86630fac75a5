// SPDX-License-Identifier: MIT
#include "robot/station/program/recover/steps_not_reached.h"

#include <QSet>
#include <algorithm>
#include <functional>

#include "robot/station/program/program_edit.h"
#include "robot/station/program/program_text.h"
#include "robot/station/program/step_kind.h"

namespace tiller::program {

const project::ProgramStep* numberedStep(const project::Project& project, const NumberedStep& at) {
    const project::Program* program = project.programs.find(at.program);
    return program != nullptr ? findStep(program->steps, at.step) : nullptr;
}

namespace {

/// Collects the steps in parallel watches. They cannot move the arm, and previews do not count them.
void collectWatched(const Steps& steps, bool isWatched, QSet<QUuid>& watched) {
    for (const project::ProgramStep& step : steps) {
        if (isWatched) {
            watched.insert(step.id);
        }
        collectWatched(step.steps, isWatched || step.kind == QLatin1String("watch"), watched);
    }
}

/// True for steps that may move the arm or take time. Sections take as long as their steps.
bool mayMatter(const project::ProgramStep* step) {
    const StepKind* kind = step != nullptr ? findStepKind(step->kind) : nullptr;
    return kind == nullptr || kind->id == QLatin1String("script") ||
           (!kind->isSection && (kind->moves || kind->takesTime));
}

/// Numbers of the steps for which `isReached` is false, except comments, parallel watches and sections with a
/// reached step. Steps before the first step of the run have no lines, and are skipped too.
std::vector<int> stepsNotReached(const project::Project& project, const ProgramScript& script,
                                 const std::function<bool(std::size_t)>& isReached) {
    QSet<QUuid> watched;
    for (const project::Program& program : project.programs) {
        collectWatched(program.steps, false, watched);
    }
    QSet<QUuid> reached;
    for (std::size_t i = 0; i < script.steps.size(); ++i) {
        if (isReached(i)) {
            reached.insert(script.steps[i].step);
        }
    }
    const std::function<bool(const project::ProgramStep&)> hasReached =
        [&](const project::ProgramStep& step) {
            return reached.contains(step.id) || std::ranges::any_of(step.steps, hasReached);
        };
    std::vector<int> numbers;
    for (int number = 1; number <= static_cast<int>(script.steps.size()); ++number) {
        const NumberedStep& at = script.steps[static_cast<std::size_t>(number - 1)];
        const bool hasLines = std::ranges::find(script.stepOfLine, number) != script.stepOfLine.end();
        const project::ProgramStep* step = numberedStep(project, at);
        if (hasLines && step != nullptr && step->kind != QLatin1String("comment") &&
            step->kind != QLatin1String("watch") && !watched.contains(at.step) && !hasReached(*step)) {
            numbers.push_back(number);
        }
    }
    return numbers;
}

}  // namespace

std::vector<int> stepsNotRun(const project::Project& project, const ProgramScript& script,
                             const Preview& preview) {
    const std::vector<int> numbers = stepsNotReached(project, script, [&](std::size_t i) {
        return i < preview.timings.size() && preview.timings[i].count > 0;
    });
    const bool matter = std::ranges::any_of(numbers, [&](int number) {
        return mayMatter(numberedStep(project, script.steps[static_cast<std::size_t>(number - 1)]));
    });
    return matter ? numbers : std::vector<int>();
}

std::vector<int> stepsNotChecked(const project::Project& project, const ProgramScript& script,
                                 const RecoveryMap& map) {
    return stepsNotReached(project, script,
                           [&](std::size_t i) { return i < map.steps.size() && map.steps[i].from > 0; });
}

std::vector<UncheckedStep> uncheckedSteps(const project::Project& project, const ProgramScript& script,
                                          const RecoveryMap& map) {
    QSet<QUuid> watched;
    for (const project::Program& program : project.programs) {
        collectWatched(program.steps, false, watched);
    }
    std::vector<UncheckedStep> unchecked;
    for (int number = 1; number <= static_cast<int>(script.steps.size()); ++number) {
        const auto index = static_cast<std::size_t>(number - 1);
        if (index < map.steps.size() && map.steps[index].from > 0) {
            continue;
        }
        const NumberedStep& at = script.steps[index];
        const project::ProgramStep* step = numberedStep(project, at);
        const bool hasLines = std::ranges::find(script.stepOfLine, number) != script.stepOfLine.end();
        const bool isComment = step != nullptr && step->kind == QLatin1String("comment");
        unchecked.push_back(
            {number, isComment                   ? QStringLiteral("comments have no effect")
                     : watched.contains(at.step) ? QStringLiteral("runs in parallel with other steps")
                     : !hasLines
                         ? QStringLiteral("the step is disabled")
                         : QStringLiteral("the simulated program did not reach this step, or ended in it")});
    }
    return unchecked;
}

QString stepNumbersText(const std::vector<int>& numbers) {
    QStringList parts;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) {
            ++last;
        }
        parts << (last == i ? QString::number(numbers[i])
                            : ProgramText::tr("%1 to %2", "step numbers").arg(numbers[i]).arg(numbers[last]));
        i = last + 1;
    }
    const QString list = parts.join(QStringLiteral(", "));
    return numbers.size() == 1 ? ProgramText::tr("step %1").arg(list) : ProgramText::tr("steps %1").arg(list);
}

}  // namespace tiller::program
