// SPDX-License-Identifier: MIT
#include "robot/station/program/test/test_run.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

#include "robot/collision/collision_check.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/test/test_file.h"

namespace tiller::program {
namespace {

constexpr double kMilli = 1e3;
constexpr double kDegree = 180 / std::numbers::pi;

QString timeText(double seconds) {
    return QStringLiteral("%1 s").arg(seconds, 0, 'f', 3);
}
QString lengthText(double metres) {
    return QStringLiteral("%1 mm").arg(metres * kMilli, 0, 'f', 3);
}
QString angleText(double radians) {
    return QStringLiteral("%1 deg").arg(radians * kDegree, 0, 'f', 3);
}
QString forceText(double newtons) {
    return QStringLiteral("%1 N").arg(newtons, 0, 'f', 1);
}

QString rangeText(const ExpectedRange& range) {
    if (std::isinf(range.maximum)) {
        return std::isinf(range.minimum) ? QString() : QStringLiteral("at least ") + timeText(range.minimum);
    }
    return std::isinf(range.minimum)
               ? QStringLiteral("at most ") + timeText(range.maximum)
               : QStringLiteral("%1 to %2").arg(timeText(range.minimum), timeText(range.maximum));
}

QString endText(Preview::End end) {
    switch (end) {
        case Preview::End::Completed:
            return QStringLiteral("completed");
        case Preview::End::Failed:
            return QStringLiteral("failed");
        case Preview::End::Stopped:
            return QStringLiteral("stopped");
        case Preview::End::Running:
            return QStringLiteral("running");
    }
    return {};
}

QString signalText(int channel, double value) {
    if (channel < kFirstAnalogOutput) {
        return QStringLiteral("%1 %2").arg(outputName(channel),
                                           value != 0 ? QStringLiteral("on") : QStringLiteral("off"));
    }
    return QStringLiteral("%1 %2").arg(outputName(channel)).arg(value, 0, 'g', 6);
}

QString valueText(const QJsonValue& value) {
    if (value.isUndefined()) {
        return QStringLiteral("not set");
    }
    const QString list = QString::fromUtf8(QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact));
    return list.mid(1, list.size() - 2);
}

bool isSame(const QJsonValue& a, const QJsonValue& b, double tolerance) {
    if (a.isDouble() && b.isDouble()) {
        return std::abs(a.toDouble() - b.toDouble()) <= tolerance;
    }
    if (a.isArray() && b.isArray()) {
        const QJsonArray first = a.toArray();
        const QJsonArray second = b.toArray();
        return first.size() == second.size() &&
               std::equal(first.begin(), first.end(), second.begin(), [&](const auto& x, const auto& y) {
                   return isSame(QJsonValue(x), QJsonValue(y), tolerance);
               });
    }
    return a == b;
}

/// Compares a run with the expectations of its test.
class Judge {
public:
    Judge(const TestFile& file, const ProgramTest& test, const Preview& preview)
        : file_(file), test_(test), expected_(test.expected), preview_(preview) {}

