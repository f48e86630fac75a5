// SPDX-License-Identifier: MIT
//
// Random programs. Valid programs run in the order predicted by a model of the steps, invalid programs are
// refused at the faulty step, and damaged files cause no crash.

#include <QRandomGenerator>
#include <QTest>
#include <algorithm>

#include "program_samples.h"
#include "random_programs.h"
#include "robot/station/program/preview/preview.h"

using namespace tiller;
using namespace tiller::program;

namespace {

constexpr int kPrograms = 500;
constexpr int kDamagedFiles = 1000;

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
            RandomSteps maker(seed, helper);
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
        InvalidPrograms programs;
        for (int i = 0; i < kPrograms; ++i) {
            const InvalidProgram invalid = programs.next();
            const ProgramScript script = writeScript(invalid.project, invalid.program);
            QVERIFY2(!script.ok(), qPrintable(QStringLiteral("seed %1").arg(invalid.seed)));
            QVERIFY2(
                std::ranges::any_of(
                    script.problems,
                    [&](const ProgramProblem& problem) { return problem.step == invalid.step; }),
                qPrintable(QStringLiteral("seed %1: %2").arg(invalid.seed).arg(script.problems[0].text)));
        }
    }

    void damagedFilesAreNeverSilentlyDifferent() {
        project::Project project = sampleProject();
        const project::Program helper = helperProgram();
        project.programs.append(helper);
        project.programs.append(RandomSteps(7, helper).program());
        project.programs.append(trayProgram(project));
        const QByteArray bytes = *project::serializeProject(project);
        QRandomGenerator random(1);
        int whole = 0;
        int repaired = 0;
        for (int i = 0; i < kDamagedFiles; ++i) {
            QByteArray damaged = bytes;
            for (int n = 0; n <= i % 3 || damaged == bytes; ++n) {
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
            const auto parsed = project::parseProject(damaged);
            if (!read) {
                QVERIFY2(!parsed, qPrintable(QString::number(i)));
                continue;
            }
            for (const project::Program& program : read->document.programs) {
                static_cast<void>(writeScript(read->document, program.id));
            }
            // A file with a problem is not opened without a report, and other files keep their content when
            // saved.
            QCOMPARE(parsed.ok(), read->problems.isEmpty());
            if (parsed) {
                ++whole;
                QVERIFY(*parsed == read->document);
                QVERIFY(*project::parseProject(*project::serializeProject(*parsed)) == *parsed);
            } else {
                ++repaired;
            }
        }
        QVERIFY(whole > 10 && repaired > 10);
    }
};

QTEST_APPLESS_MAIN(TestProgramRandom)
#include "tst_program_random.moc"
