// SPDX-License-Identifier: MIT
//
// Random programs. Valid programs run in the order predicted by a model of the steps, invalid programs are
// refused at the faulty step, and damaged files cause no crash.

#include <QRandomGenerator>
#include <QTest>
#include <functional>

#include "program_samples.h"
#include "robot/station/program/preview/preview.h"

using namespace tiller;
using namespace tiller::program;

namespace {

constexpr int kPrograms = 500;

/// Generates programs from a fixed seed. All of them terminate.
class Maker {
public:
    Maker(quint32 seed, const project::Program& helper) : random_(seed), helper_(helper) {}

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

/// Model of the expected behaviour of the steps, without a script.
class Model {
public:
    Model(const ProgramScript& script, const project::Program& helper, bool input0)
        : script_(script), helper_(helper), input0_(input0) {}

    std::vector<int> run(const project::Program& program) {
        list(program.steps);
        return order_;
    }

private:
    enum class End { Normal, Leave, Fail };

    bool holds(const QString& condition) const {
        const std::array<std::pair<const char*, bool>, 7> values{{{"DI0", input0_},
                                                                  {"not DI0", !input0_},
                                                                  {"n > 2", n_ > 2},
                                                                  {"n % 2 == 0", n_ % 2 == 0},
                                                                  {"DI1 or n < 4", n_ < 4},
                                                                  {"n == 1 and DI0", n_ == 1 && input0_},
                                                                  {"again > 1", n_ > 1}}};
        for (const auto& [text, value] : values) {
            if (condition == QLatin1String(text)) {
                return value;
            }
        }
        qFatal("unknown condition");
        return false;
    }

    void mark(const project::ProgramStep& step) { order_.push_back(script_.numberOf(step.id)); }

    End list(const std::vector<project::ProgramStep>& steps) {
        bool taken = false;   // a branch of the current `if` was executed
        bool failed = false;  // the current `try` has failed
        for (const project::ProgramStep& step : steps) {
            if (step.disabled || step.kind == "comment") {
                continue;
            }
            End end = End::Normal;
            if (step.kind == "if" || step.kind == "elseIf" || step.kind == "else") {
                if (step.kind == "if") {
                    mark(step);
                    taken = false;
                }
                if (!taken && (step.kind == "else" || holds(step.fields["condition"].toString()))) {
                    taken = true;
                    if (step.kind != "if") {
                        mark(step);
                    }
                    end = list(step.steps);
                }
            } else if (step.kind == "onError") {
                if (failed) {
                    mark(step);
                    end = list(step.steps);
                }
            } else {
                mark(step);
                end = one(step, failed);
            }
            if (end != End::Normal) {
                return end;
            }
        }
        return End::Normal;
    }

    End one(const project::ProgramStep& step, bool& failed) {
        if (step.kind == "assign") {
            n_ = step.fields["value"] == "0" ? 0 : n_ + 1;
        } else if (step.kind == "leaveLoop") {
            return End::Leave;
        } else if (step.kind == "fail") {
            return End::Fail;
        } else if (step.kind == "call") {
            list(helper_.steps);
            mark(step);
        } else if (step.kind == "loop") {
            for (int i = 0; i < step.fields["times"].toInt(); ++i) {
                const End end = list(step.steps);
                if (end == End::Leave) {
                    break;
                }
                if (end == End::Fail) {
                    return end;
                }
            }
        } else if (step.kind == "switch") {
            for (const project::ProgramStep& branch : step.steps) {
                if (branch.kind == "default" || branch.fields["value"].toString().toInt() == n_) {
                    mark(branch);
                    return list(branch.steps);
                }
            }
        } else if (step.kind == "try") {
            failed = list(step.steps) == End::Fail;
        } else {
            return list(step.steps);
        }
        return End::Normal;
    }