    std::vector<Verdict> judge() {
        judgeEnd();
        judgeFindings(Finding::Kind::Collision, QStringLiteral("collisions"), expected_.allowsCollisions);
        judgeFindings(Finding::Kind::ProtectiveStop, QStringLiteral("protective stop"),
                      expected_.allowsProtectiveStop);
        judgeEvents();
        judgeAnswers();
        judgePose();
        if (expected_.clearance) {
            judgeClearance();
        }
        if (expected_.force) {
            add(QStringLiteral("force"), QStringLiteral("at most ") + forceText(*expected_.force),
                QStringLiteral("%1 at %2%3")
                    .arg(forceText(preview_.force.value), timeText(preview_.force.time),
                         inStep(preview_.force.step)),
                preview_.force.value <= *expected_.force);
        }
        if (expected_.duration) {
            add(QStringLiteral("duration"), rangeText(*expected_.duration), timeText(preview_.duration),
                expected_.duration->contains(preview_.duration));
        }
        if (expected_.cycle) {
            judgeCycle(*expected_.cycle);
        }
        judgeOutputs();
        judgeFinalOutputs();
        for (const ExpectedVariable& variable : expected_.variables) {
            const auto found = preview_.variables.find(variable.name.toStdString());
            const QJsonValue value =
                found == preview_.variables.end() ? QJsonValue(QJsonValue::Undefined) : found->second;
            add(QStringLiteral("variable ") + variable.name, valueText(variable.value), valueText(value),
                isSame(variable.value, value, variable.tolerance));
        }
        for (const ExpectedRuns& runs : expected_.runs) {
            const auto index = static_cast<std::size_t>(runs.step - 1);
            const int count = index < preview_.timings.size() ? preview_.timings[index].count : 0;
            add(QStringLiteral("runs of ") + stepText(runs.step), QString::number(runs.count),
                QString::number(count), count == runs.count);
        }
        return std::move(verdicts_);
    }

private:
    void add(const QString& name, const QString& expected, const QString& measured, bool passed) {
        verdicts_.push_back({name, expected, measured, passed});
    }

    QString stepText(int step) const {
        const ProgramScript& script = file_.programs[test_.program].script;
        return QStringLiteral("step %1 (%2)").arg(step).arg(stepName(*file_.project, script, step));
    }
    QString inStep(int step) const { return step > 0 ? QStringLiteral(", ") + stepText(step) : QString(); }

    void judgeEnd() {
        QString expected = endText(expected_.end);
        if (expected_.endStep > 0) {
            expected += QStringLiteral(" at ") + stepText(expected_.endStep);
        }
        QString measured = endText(preview_.end);
        if (preview_.end != Preview::End::Completed) {
            measured +=
                preview_.endStep > 0 ? QStringLiteral(" at ") + stepText(preview_.endStep) : QString();
            measured += QStringLiteral(" after ") + timeText(preview_.duration);
            const auto reason =
                std::find_if(preview_.findings.begin(), preview_.findings.end(),
                             [](const Finding& finding) { return finding.kind != Finding::Kind::Collision; });
            measured += reason != preview_.findings.end() ? QStringLiteral(": ") + reason->text : QString();
        }
        add(QStringLiteral("end"), expected, measured,
            preview_.end == expected_.end &&
                (expected_.endStep == 0 || preview_.endStep == expected_.endStep));
    }

    void judgeFindings(Finding::Kind kind, const QString& name, bool isAllowed) {
        QStringList found;
        for (const Finding& finding : preview_.findings) {
            if (finding.kind == kind) {
                found.append(QStringLiteral("at %1%2: %3")
                                 .arg(timeText(finding.time), inStep(finding.step), finding.text));
            }
        }
        add(name, isAllowed ? QStringLiteral("allowed") : QStringLiteral("none"),
            found.isEmpty() ? QStringLiteral("none") : found.join(QStringLiteral("; ")),
            isAllowed || found.isEmpty());
    }

    void judgeEvents() {
        if (test_.options.events.empty()) {
            return;
        }
        QStringList unused;
        for (const std::size_t index : preview_.unusedEvents) {
            const PreviewEvent& event = test_.options.events[index];
            unused.append(
                event.step > 0
                    ? QStringLiteral("%1 did not occur: %2").arg(test_.eventPlaces[index], notBegun(event))
                    : QStringLiteral("%1 did not occur: the run ended first").arg(test_.eventPlaces[index]));
        }
        const std::size_t count = test_.options.events.size();
        add(QStringLiteral("inputs and faults"), QStringLiteral("all %1 occur").arg(count),
            unused.isEmpty() ? QStringLiteral("all %1 occurred").arg(count)
                             : unused.join(QStringLiteral("; ")),
            unused.isEmpty());
    }

    QString notBegun(const PreviewEvent& event) const {
        const int count = preview_.timings[static_cast<std::size_t>(event.step - 1)].count;
        return count < event.run ? QStringLiteral("%1 began %2 times").arg(stepText(event.step)).arg(count)
                                 : QStringLiteral("the run ended first");
    }

