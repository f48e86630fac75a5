// SPDX-License-Identifier: MIT
//
// Recoverability marks, compared with executed stops. Each program is stopped in the simulated controller and
// continued from the step of the mark. The result must equal that of the uninterrupted program if and only if
// the mark predicts this.

#include <QRandomGenerator>
#include <QTest>
#include <bit>
#include <map>

#include "program_samples.h"
#include "random_moves.h"
#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/host/script_host.h"
#include "robot/simulator/programs/program_runner.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/recover/recovery_map.h"

using namespace tiller;
using namespace tiller::program;

namespace {

constexpr double kOperatorTime = 1;  // default of PreviewOptions

/// State of the robot at the end of a program.
struct Result {
    bool completed = false;
    std::uint64_t outputs = 0;
    std::array<int, 18> switches{};
    std::array<double, 2> analog{};
    simulator::RegisterBank registers;
    Pose tcp;
    double payload = 0;
    JointPositions q;
    std::vector<std::pair<QUuid, QUuid>> order;
};

/// A simulated controller on which scripts are run, stopped and run again.
class Bench {
public:
    Bench(const JointPositions& start, const Pose& tcp, std::vector<InputChange> inputs)
        : model_(optionsAt(start)), tcp_(tcp), inputs_(std::move(inputs)) {
        model_.arm().setTcp(tcp);
        model_.registers().followed.number = kStepRegister;
        model_.step();
        last_ = model_.pins().digitalOutputs;
    }

    /// Runs a script until it ends, or for `limit` [s].
    /// Returns  true if it has ended
    bool run(const ProgramScript& script, double limit) {
        applyInputs();
        if (!model_.programs().submitText(script.text.toStdString())) {
            return false;
        }
        const double began = model_.elapsed();
        askedAt_ = -1;
        while (model_.elapsed() - began < limit - 1e-9) {
            model_.step();
            clock_ += model_.stepTime();
            count();
            for (const std::int32_t value : std::exchange(model_.registers().followed.values, {})) {
                failed_ = failed_ || value < 0;
                if (value > 0) {
                    const NumberedStep& step = script.steps.at(static_cast<std::size_t>(value - 1));
                    result_.order.emplace_back(step.program, step.step);
                }
            }
            if (!model_.programs().isActive()) {
                return true;
            }
            applyInputs();
            answer();
        }
        return false;
    }

    void stop(StopKind kind) {
        switch (kind) {
            case StopKind::LinkLoss:
            case StopKind::Operator:
                model_.programs().stopNow();
                break;
            case StopKind::Protective:
                model_.protectiveStop({204, 1, simulator::primary::ReportLevel::Warning, "test"});
                settle();
                model_.programs().stopNow();
                model_.restartSafety();
                break;
            case StopKind::PowerLoss:
                model_.restart(1, false);
                model_.pins().digitalOutputs = 0;
                model_.pins().analogOutputLevels = {};
                model_.registers().output = {};
                model_.arm().setTcp(tcp_);
                model_.arm().setPayload({});
                break;
        }
        settle();
        model_.powerOn();
        model_.releaseBrakes();
        for (int i = 0; model_.power().mode() != RobotMode::Running && i < 20'000; ++i) {
            model_.powerOn();
            model_.releaseBrakes();
            model_.step();
        }
        QCOMPARE(model_.power().mode(), RobotMode::Running);
        QCOMPARE(model_.safety().mode(), SafetyMode::Normal);
        model_.popups().closeBlocking();
        count();
    }

    void moveTo(const JointPositions& q) {
        const auto& v = q.values;
        const QString text = QStringLiteral("def back():\n  movej([%1, %2, %3, %4, %5, %6])\nend\n")
                                 .arg(v[0], 0, 'g', 12)
                                 .arg(v[1], 0, 'g', 12)
                                 .arg(v[2], 0, 'g', 12)
                                 .arg(v[3], 0, 'g', 12)
                                 .arg(v[4], 0, 'g', 12)
                                 .arg(v[5], 0, 'g', 12);
        QVERIFY(model_.programs().submitText(text.toStdString()));
        settle();
        QVERIFY(distanceTo(q) < 1e-6);
    }
    double distanceTo(const JointPositions& q) const {
        return (model_.arm().state().targetQ.values - q.values).cwiseAbs().maxCoeff();
    }

