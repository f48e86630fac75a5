// SPDX-License-Identifier: MIT
#pragma once

// Random valid and invalid programs without moves, for tests.

#include <QRandomGenerator>
#include <functional>

#include "program_samples.h"

namespace tiller::program {

/// Generates programs from a fixed seed. All of them terminate.
class RandomSteps {
public:
    RandomSteps(quint32 seed, const project::Program& helper) : random_(seed), helper_(helper) {}

    project::Program program() {
        std::vector<project::ProgramStep> steps{
            step("assign", {{"variable", "n"}, {"type", "whole"}, {"value", "0"}})};
        const auto rest = list(0, false, false);
        steps.insert(steps.end(), rest.begin(), rest.end());
        return makeProgram("random", steps);
    }

    int below(int limit) { return static_cast<int>(random_.bounded(limit)); }

private:
    std::vector<project::ProgramStep> list(int depth, bool inLoop, bool inTry) {
        std::vector<project::ProgramStep> steps;
        const int count = 1 + below(4);
        for (int i = 0; i < count; ++i) {
            for (project::ProgramStep& made : group(depth, inLoop, inTry)) {
                steps.push_back(std::move(made));
            }
        }
        return steps;
    }

    QString condition() {
        static const QStringList all{"DI0",        "not DI0",      "n > 2",
                                     "n % 2 == 0", "DI1 or n < 4", "n == 1 and DI0"};
        return all[below(static_cast<int>(all.size()))];
    }

    /// One step, or a group of related steps.
    std::vector<project::ProgramStep> group(int depth, bool inLoop, bool inTry) {
        const int kinds = depth < 3 ? 14 : 7;
        switch (below(kinds)) {
            case 0:
                return {step("wait", {{"time", 0.002 + 0.002 * below(3)}})};
            case 1:
                return {step("setOutput", {{"output", below(18)}, {"value", below(2) == 1}})};
            case 2:
                return {step("assign", {{"variable", "n"}, {"type", "whole"}, {"value", "n + 1"}})};
            case 3:
                return {step("comment", {{"text", "a remark"}}),
                        step("call", {{"program", idText(helper_.id)}, {"arguments", "n"}})};
            case 4: {
                project::ProgramStep off = step("moveJ");
                off.disabled = true;
                return {off};
            }
            case 5:
                if (inLoop) {
                    return {step("if", {{"condition", condition()}}, {step("leaveLoop")})};
                }
                return {step("log", {{"text", "here"}, {"value", "n"}})};
            case 6:
                if (inTry) {
                    return {
                        step("if", {{"condition", condition()}}, {step("fail", {{"text", "on purpose"}})})};
                }
                return {step("waitInput", {{"input", 1},
                                           {"value", below(2) == 1},
                                           {"timeLimit", 0.01},
                                           {"otherwise", "continue"}})};
            case 7:
                return {step("loop", {{"times", 1 + below(3)}}, list(depth + 1, true, inTry))};
            case 8:
                return {step("if", {{"condition", condition()}}, list(depth + 1, inLoop, inTry))};
            case 9:
                return {step("if", {{"condition", condition()}}, list(depth + 1, inLoop, inTry)),
                        step("elseIf", {{"condition", condition()}}, list(depth + 1, inLoop, inTry)),
                        step("else", {}, list(depth + 1, inLoop, inTry))};
            case 10:
                return {step("switch", {{"value", "n"}},
                             {step("case", {{"value", "1"}}, list(depth + 1, inLoop, inTry)),
                              step("case", {{"value", "2"}}, list(depth + 1, inLoop, inTry)),
                              step("default", {}, list(depth + 1, inLoop, inTry))})};
            case 11:
                return {step("try", {}, list(depth + 1, false, true)),
                        step("onError", {}, list(depth + 1, inLoop, inTry))};
            case 12:
                return {step("folder", {{"name", "part"}}, list(depth + 1, inLoop, inTry))};
            default:
                return {step("speed", {{"factor", 0.5}}, list(depth + 1, inLoop, inTry))};
        }
    }

    QRandomGenerator random_;
    const project::Program& helper_;
};

inline project::Program helperProgram() {
    project::Program helper =
        makeProgram("helper", {step("if", {{"condition", "again > 1"}}, {step("setOutput", {{"output", 3}})}),
                               step("setOutput", {{"output", 4}})});
    helper.parameters = {"again"};
    return helper;
}

/// Appends the steps of a tree to `all`, including those inside sections.
inline void collect(std::vector<project::ProgramStep>& steps, std::vector<project::ProgramStep*>& all) {
    for (project::ProgramStep& step : steps) {
        if (!step.disabled) {
            all.push_back(&step);
            collect(step.steps, all);
        }
    }
}

/// A project with a program that has a fault in one step.
struct InvalidProgram {
    project::Project project;
    QUuid program;
    QUuid step;
    quint32 seed = 0;
};

class InvalidPrograms {
public:
    InvalidPrograms() { project_.programs.append(helper_); }

    InvalidProgram next() {
        for (;;) {
            const quint32 seed = seed_++;
            RandomSteps maker(seed, helper_);
            project::Program made = maker.program();
            std::vector<project::ProgramStep*> all;
            collect(made.steps, all);
            std::vector<project::ProgramStep*> plain;  // steps that are valid at any position
            for (project::ProgramStep* each : all) {
                if (each->steps.empty() && each->kind != "comment" && each != all.front()) {
                    plain.push_back(each);
                }
            }
            if (plain.empty()) {
                continue;
            }
            project::ProgramStep& wrong =
                *plain[static_cast<std::size_t>(maker.below(static_cast<int>(plain.size())))];
            const QUuid id = wrong.id;
            applyFault(seed, wrong);
            InvalidProgram invalid{project_, made.id, id, seed};
            invalid.project.programs.append(made);
            return invalid;
        }
    }

private:
    static project::ProgramStep makeStep(const project::ProgramStep& before, const char* kind,
                                         const QJsonObject& fields) {
        project::ProgramStep made = step(kind, fields);
        made.id = before.id;
        return made;
    }
    static void applyFault(quint32 seed, project::ProgramStep& wrong) {
        static const std::vector<std::function<void(project::ProgramStep&)>> faults{
            [](project::ProgramStep& step) { step.kind = "kind of the future"; },
            [](project::ProgramStep& step) {
                step = makeStep(step, "wait", {{"time", -1}});
            },
            [](project::ProgramStep& step) {
                step = makeStep(step, "setOutput", {{"output", 18}});
            },
            [](project::ProgramStep& step) {
                step = makeStep(step, "moveL", {{"waypoint", idText(QUuid::createUuid())}});
            },
            [](project::ProgramStep& step) {
                step = makeStep(step, "moveGroup", {{"group", "nowhere"}});
            },
            [](project::ProgramStep& step) {
                step = makeStep(step, "waitCondition", {{"condition", "n ="}});
            },
            [](project::ProgramStep& step) {
                step = makeStep(step, "assign", {{"variable", "n"}, {"type", "text"}, {"value", "\"\""}});
            },
            [](project::ProgramStep& step) {
                step = makeStep(step, "call", {{"program", idText(QUuid::createUuid())}});
            },
            [](project::ProgramStep& step) {
                step = makeStep(step, "case", {{"value", "1"}});
            },
            [](project::ProgramStep& step) {
                step = makeStep(step, "watch", {{"condition", ""}});
            }};
        faults[seed % faults.size()](wrong);
    }

    project::Project project_ = sampleProject();
    const project::Program helper_ = helperProgram();
    quint32 seed_ = 0;
};

}  // namespace tiller::program