    void judgeAnswers() {
        const qsizetype given = test_.options.answers.size();
        if (given == 0) {
            return;
        }
        QString measured = QStringLiteral("%1 questions").arg(preview_.questions);
        for (const int answer : preview_.unfitAnswers) {
            measured += QStringLiteral("; answers[%1] has a different type from the question").arg(answer);
        }
        add(QStringLiteral("answers"), QStringLiteral("%1 questions").arg(given), measured,
            preview_.questions == given && preview_.unfitAnswers.empty());
    }

    void judgePose() {
        if (!expected_.pose) {
            return;
        }
        const ExpectedPose& pose = *expected_.pose;
        const double position = (preview_.endPose.position - pose.pose.position).norm();
        const double rotation = Eigen::AngleAxisd(preview_.endPose.transform().linear().transpose() *
                                                  pose.pose.transform().linear())
                                    .angle();
        add(QStringLiteral("pose"),
            QStringLiteral("within %1 and %2").arg(lengthText(pose.position), angleText(pose.rotation)),
            QStringLiteral("%1 and %2 away").arg(lengthText(position), angleText(rotation)),
            position <= pose.position && rotation <= pose.rotation);
    }

    void judgeClearance() {
        const QString expected = QStringLiteral("at least ") + lengthText(*expected_.clearance);
        if (!preview_.clearance) {
            add(QStringLiteral("clearance"), expected,
                QStringLiteral("the cell has no enabled objects near the arm"), false);
            return;
        }
        add(QStringLiteral("clearance"), expected,
            QStringLiteral("%1 at %2%3")
                .arg(lengthText(preview_.clearance->value), timeText(preview_.clearance->time),
                     inStep(preview_.clearance->step)),
            preview_.clearance->value >= *expected_.clearance);
    }

    void judgeCycle(const ExpectedCycle& cycle) {
        double shortest = std::numeric_limits<double>::infinity();
        double longest = 0;
        std::optional<double> last;
        int count = 0;
        for (std::size_t i = 0; i < preview_.order.size(); ++i) {
            if (preview_.order[i] == cycle.step) {
                if (last) {
                    shortest = std::min(shortest, preview_.starts[i] - *last);
                    longest = std::max(longest, preview_.starts[i] - *last);
                    ++count;
                }
                last = preview_.starts[i];
            }
        }
        const QString name = QStringLiteral("cycle time of ") + stepText(cycle.step);
        if (count == 0) {
            add(name, rangeText(cycle.time), QStringLiteral("the step began fewer than two times"), false);
            return;
        }
        add(name, rangeText(cycle.time),
            QStringLiteral("%1 to %2 in %3 cycles").arg(timeText(shortest), timeText(longest)).arg(count),
            cycle.time.contains(shortest) && cycle.time.contains(longest));
    }

    void judgeOutputs() {
        if (expected_.outputs.empty()) {
            return;
        }
        QStringList wanted;
        for (const ExpectedOutput& output : expected_.outputs) {
            const QString range = rangeText(output.time);
            wanted.append(signalText(output.channel, output.value) +
                          (range.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(range)));
        }
        QStringList measured;
        bool passed = true;
        std::size_t next = 0;
        for (const OutputChange& change : preview_.outputChanges) {
            const bool isNamed = std::any_of(
                expected_.outputs.begin(), expected_.outputs.end(),
                [&change](const ExpectedOutput& output) { return output.channel == change.channel; });
            if (!isNamed) {
                continue;
            }
            measured.append(QStringLiteral("%1 at %2")
                                .arg(signalText(change.channel, change.value), timeText(change.time)));
            passed = passed && next < expected_.outputs.size() && fits(expected_.outputs[next], change);
            ++next;
        }
        add(QStringLiteral("outputs"), wanted.join(QStringLiteral(", ")),
            measured.isEmpty() ? QStringLiteral("no changes") : measured.join(QStringLiteral(", ")),
            passed && next == expected_.outputs.size());
    }