    Result result(bool ended) {
        Result result = result_;
        result.completed =
            ended && !failed_ && !model_.programs().failure() && model_.safety().mode() == SafetyMode::Normal;
        result.outputs = model_.pins().digitalOutputs;
        result.analog = model_.pins().analogOutputLevels;
        result.registers = model_.registers().output;
        result.registers.ints[kStepRegister] = 0;
        result.tcp = model_.arm().tcp();
        result.payload = model_.arm().payload().mass;
        result.q = model_.arm().state().targetQ;
        return result;
    }

private:
    static simulator::SimulatorOptions optionsAt(const JointPositions& start) {
        simulator::SimulatorOptions options;
        options.model = RobotModelId::UR5e;
        options.time = simulator::Time::Virtual;
        options.poweredOn = true;
        options.fastTransitions = true;
        options.startJoints = start;
        return options;
    }
    void settle() {
        for (int i = 0; i < 20'000; ++i) {
            model_.step();
            static_cast<void>(model_.takeOutbox());
            if (!model_.programs().isActive() && model_.arm().state().isSteady()) {
                return;
            }
        }
    }
    void count() {
        const std::uint64_t now = model_.pins().digitalOutputs;
        for (std::uint64_t on = now & ~last_; on != 0; on &= on - 1) {
            ++result_.switches.at(static_cast<std::size_t>(std::countr_zero(on)));
        }
        last_ = now;
        static_cast<void>(model_.takeOutbox());
    }
    void applyInputs() {
        for (const InputChange& change : inputs_) {
            if (change.time <= clock_ + 1e-9) {
                simulator::Pins::setBit(model_.pins().digitalInputs, change.channel, change.value);
            }
        }
    }
    void answer() {
        const auto asked = model_.scriptHost().asked();
        if (!model_.popups().anyBlocking() && !asked) {
            askedAt_ = -1;
        } else if (askedAt_ < 0) {
            askedAt_ = clock_;
        } else if (clock_ - askedAt_ >= kOperatorTime) {
            model_.popups().closeBlocking();
            if (asked) {
                model_.scriptHost().answerRequest(std::int32_t{0});
            }
            askedAt_ = -1;
        }
    }

    simulator::ControllerModel model_;
    Pose tcp_;
    std::vector<InputChange> inputs_;
    double clock_ = 0;  ///< time for which programs have run [s]
    double askedAt_ = -1;
    std::uint64_t last_ = 0;
    bool failed_ = false;
    Result result_;
};

QString differenceOf(const Result& expected, const Result& actual, std::size_t orderBefore,
                     const std::vector<std::pair<QUuid, QUuid>>& orderAgain, double tolerance) {
    if (!actual.completed) {
        return "not completed";
    }
    if (actual.outputs != expected.outputs || actual.switches != expected.switches) {
        return "outputs";
    }
    if (actual.analog != expected.analog) {
        return "analog outputs";
    }
    if (actual.registers.bits != expected.registers.bits ||
        actual.registers.ints != expected.registers.ints ||
        actual.registers.doubles != expected.registers.doubles) {
        return "registers";
    }
    if (!actual.tcp.transform().isApprox(expected.tcp.transform(), 1e-6) ||
        actual.payload != expected.payload) {
        return "TCP or payload";
    }
    if (!std::equal(expected.order.begin() + static_cast<std::ptrdiff_t>(orderBefore), expected.order.end(),
                    orderAgain.begin(), orderAgain.end())) {
        return "order";
    }
    const double distance = (actual.q.values - expected.q.values).cwiseAbs().maxCoeff();
    return distance > tolerance ? QStringLiteral("position %1").arg(distance) : QString();
}

/// A program with its marks and its uninterrupted result.
class Case {
public:
    Case(project::Project project, project::Program program, std::vector<InputChange> inputs = {})
        : project_(std::move(project)), program_(std::move(program)), inputs_(std::move(inputs)) {
        project_.programs.append(program_);
        script = writeScript(project_, program_.id);
        RecoveryOptions options;
        options.preview.inputs = inputs_;
        options.preview.timeLimit = 30;
        map = checkRecovery(project_, program_.id, script, {}, options);
    }

    QString problem() const { return script.problems.empty() ? QString() : script.problems.front().text; }
    const StopMark& mark(int step, StopKind kind = StopKind::Operator) const {
        return map.steps.at(static_cast<std::size_t>(step - 1)).of(kind);
    }
    Recovery recovery(int step, StopKind kind = StopKind::Operator) const {
        return mark(step, kind).recovery;
    }