    const ProgramScript& script_;
    const project::Program& helper_;
    bool input0_;
    int n_ = 0;
    std::vector<int> order_;
};

project::Program helperProgram() {
    project::Program helper =
        makeProgram("helper", {step("if", {{"condition", "again > 1"}}, {step("setOutput", {{"output", 3}})}),
                               step("setOutput", {{"output", 4}})});
    helper.parameters = {"again"};
    return helper;
}

/// Appends the steps of a tree to `all`, including those inside sections.
void collect(std::vector<project::ProgramStep>& steps, std::vector<project::ProgramStep*>& all) {
    for (project::ProgramStep& step : steps) {
        if (!step.disabled) {
            all.push_back(&step);
            collect(step.steps, all);
        }
    }
}

QByteArray texts(const std::vector<int>& numbers) {
    QByteArray text;
    for (const int number : numbers) {
        text += QByteArray::number(number) + ' ';
    }
    return text;
}

}  // namespace

class TestProgramRandom : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void validProgramsRunAsPredicted() {
        project::Project project = sampleProject();
        const project::Program helper = helperProgram();
        project.programs.append(helper);
        std::size_t steps = 0;
        for (quint32 seed = 0; seed < kPrograms; ++seed) {
            Maker maker(seed, helper);
            const project::Program made = maker.program();
            project::Project with = project;
            with.programs.append(made);
            const ProgramScript script = writeScript(with, made.id);
            QVERIFY2(script.ok(), qPrintable(script.problems.empty() ? QString() : script.problems[0].text));
            PreviewOptions options;
            options.inputs = {{0, 0, seed % 2 == 0}};
            const Preview preview = previewProgram(with, script, {}, options);
            QVERIFY2(preview.isGood(),
                     qPrintable(QStringLiteral("seed %1: %2\n%3")
                                    .arg(seed)
                                    .arg(preview.findings.empty() ? QString() : preview.findings[0].text,
                                         script.text)));
            const std::vector<int> expected = Model(script, helper, seed % 2 == 0).run(made);
            QVERIFY2(preview.order == expected, qPrintable(QStringLiteral("seed %1\n%2\n%3\n%4")
                                                               .arg(seed)
                                                               .arg(QString(texts(preview.order)),
                                                                    QString(texts(expected)), script.text)));
            steps += expected.size();
        }
        QVERIFY2(steps > 5 * kPrograms, qPrintable(QString::number(steps)));
    }

    void invalidProgramsAreRefusedAtTheStep() {
        project::Project project = sampleProject();
        const project::Program helper = helperProgram();
        project.programs.append(helper);
        const std::vector<std::function<void(project::ProgramStep&)>> faults{
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
        for (quint32 seed = 0; seed < kPrograms; ++seed) {
            Maker maker(seed, helper);
            project::Program made = maker.program();
            std::vector<project::ProgramStep*> all;
            collect(made.steps, all);
            std::vector<project::ProgramStep*> plain;  // steps that are valid at any position
            for (project::ProgramStep* step : all) {
                if (step->steps.empty() && step->kind != "comment" && step != all.front()) {
                    plain.push_back(step);
                }
            }
            if (plain.empty()) {
                continue;
            }
            project::ProgramStep& wrong =
                *plain[static_cast<std::size_t>(maker.below(static_cast<int>(plain.size())))];
            const QUuid id = wrong.id;
            faults[seed % faults.size()](wrong);
            project::Project with = project;
            with.programs.append(made);
            const ProgramScript script = writeScript(with, made.id);
            QVERIFY(!script.ok());
            QVERIFY2(std::any_of(script.problems.begin(), script.problems.end(),
                                 [&](const ProgramProblem& problem) { return problem.step == id; }),
                     qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(script.problems[0].text)));
        }
    }

    void damagedFilesCrashNothing() {
        project::Project project = sampleProject();
        const project::Program helper = helperProgram();
        project.programs.append(helper);
        project.programs.append(Maker(7, helper).program());
        project.programs.append(trayProgram(project));
        const QByteArray bytes = *project::serializeProject(project);
        QRandomGenerator random(1);
        int whole = 0;
        for (int i = 0; i < 1000; ++i) {
            QByteArray damaged = bytes;
            for (int n = 0; n <= i % 3; ++n) {
                const auto at = static_cast<qsizetype>(random.bounded(static_cast<quint32>(damaged.size())));
                switch (random.bounded(4)) {
                    case 0:
                        damaged[at] = static_cast<char>(random.bounded(256));
                        break;
                    case 1:
                        damaged.remove(at, static_cast<qsizetype>(random.bounded(40)));
                        break;
                    case 2:
                        damaged.insert(at, bytes.mid(static_cast<qsizetype>(
                                                         random.bounded(static_cast<quint32>(bytes.size()))),
                                                     60));
                        break;
                    default:
                        damaged[at] = static_cast<char>('0' + random.bounded(10));
                        break;
                }
            }
            const auto read = project::recoverFromBytes(damaged);
            if (!read) {
                continue;
            }
            for (const project::Program& program : read->document.programs) {
                static_cast<void>(writeScript(read->document, program.id));
            }
            if (const auto parsed = project::parseProject(damaged)) {
                ++whole;
                QVERIFY(*project::parseProject(*project::serializeProject(*parsed)) == *parsed);
            }
        }
        QVERIFY(whole > 10);
    }

private:
    static project::ProgramStep makeStep(const project::ProgramStep& before, const char* kind,
                                         const QJsonObject& fields) {
        project::ProgramStep made = step(kind, fields);
        made.id = before.id;
        return made;
    }
};

QTEST_APPLESS_MAIN(TestProgramRandom)
#include "tst_program_random.moc"