    static bool fits(const ExpectedOutput& output, const OutputChange& change) {
        return output.channel == change.channel &&
               std::abs(output.value - change.value) <= output.tolerance && output.time.contains(change.time);
    }

    void judgeFinalOutputs() {
        for (const ExpectedOutput& output : expected_.finalOutputs) {
            const double value =
                output.channel < kFirstAnalogOutput
                    ? static_cast<double>((preview_.outputs >> output.channel) & 1U)
                    : preview_.analogOutputs[static_cast<std::size_t>(output.channel - kFirstAnalogOutput)];
            add(QStringLiteral("output at the end"), signalText(output.channel, output.value),
                signalText(output.channel, value), std::abs(value - output.value) <= output.tolerance);
        }
    }

    const TestFile& file_;
    const ProgramTest& test_;
    const TestExpectations& expected_;
    const Preview& preview_;
    std::vector<Verdict> verdicts_;
};

TestOutcome runTest(const TestFile& file, const ProgramTest& test, const TestRunOptions& options,
                    collision::NeverMeeting& known) {
    TestOutcome outcome;
    const ProgramScript& script = file.programs[test.program].script;
    if (!script.ok()) {
        QStringList problems;
        for (const ProgramProblem& problem : script.problems) {
            const QString step = problem.number > 0
                                     ? QStringLiteral("step %1 (%2): ")
                                           .arg(problem.number)
                                           .arg(stepName(*file.project, script, problem.number))
                                     : QString();
            problems.append(step + problem.text);
        }
        outcome.verdicts.push_back({QStringLiteral("program"), QStringLiteral("no errors"),
                                    problems.join(QStringLiteral("; ")), false});
        return outcome;
    }
    PreviewOptions preview = test.options;
    preview.seed = options.seed;
    preview.known = &known;
    preview.isCancelled = options.isCancelled;
    preview.maxCycles = 0;
    outcome.preview = previewProgram(*file.project, script, {}, preview);
    outcome.verdicts = judge(file, test, outcome.preview);
    outcome.preview.path = {};
    outcome.hasRun = true;
    return outcome;
}

}  // namespace

bool TestOutcome::passed() const {
    return std::all_of(verdicts.begin(), verdicts.end(),
                       [](const Verdict& verdict) { return verdict.passed; });
}

std::vector<Verdict> judge(const TestFile& file, const ProgramTest& test, const Preview& preview) {
    return Judge(file, test, preview).judge();
}

std::vector<TestOutcome> runTests(const std::vector<TestFile>& files, const TestRunOptions& options) {
    std::vector<TestOutcome> outcomes;
    for (std::size_t file = 0; file < files.size(); ++file) {
        for (std::size_t test = 0; test < files[file].tests.size(); ++test) {
            outcomes.push_back({});
            outcomes.back().file = file;
            outcomes.back().test = test;
        }
    }
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        collision::NeverMeeting known;
        for (std::size_t i = next++; i < outcomes.size(); i = next++) {
            if (options.isCancelled && options.isCancelled()) {
                return;
            }
            TestOutcome& outcome = outcomes[i];
            const TestFile& file = files[outcome.file];
            TestOutcome run = runTest(file, file.tests[outcome.test], options, known);
            run.file = outcome.file;
            run.test = outcome.test;
            outcome = std::move(run);
        }
    };
    std::vector<std::thread> threads;
    for (int i = 1; i < options.threads && static_cast<std::size_t>(i) < outcomes.size(); ++i) {
        threads.emplace_back(work);
    }
    work();
    for (std::thread& thread : threads) {
        thread.join();
    }
    return outcomes;
}

QString verdictText(const Verdict& verdict) {
    return QStringLiteral("%1: %2 (expected %3)").arg(verdict.name, verdict.measured, verdict.expected);
}

}  // namespace tiller::program