    /// Executes the stop. Returns the difference between the mark and the result; empty if they agree.
    QString disagreement(const StopPoint& point, StopKind kind) {
        const StopMark& mark = point.marks[static_cast<std::size_t>(kind)];
        if (hasOwnReason(mark)) {
            return {};
        }
        // A connection loss takes effect later, perhaps in a later step.
        const double time = point.time + (kind == StopKind::LinkLoss ? kMaxLinkLossTime / 2 : 0);
        const auto after = std::find_if(map.points.begin(), map.points.end(),
                                        [&](const StopPoint& each) { return each.time > time + 1e-9; });
        const StepRecovery& recovery = map.steps.at(static_cast<std::size_t>(std::prev(after)->step - 1));
        const bool says = mark.recovery != Recovery::Unsafe;
        ScriptOptions options;
        options.from = recovery.fromStep;
        const ProgramScript rest = writeScript(project_, program_.id, options);
        if (!rest.ok()) {
            return says ? "no run from the step of the mark" : QString();
        }
        if (!undisturbed_) {
            Bench bench(start(), tcp(), inputs_);
            const bool ended = bench.run(script, 30);
            undisturbed_ = bench.result(ended);
        }
        Bench bench(start(), tcp(), inputs_);
        if (bench.run(script, time)) {
            return {};
        }
        const std::uint64_t outputsAtStop = bench.result(false).outputs;
        bench.stop(kind);
        std::uint64_t lost = outputsAtStop & ~bench.result(false).outputs;
        lost &= lost != 0 ? outputsBefore(recovery.fromStep) : 0;
        // In force mode, the position depends on the noise of the sensor.
        double tolerance = script.text.contains("force_mode(") ? 1e-2 : 2e-4;
        if (mark.recovery == Recovery::Continue && kind != StopKind::LinkLoss) {
            if (bench.distanceTo(recovery.start) > 0.01) {
                return "the arm is not at the start position";
            }
            tolerance = std::max(tolerance, 2e-3);
        } else {
            bench.moveTo(recovery.start);
        }
        const std::size_t before = bench.result(false).order.size();
        const bool ended = bench.run(rest, 30);
        const Result result = bench.result(ended);
        const auto first = std::find(undisturbed_->order.begin(), undisturbed_->order.end(),
                                     std::pair(program_.id, recovery.fromStep));
        const QString difference =
            lost != 0
                ? "lost output"
                : differenceOf(
                      *undisturbed_, result, static_cast<std::size_t>(first - undisturbed_->order.begin()),
                      {result.order.begin() + static_cast<std::ptrdiff_t>(before), result.order.end()},
                      tolerance);
        if (kind == StopKind::LinkLoss && !says) {
            return {};  // the mark is the worst result for any time at which the loss may take effect
        }
        if (difference.isEmpty() == says) {
            return {};
        }
        return QStringLiteral(
                   "stop %1 at %2 s in step %3, continued from step %4: mark %5 (%6), executed: %7\n%8")
            .arg(stopKindText(kind))
            .arg(point.time)
            .arg(point.step)
            .arg(recovery.from)
            .arg(recoveryText(mark.recovery), mark.reason, difference, script.text);
    }

    ProgramScript script;
    RecoveryMap map;

private:
    /// True for marks whose reason is not visible in the comparison.
    static bool hasOwnReason(const StopMark& mark) {
        return mark.recovery == Recovery::Unsafe &&
               (mark.reason.contains("force section") || mark.reason.contains("URScript text"));
    }
    /// Output states at the start of the step in the uninterrupted program.
    std::uint64_t outputsBefore(const QUuid& step) {
        Bench bench(start(), tcp(), inputs_);
        const int number = script.numberOf(step);
        for (const StopPoint& point : map.points) {
            if (point.step >= number) {
                bench.run(script, point.time - 0.002);
                break;
            }
        }
        return bench.result(false).outputs;
    }
    JointPositions start() const { return startPosition(project_, script); }
    Pose tcp() const { return script.tcp.value_or(Pose()); }

    project::Project project_;
    project::Program program_;
    std::vector<InputChange> inputs_;
    std::optional<Result> undisturbed_;
};

bool contains(const project::ProgramStep& step, const QString& kind) {
    return step.kind == kind || std::any_of(step.steps.begin(), step.steps.end(),
                                            [&](const auto& inner) { return contains(inner, kind); });
}

/// Adds the steps of this kind and the steps inside them.
void collectOf(const project::ProgramStep& step, const QString& kind, bool isInside, QSet<QUuid>& ids) {
    const bool isOf = isInside || step.kind == kind;
    if (isOf) {
        ids.insert(step.id);
    }
    for (const project::ProgramStep& inner : step.steps) {
        collectOf(inner, kind, isOf, ids);
    }
}

/// Top-level steps of a program that contains a step of this kind.
Steps exampleOf(const QString& kind, const project::Project& project) {
    const auto at = [&](const char* name) { return waypointId(project, name); };
    const auto wait = [] { return step("wait", {{"time", 0.15}}); };
    const auto move = [&](const char* to) { return step("moveL", {{"waypoint", at(to)}}); };
    const auto count = [](const char* value) {
        return step("assign", {{"variable", "n"}, {"type", "whole"}, {"value", value}});
    };
    const std::map<QString, Steps> all{
        {"moveJ", {step("moveJ", {{"waypoint", at("pick")}})}},
        {"moveL", {move("pick")}},
        {"moveP", {step("moveP", {{"waypoint", at("pick")}, {"blend", 0.02}}), move("place")}},
        {"moveCircle", {move("row 1"), step("moveCircle", {{"via", at("pick")}, {"waypoint", at("place")}})}},
        {"moveGroup", {step("moveGroup", {{"group", "row"}})}},
        {"moveRelative", {step("moveRelative", {{"z", 0.03}}), step("moveRelative", {{"x", 0.03}})}},
        {"moveUntil", {step("moveUntil", {{"until", "distance"}, {"distance", 0.01}})}},
        {"setOutput",
         {step("setOutput", {{"output", 1}}), wait(), step("setOutput", {{"output", 1}, {"value", false}})}},
        {"pulseOutput", {step("pulseOutput", {{"output", 1}, {"time", 0.3}})}},
        {"setAnalogOutput", {step("setAnalogOutput", {{"output", 1}, {"level", 0.5}}), wait()}},
        {"setRegister",
         {step("folder", {},
               {step("setRegister", {{"value", "read_output_integer_register(0) + 1"}}), wait()})}},
        {"waitInput", {step("waitInput", {{"input", 3}, {"timeLimit", 0.3}, {"otherwise", "continue"}})}},
        {"wait", {wait()}},
        {"waitCondition",
         {step("waitCondition", {{"condition", "DO1"}, {"timeLimit", 0.3}, {"otherwise", "continue"}})}},
        {"gripper",
         {step("gripper", {{"action", "close"}, {"time", 0.2}}), move("pick"),
          step("gripper", {{"action", "open"}, {"time", 0.2}})}},
        {"tool",
         {step("tool", {{"tool", idText(project.tooling.tools.at(0).id)}},
               {step("moveRelative", {{"z", 0.02}}), wait()})}},
        {"payload", {step("payload", {{"payload", idText(project.tooling.payloads.at(0).id)}}), wait()}},
        {"frame",
         {step("frame", {{"frame", idText(project.frames.at(0).id)}},
               {step("moveRelative", {{"axes", "frame"}, {"x", 0.02}}), wait()})}},
        {"speed", {step("speed", {{"factor", 0.5}}, {move("pick"), wait()})}},
        {"force", {step("force", {{"force", 0}}, {wait()}), move("pick")}},
        {"loop",
         {step("loop", {{"times", 2}}, {move("pick"), step("pulseOutput", {{"time", 0.1}}), move("home")})}},
        {"while", {count("0"), step("while", {{"condition", "n < 2"}}, {count("n + 1"), wait()})}},
        {"forEachWaypoint",
         {step("forEachWaypoint", {{"group", "row"}}, {step("moveL", {{"pose", "place"}})})}},
        {"forEachPlace", {step("forEachPlace", {{"pattern", idText(project.patterns.at(0).id)}}, {wait()})}},
        {"leaveLoop", {step("loop", {{"times", 0}}, {wait(), step("leaveLoop")})}},
        {"if", {step("if", {{"condition", "DI0"}}, {move("pick"), wait()})}},
        {"elseIf",
         {step("if", {{"condition", "not DI0"}}, {wait()}),
          step("elseIf", {{"condition", "DI0"}}, {move("pick"), wait()})}},
        {"else",
         {step("if", {{"condition", "not DI0"}}, {wait()}),
          step("else", {}, {step("pulseOutput", {{"time", 0.1}}), wait()})}},
        {"switch", {step("switch", {{"value", "1"}}, {step("case", {{"value", "1"}}, {wait()})})}},
        {"case",
         {step("switch", {{"value", "2"}},
               {step("case", {{"value", "1"}}, {wait()}), step("case", {{"value", "2"}}, {move("pick")})})}},
        {"default",
         {step("switch", {{"value", "2"}},
               {step("case", {{"value", "1"}}, {wait()}), step("default", {}, {move("pick")})})}},
        {"call", {step("call", {{"program", idText(project.programs.at(0).id)}})}},
        {"watch", {step("watch", {{"condition", "DI5"}}, {step("setOutput", {{"output", 2}})}), wait()}},
        {"try",
         {step("try", {}, {move("pick"), step("fail", {{"text", "on purpose"}})}),
          step("onError", {}, {wait()})}},
        {"onError",
         {step("try", {}, {step("fail", {{"text", "on purpose"}})}),
          step("onError", {}, {move("pick"), step("pulseOutput", {{"time", 0.1}}), wait()})}},
        {"fail",
         {step("try", {}, {wait(), step("fail", {{"text", "on purpose"}})}), step("onError", {}, {wait()})}},
        {"end", {step("if", {{"condition", "DO7"}}, {wait(), step("end")})}},
        {"assign", {count("3"), wait(), step("setRegister", {{"register", 1}, {"value", "n"}}), wait()}},
        {"message", {step("message", {{"text", "ready"}})}},
        {"question", {step("question", {{"text", "how many"}, {"type", "whole"}}), wait()}},
        {"log", {step("log", {{"text", "here"}}), wait()}},
        {"script", {step("script", {{"text", "sleep(0.3)"}}), wait()}},
        {"comment", {step("comment", {{"text", "a remark"}}), wait()}},
        {"folder", {step("folder", {{"name", "part"}}, {wait(), move("pick")})}},
    };
    const auto found = all.find(kind);
    return found == all.end() ? Steps() : found->second;
}

}  // namespace

class TestProgramRecover : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void executedStopsAgreeWithTheMarksOfEachStepKind_data() {
        QTest::addColumn<QString>("kind");
        for (const StepKind* kind : stepKinds()) {
            QTest::newRow(kind->id) << QString(QLatin1String(kind->id));
        }
    }
    void executedStopsAgreeWithTheMarksOfEachStepKind() {
        QFETCH(QString, kind);
        project::Project project = sampleProject();
        project.programs.append(
            makeProgram("helper", {step("wait", {{"time", 0.1}}), step("pulseOutput", {{"time", 0.1}})}));
        const Steps steps = exampleOf(kind, project);
        QVERIFY2(
            std::any_of(steps.begin(), steps.end(), [&](const auto& each) { return contains(each, kind); }),
            "no example of this kind");
        Steps all{step("moveJ", {{"waypoint", waypointId(project, "home")}}),
                  step("setOutput", {{"output", 7}})};
        all.insert(all.end(), steps.begin(), steps.end());
        all.push_back(step("wait", {{"time", 0.2}}));
        all.push_back(step("moveL", {{"waypoint", waypointId(project, "place")}}));
        Case made(project, makeProgram("p", all), {{0, 0, true}});
        QVERIFY2(made.script.ok(), qPrintable(made.problem()));
        QVERIFY(made.map.isComplete);
        // Each kind of stop at the beginning and in the middle of the steps of this kind.
        QSet<QUuid> tested;
        for (const auto& each : steps) {
            collectOf(each, kind, false, tested);
        }
        std::vector<const StopPoint*> points;
        for (const StopPoint& point : made.map.points) {
            if (tested.contains(made.script.steps.at(static_cast<std::size_t>(point.step - 1)).step)) {
                points.push_back(&point);
            }
        }
        if (points.empty()) {  // a step without a duration
            for (const StopPoint& point : made.map.points) {
                points.push_back(&point);
            }
        }
        for (const StopPoint* point : {points.front(), points.at(points.size() / 2)}) {
            for (const StopKind stop : kStopKinds) {
                const QString wrong = made.disagreement(*point, stop);
                QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
            }
        }
    }

    void movesContinueAfterMovingBack() {
        const project::Project project = sampleProject();
        Case made(project, makeProgram("p", {step("moveJ", {{"waypoint", waypointId(project, "home")}}),
                                             step("wait", {{"time", 0.3}}),
                                             step("moveL", {{"waypoint", waypointId(project, "pick")}}),
                                             step("moveRelative", {{"z", 0.05}})}));
        QCOMPARE(made.recovery(2), Recovery::Continue);
        QCOMPARE(made.recovery(3), Recovery::MoveBack);
        QVERIFY2(made.mark(3).reason.contains("step 3 (MoveL)"), qPrintable(made.mark(3).reason));
        QCOMPARE(made.recovery(4), Recovery::MoveBack);
        QVERIFY2(made.mark(4).reason.contains("relative move"), qPrintable(made.mark(4).reason));
        // At the beginning of the move, the arm is at its start position.
        const auto first = std::find_if(made.map.points.begin(), made.map.points.end(),
                                        [](const StopPoint& point) { return point.step == 3; });
        QCOMPARE(first->marks[0].recovery, Recovery::Continue);
        QVERIFY(made.map.points.size() > 10);
        for (std::size_t i = 0; i < made.map.points.size(); i += 3) {
            const QString wrong = made.disagreement(made.map.points[i], StopKind::Operator);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        }
    }

    void heldPartPreventsRepeatedGripping() {
        const project::Project project = sampleProject();
        Case made(project,
                  makeProgram("p", {step("moveJ", {{"waypoint", waypointId(project, "home")}}),
                                    step("folder", {{"name", "pick"}},
                                         {step("gripper", {{"action", "open"}, {"time", 0.2}}),
                                          step("moveL", {{"waypoint", waypointId(project, "pick")}}),
                                          step("gripper", {{"action", "close"}, {"time", 0.2}}),
                                          step("moveL", {{"waypoint", waypointId(project, "home")}})}),
                                    step("moveL", {{"waypoint", waypointId(project, "place")}}),
                                    step("gripper", {{"action", "open"}, {"time", 0.2}})}));
        QCOMPARE(made.recovery(3), Recovery::Continue);
        QCOMPARE(made.recovery(4), Recovery::MoveBack);
        QCOMPARE(made.recovery(5), Recovery::Unsafe);
        QCOMPARE(made.recovery(6), Recovery::Unsafe);
        QVERIFY2(made.mark(6).reason.contains("part"), qPrintable(made.mark(6).reason));
        // While the gripper holds the part, the next move can be repeated, except after a power loss.
        QCOMPARE(made.recovery(7), Recovery::MoveBack);
        QCOMPARE(made.recovery(7, StopKind::PowerLoss), Recovery::Unsafe);
        QVERIFY(made.mark(7, StopKind::PowerLoss).reason.contains("part"));
    }

    void openForceSectionAndScriptTextCannotContinue() {
        const project::Project project = sampleProject();
        Case made(project, makeProgram("p", {step("force", {{"force", 0}}, {step("wait", {{"time", 0.2}})}),
                                             step("wait", {{"time", 0.2}}),
                                             step("script", {{"text", "sleep(0.3)"}})}));
        QCOMPARE(made.recovery(2), Recovery::Unsafe);
        QVERIFY2(made.mark(2).reason.contains("force section"), qPrintable(made.mark(2).reason));
        QVERIFY(made.recovery(3) != Recovery::Unsafe);
        QCOMPARE(made.recovery(4), Recovery::Unsafe);
        QVERIFY2(made.mark(4).reason.contains("URScript"), qPrintable(made.mark(4).reason));
    }

    void valuesThatAreNotSavedPreventContinuing() {
        const project::Project project = sampleProject();
        const auto wait = [] { return step("wait", {{"time", 0.15}}); };
        const auto assign = [](const char* value) {
            return step("assign", {{"variable", "n"}, {"type", "whole"}, {"value", value}});
        };
        const auto count = [] {
            return step("setRegister", {{"value", "read_output_integer_register(0) + 1"}});
        };
        Case made(project, makeProgram("p", {assign("2"), wait(),
                                             step("setRegister", {{"register", 1}, {"value", "n"}}), wait(),
                                             step("folder", {}, {count(), wait()}), wait()}));
        QCOMPARE(made.recovery(2), Recovery::Unsafe);  // a later step uses n
        QVERIFY2(made.mark(2).reason.contains("n"), qPrintable(made.mark(2).reason));
        QCOMPARE(made.recovery(4), Recovery::Continue);
        QCOMPARE(made.recovery(7), Recovery::Unsafe);  // the folder would increment the register again
        QVERIFY2(made.mark(7).reason.contains("register"), qPrintable(made.mark(7).reason));
        QCOMPARE(made.recovery(8), Recovery::Continue);
        QCOMPARE(made.recovery(8, StopKind::PowerLoss), Recovery::Unsafe);  // the register is lost
    }

    void passedEventMakesARepeatedWaitUnsafe() {
        const project::Project project = sampleProject();
        const auto pulse = [] {
            return step("folder", {}, {step("waitInput", {{"input", 2}}), step("wait", {{"time", 1}})});
        };
        Case made(project, makeProgram("p", {step("wait", {{"time", 0.2}}), pulse()}),
                  {{0.5, 2, true}, {0.8, 2, false}});
        QCOMPARE(made.recovery(3), Recovery::Continue);
        QCOMPARE(made.recovery(4), Recovery::Unsafe);
        QVERIFY2(made.mark(4).reason.contains("wait in step 3"), qPrintable(made.mark(4).reason));
    }

    void endlessLoopsContinueAtTheirBeginning() {
        const project::Project project = sampleProject();
        const auto move = [&](const char* waypoint) {
            return step("moveL", {{"waypoint", waypointId(project, waypoint)}});
        };
        Case made(project,
                  makeProgram("p", {move("home"), step("loop", {{"times", 0}},
                                                       {move("pick"), step("pulseOutput"), move("place")})}));
        QVERIFY(made.map.isComplete);
        QCOMPARE(made.recovery(1), Recovery::Continue);
        QCOMPARE(made.recovery(3), Recovery::MoveBack);
        QCOMPARE(made.map.steps[2].from, 2);
        QCOMPARE(made.recovery(4), Recovery::MoveBack);  // the output is still on
        QCOMPARE(made.recovery(5), Recovery::Unsafe);    // the output would turn on twice in one cycle
        // The variable `n`, which counts the cycles, is lost.
        Case counting(project, makeProgram("p", {move("home"), step("loop", {{"times", 0}, {"variable", "n"}},
                                                                    {move("pick"), move("place")})}));
        QCOMPARE(counting.recovery(4), Recovery::Unsafe);
        QVERIFY2(counting.mark(4).reason.contains("n"), qPrintable(counting.mark(4).reason));
    }

    void cancelledCheckIsIncomplete() {
        project::Project project = sampleProject();
        project.programs.append(trayProgram(project));
        const QUuid id = project.programs.at(0).id;
        RecoveryOptions options;
        options.preview.isCancelled = [] { return true; };
        QVERIFY(!checkRecovery(project, id, writeScript(project, id), {}, options).isComplete);
    }

    void executedStopsAgreeWithTheMarksOfRandomPrograms() {
        const project::Project project = sampleProject();
        std::map<Recovery, int> seen;
        int programs = 0;
        for (quint32 seed = 0; seed < 16; ++seed) {
            RandomMoves maker(seed, project);
            const project::Program program = maker.program();
            Case made(project, program,
                      {{0, 0, seed % 2 == 0}, {1 + 0.1 * maker.below(10), 1, true}, {3, 1, false}});
            if (!made.script.ok()) {
                continue;  // e.g. blends that are too large
            }
            ++programs;
            QVERIFY(made.map.isComplete);
            for (int i = 0; i < 2; ++i) {
                const StopPoint& point = made.map.points.at(
                    static_cast<std::size_t>(maker.below(static_cast<int>(made.map.points.size()))));
                const StopKind kind = kStopKinds.at(static_cast<std::size_t>(maker.below(4)));
                const QString wrong = made.disagreement(point, kind);
                QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(wrong)));
                ++seen[point.marks[static_cast<std::size_t>(kind)].recovery];
            }
        }
        QVERIFY2(programs > 8, qPrintable(QString::number(programs)));
        QVERIFY(seen[Recovery::Continue] > 0);
        QVERIFY(seen[Recovery::MoveBack] > 3);
        QVERIFY(seen[Recovery::Unsafe] > 3);
    }
};

QTEST_APPLESS_MAIN(TestProgramRecover)
#include "tst_program_recover.moc"
