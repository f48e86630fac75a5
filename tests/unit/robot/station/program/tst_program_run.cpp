// SPDX-License-Identifier: MIT
//
// Running a program of the project through a session, on the simulated controller in virtual time.

#include <QElapsedTimer>
#include <QTest>

#include "program_samples.h"
#include "random_moves.h"
#include "random_programs.h"
#include "robot/script/script_client.h"
#include "robot/station/program/recover/steps_not_reached.h"
#include "robot/station/program/run/program_runner.h"
#include "tests/support/virtual_cell.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::program;
using namespace tiller::test;
using control::Holding;
using control::StopCause;

namespace {

constexpr int kLongMs = 60'000;
constexpr double kStandstillTime = 0.25;  ///< maximum stopping time according to the jog contract [s]

bool isStill(const simulator::SimulatedState& state) {
    return state.tcpSpeed.linear.norm() < 0.001 && state.qd.values.cwiseAbs().maxCoeff() < 0.001;
}

struct RunBench {
    VirtualClock clock;
    RobotSession session{clock};
    VirtualCell cell;
    ProgramRunner runner{session};
    project::Project project = sampleProject();
    QUuid program;
    QList<int> steps;  ///< numbers of the steps, in the order in which they ran

    QStringList changes;  ///< results of changed variables

    explicit RunBench(const JointPositions& start = sampleProject().waypoints.at(0).joints,
                      const QStringList& assumptions = {})
        : cell(clock, session, [&] {
            simulator::SimulatorOptions options = VirtualCell::options();
            options.startJoints = start;
            for (const QString& assumption : assumptions) {
                if (const auto done = simulator::assume(options.assumptions, assumption); !done) {
                    qFatal("%s", qPrintable(done.error().toString()));
                }
            }
            return options;
        }()) {
        QObject::connect(&runner, &ProgramRunner::changed, &runner, [this] {
            if (const int now = runner.log().step(); now > 0 && (steps.isEmpty() || steps.last() != now)) {
                steps.append(now);
            }
        });
        QObject::connect(&runner, &ProgramRunner::variableChanged, &runner,
                         [this](const QString& text) { changes.append(text); });
    }
    static project::ProgramStep assign(const char* variable, const char* type, const char* value) {
        return step("assign", {{"variable", variable}, {"type", type}, {"value", value}});
    }
    script::ProgramVariable variable(const char* name) const {
        const auto& list = runner.variables().list();
        const auto found = std::find_if(list.begin(), list.end(),
                                        [&](const auto& each) { return each.name == QLatin1String(name); });
        return found == list.end() ? script::ProgramVariable{} : *found;
    }
    /// Waits until the variables have these values, as "name value".
    bool showsVariables(const QStringList& expected) {
        const auto shown = [this] {
            QStringList texts;
            for (const script::ProgramVariable& each : runner.variables().list()) {
                texts << each.name + ' ' + each.text;
            }
            return texts;
        };
        if (cell.advanceUntil([&] { return shown() == expected; }, kLongMs)) {
            return true;
        }
        qWarning("%s", qPrintable(shown().join(", ")));
        return false;
    }
    void setSteps(std::vector<project::ProgramStep> list) {
        const project::Program made = makeProgram("Test", std::move(list));
        project.programs.append(made);
        program = made.id;
    }
    project::ProgramStep move(const char* waypoint) const {
        return step("moveL", {{"waypoint", waypointId(project, waypoint)}});
    }
    project::ProgramStep endless() const {
        return step("loop", {{"times", 0}}, {move("pick"), move("place")});
    }
    RunPlan plan() const { return planRun(project, program, session.state()); }
    /// Keeps the run active in every refresh, like a held button.
    void hold(RobotSession::MotionId id) {
        cell.everyRefresh = [this, id] { (void)session.hold(id); };
    }
    bool begin(Holding holding, std::int32_t permitted = script::StepGate::kUnlimited) {
        const auto begun = runner.start(plan(), holding, permitted);
        if (!begun) {
            qWarning("%s", qPrintable(begun.error().toString()));
            return false;
        }
        if (holding == Holding::Held) {
            hold(*begun);
        }
        return true;
    }
    bool reachWaiting() {
        return cell.advanceUntil([this] { return runner.isWaiting(); }, kLongMs);
    }
    bool programEnds(int atMostMs) {
        for (int ms = 0; ms < atMostMs && cell.truth().runtimeState == RuntimeState::Playing; ms += 2) {
            clock.advanceNs(2 * kNsPerMs);
            cell.robot.step();
        }
        return cell.truth().runtimeState == RuntimeState::Stopped;
    }
    bool reachStep(int step) {
        return cell.advanceUntil([this, step] { return runner.log().step() == step; }, kLongMs);
    }
    /// Triggers a named stop. Sets `linked` to false if the connection no longer transmits data.
    bool happen(const QString& stop, bool& linked) {
        if (stop == "stop key") {
            session.stop(StopCause::StopButton);
        } else if (stop == "space") {
            session.stop(StopCause::Space);
        } else if (stop == "escape") {
            session.stop(StopCause::Escape);
        } else if (stop == "device") {
            session.stop(StopCause::DeviceLost);
        } else if (stop == "runner") {
            runner.stop(StopCause::WindowClosed);
        } else if (stop == "release") {
            cell.everyRefresh = {};
            runner.stop(StopCause::Released);
        } else if (stop == "hanging window") {
            cell.everyRefresh = {};
            cell.advanceWithFrozenInterface(300);
            return isStill(cell.truth());
        } else if (stop == "release control") {
            session.releaseControl();
        } else if (stop == "monitor only") {
            session.setMonitorOnly(true);
        } else if (stop == "protective stop") {
            cell.robot.protectiveStop();
        } else if (stop == "disconnect") {
            session.disconnectFromRobot();
        } else {
            linked = false;
            return cell.robot.inject(stop).ok();
        }
        return true;
    }
    /// Sends a command or a program as another client.
    bool sendFromOutside(const char* text) {
        script::ScriptClient client(cell.robot.listenAddress(), cell.robot.ports().primary);
        return client.connect(testTimeout()).ok() &&
               client.send(QString::fromLatin1(text), testTimeout()).ok();
    }
    bool reachMotion() {
        return cell.advanceUntil([this] { return cell.truth().tcpSpeed.linear.norm() > 0.05; }, kLongMs);
    }
    /// Observes the arm for 1.4 s. Returns the time until it last moved [s]; 0 if it did not move.
    double standstill() {
        const double from = cell.truth().timestamp;
        double last = from;
        for (int i = 0; i < 700; ++i) {
            cell.advanceMs(2);
            if (!isStill(cell.truth())) {
                last = cell.truth().timestamp;
            }
        }
        return last - from;
    }
    /// Like standstill(), but for 0.7 s and without waiting for packets, because none arrive.
    double standstillWithoutLink() {
        const double from = cell.truth().timestamp;
        double last = from;
        for (int i = 0; i < 350; ++i) {
            clock.advanceNs(2 * kNsPerMs);
            cell.robot.step();
            if (!isStill(cell.truth())) {
                last = cell.truth().timestamp;
            }
        }
        return last - from;
    }
    /// Like awaitEnd(), but in real time, because the threads of the connection are involved.
    bool awaitEndWithoutLink() {
        QElapsedTimer waited;
        waited.start();
        while (runner.state() != ProgramRunner::State::Ended && waited.elapsed() < kLongMs) {
            clock.advanceNs(2 * kNsPerMs);
            cell.robot.step();
            QTest::qWait(1);
            session.refresh();
        }
        return runner.state() == ProgramRunner::State::Ended && isStill(cell.truth());
    }
    bool awaitEnd() {
        return cell.advanceUntil([this] { return runner.state() == ProgramRunner::State::Ended; }, kLongMs);
    }
};

}  // namespace

class TestProgramRun : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aProgramRunsToItsEnd() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.move("pick"), step("wait", {{"time", 0.2}}),
                        step("loop", {{"times", 2}}, {bench.move("place"), bench.move("pick")})});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.runner.isActive());
        QVERIFY(bench.session.state().programRuns);
        QVERIFY2(bench.awaitEnd(), qPrintable(QString::number(int(bench.runner.state()))));
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
        QCOMPARE(bench.steps, (QList<int>{1, 2, 4, 5, 4, 5}));
        const std::vector<StepTiming>& timings = bench.runner.log().timings();
        QCOMPARE(timings[0].count, 1);
        QCOMPARE(timings[1].count, 1);
        QVERIFY(std::abs(timings[1].total - 0.2) < 0.02);
        QCOMPARE(timings[3].count, 2);
        QVERIFY(bench.runner.endText(bench.project).contains("ended after"));
        QVERIFY(bench.session.state().canMove());
        QVERIFY(!bench.session.state().programRuns);
        const auto jog = bench.session.beginJog({.twist = Twist{{0, 0, 0.05}, {0, 0, 0}}});
        QVERIFY2(jog.ok(), qPrintable(jog ? QString() : jog.error().toString()));
        bench.session.endMotion(*jog, StopCause::Released);
        // The next run resets the counts.
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.log().timings()[3].count, 2);
    }

    void onlyTheProgramMovesTheArmDuringARun() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.endless()});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.reachMotion());
        const SessionState& state = bench.session.state();
        QCOMPARE(state.control, ControlState::InControl);
        QVERIFY(state.keysStop());
        QVERIFY(!state.hasForeignProgram());
        QVERIFY(!state.canMove());
        QVERIFY(!state.controlReason.isEmpty());
        QVERIFY(!bench.session.beginJog({.twist = Twist{{0, 0, 0.05}, {0, 0, 0}}}).ok());
        QVERIFY(!bench.runner.start(bench.plan(), Holding::Free).ok());
        bench.runner.stop(StopCause::ApiCall);
        QVERIFY(bench.awaitEnd());
    }

    void everyStopEndsARun_data() {
        QTest::addColumn<Holding>("holding");
        QTest::addColumn<QString>("stop");
        for (const Holding holding : {Holding::Held, Holding::Free}) {
            const auto row = [&](const char* stop) {
                QTest::addRow("%s, %s", stop, holding == Holding::Held ? "held" : "free")
                    << holding << QString::fromLatin1(stop);
            };
            for (const char* stop :
                 {"stop key", "space", "escape", "device", "runner", "release control", "monitor only",
                  "link lost", "half-open", "silence on", "protective stop", "disconnect"}) {
                row(stop);
            }
            if (holding == Holding::Held) {
                row("release");
                row("hanging window");
            }
        }
    }
    void everyStopEndsARun() {
        QFETCH(Holding, holding);
        QFETCH(QString, stop);
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.endless()});
        QVERIFY(bench.begin(holding));
        QVERIFY(bench.reachMotion());
        bench.cell.advanceMs(100);
        bool linked = true;
        QVERIFY2(bench.happen(stop, linked), qPrintable(stop));
        const double time = linked ? bench.standstill() : bench.standstillWithoutLink();
        QVERIFY2(time <= kStandstillTime, qPrintable(QString::number(time)));
        QVERIFY(isStill(bench.cell.truth()));
        QVERIFY(linked ? bench.awaitEnd() : bench.awaitEndWithoutLink());
        QVERIFY(bench.runner.end() == ProgramRunner::End::Stopped ||
                bench.runner.end() == ProgramRunner::End::Failed);
        if (stop == "protective stop") {
            QVERIFY2(bench.runner.isStoppedInLastStep(), qPrintable(bench.runner.endText(bench.project)));
        }
        QVERIFY2(bench.runner.endText(bench.project).contains("MoveL"),
                 qPrintable(bench.runner.endText(bench.project)));
        QVERIFY((linked ? bench.standstill() : bench.standstillWithoutLink()) == 0);
        static const QStringList kKeepControl{"stop key", "space",   "escape",        "device",
                                              "runner",   "release", "hanging window"};
        QCOMPARE(bench.session.state().canMove(), kKeepControl.contains(stop));
    }

    void aStopOnTheRobotIsNotTheEndOfTheProgram_data() {
        QTest::addColumn<Holding>("holding");
        QTest::newRow("held") << Holding::Held;
        QTest::newRow("free") << Holding::Free;
    }
    void aStopOnTheRobotIsNotTheEndOfTheProgram() {
        QFETCH(const Holding, holding);
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.move("pick"), bench.move("place"), bench.move("pick")});
        QVERIFY(bench.begin(holding));
        QVERIFY(bench.reachStep(2));
        QVERIFY(bench.sendFromOutside("stop program\n"));
        QVERIFY(bench.awaitEnd());
        const QString text = bench.runner.endText(bench.project);
        QVERIFY2(text.contains("Stopped in step 2 (MoveL)"), qPrintable(text));
        QVERIFY2(text.contains("on the robot"), qPrintable(text));
        QVERIFY(bench.runner.isStoppedInLastStep());
        QVERIFY(bench.standstill() == 0);
        // A person stopped the program on the robot, so control is not taken again without a request.
        QVERIFY(bench.session.state().control == ControlState::None);
        QCOMPARE(bench.cell.truth().runtimeState, RuntimeState::Stopped);
        bench.session.takeControl();
        QVERIFY(bench.cell.advanceUntil([&] { return bench.session.state().canMove(); }, kLongMs));
        // The next run of the same program completes.
        QVERIFY(bench.begin(holding));
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
    }

    // A halt resets the state of the program on the robot in the same way as the normal end of the program.
    void anEndWithoutSamplesIsUnknown() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.move("pick"), bench.move("place"), bench.move("pick")});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.reachStep(2));
        QObject::disconnect(&bench.session, &RobotSession::samplesReceived, &bench.runner, nullptr);
        QVERIFY(bench.sendFromOutside("stop program\n"));
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Unknown);
        const QString text = bench.runner.endText(bench.project);
        QVERIFY2(text.contains("step: 2 (MoveL)") && text.contains("unknown whether"), qPrintable(text));
        QVERIFY(!bench.runner.isStoppedInLastStep());
    }

    void aProgramThatEndsItselfIsComplete() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        for (const project::ProgramStep& last : {step("end"), step("wait", {{"time", 0.002}})}) {
            bench.setSteps({last});
            QVERIFY(bench.begin(Holding::Free));
            QVERIFY(bench.awaitEnd());
            QVERIFY2(bench.runner.end() == ProgramRunner::End::Completed,
                     qPrintable(bench.runner.endText(bench.project)));
        }
    }

    void aProgramThatReplacesTheRunIsNamed() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.endless()});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.reachMotion());
        QVERIFY(bench.sendFromOutside("def other():\n  while True:\n    sync()\n  end\nend\n"));
        QVERIFY(bench.awaitEnd());
        const QString text = bench.runner.endText(bench.project);
        QVERIFY2(text.contains("Stopped in step 2 (MoveL)"), qPrintable(text));
        QVERIFY2(text.contains("another client"), qPrintable(text));
        QVERIFY(!bench.runner.isStoppedInLastStep());
        QCOMPARE(bench.cell.truth().runtimeState, RuntimeState::Playing);
        QVERIFY(bench.session.state().control != ControlState::InControl);
    }

    // A program that waits must not move the arm after a stop.
    void aStopEndsAWaitingProgram() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({step("wait", {{"time", 0.5}}), bench.endless()});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.reachStep(1));
        bench.session.stop(StopCause::StopButton);
        QVERIFY(bench.standstill() == 0);
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Stopped);
        QVERIFY(bench.session.state().canMove());
    }

    // The pause begins during step 1, or during the first step inside it.
    void aRunPausesAtStandstillBeforeTheNextStep_data() {
        using Steps = std::vector<project::ProgramStep>;
        QTest::addColumn<Steps>("first");
        QTest::addColumn<int>("running");  ///< step at the time of the pause
        QTest::addColumn<int>("waiting");
        const RunBench bench;
        const auto wait = [] { return step("wait", {{"time", 0.3}}); };
        const auto there = [&](const char* kind, QJsonObject fields = {}) {
            fields.insert("waypoint", waypointId(bench.project, "place"));
            return step(kind, fields);
        };
        const auto row = [](const char* name, const Steps& steps, int running, int waiting) {
            QTest::newRow(name) << steps << running << waiting;
        };
        row("moveJ", {there("moveJ")}, 1, 2);
        row("moveL", {there("moveL")}, 1, 2);
        row("moveL with blend", {there("moveL", {{"blend", 0.02}})}, 1, 2);
        row("moveP with blend", {there("moveP", {{"blend", 0.02}})}, 1, 2);
        row("moveRelative", {step("moveRelative", {{"x", -0.1}})}, 1, 2);
        row("moveUntil", {step("moveUntil", {{"until", "distance"}, {"axes", "base"}, {"distance", 0.02}})},
            1, 2);
        row("moveGroup", {step("moveGroup", {{"group", "row"}})}, 1, 2);
        row("wait", {wait()}, 1, 2);
        row("waitInput", {step("waitInput", {{"input", 2}, {"timeLimit", 0.3}, {"otherwise", "continue"}})},
            1, 2);
        row("waitCondition",
            {step("waitCondition", {{"condition", "DI2"}, {"timeLimit", 0.3}, {"otherwise", "continue"}})}, 1,
            2);
        row("pulse", {step("pulseOutput", {{"output", 2}, {"time", 0.3}})}, 1, 2);
        row("gripper", {step("gripper", {{"action", "close"}, {"time", 0.3}})}, 1, 2);
        row("script", {step("script", {{"text", "sleep(0.3)"}})}, 1, 2);
        row("loop", {step("loop", {{"times", 2}}, {wait(), there("moveL")})}, 2, 3);
        row("end of an iteration", {step("loop", {{"times", 2}}, {there("moveL"), wait()})}, 3, 2);
        row("while",
            {step("while", {{"condition", "not DO1"}}, {wait(), step("setOutput", {{"output", 1}})})}, 2, 3);
        row("for each",
            {step("forEachWaypoint", {{"group", "row"}, {"variable", "at"}},
                  {step("moveL", {{"pose", "at"}}), wait()})},
            2, 3);
        row("if", {step("if", {{"condition", "not DI2"}}, {wait(), there("moveL")})}, 2, 3);
        row("else",
            {step("if", {{"condition", "DI2"}}, {there("moveL")}),
             step("else", {}, {wait(), there("moveL")})},
            4, 5);
        row("switch", {step("switch", {{"value", "1"}}, {step("case", {{"value", "1"}}, {wait(), wait()})})},
            3, 4);
        row("try", {step("try", {}, {wait(), there("moveL")}), step("onError", {}, {wait()})}, 2, 3);
        row("on error", {step("try", {}, {step("fail")}), step("onError", {}, {wait(), there("moveL")})}, 4,
            5);
        row("end of a force section",
            {step("force", {{"axes", "base"}, {"force", 5}}, {wait(), there("moveL")})}, 2, 4);
        row("speed section", {step("speed", {{"factor", 0.5}}, {wait(), there("moveL")})}, 2, 3);
        row("folder", {step("folder", {}, {wait(), there("moveL")})}, 2, 3);
    }
    void aRunPausesAtStandstillBeforeTheNextStep() {
        QFETCH(std::vector<project::ProgramStep>, first);
        QFETCH(int, running);
        QFETCH(int, waiting);
        RunBench bench;
        // The sample steps refer to waypoints of another project.
        const std::function<void(std::vector<project::ProgramStep>&)> bind = [&](auto& list) {
            for (project::ProgramStep& each : list) {
                if (!each.fields["waypoint"].toString().isEmpty()) {
                    each.fields["waypoint"] = waypointId(bench.project, "place");
                }
                bind(each.steps);
            }
        };
        bind(first);
        first.push_back(bench.move("pick"));
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps(first);
        QVERIFY2(bench.plan().obstacle.isEmpty(), qPrintable(bench.plan().obstacle));
        PreviewOptions fromHere;
        fromHere.start = bench.session.state().q;
        const Preview expected = previewProgram(bench.project, bench.plan().script,
                                                optionsFor(bench.project, bench.session.state()), fromHere);
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.reachStep(running));
        bench.runner.pause();
        QVERIFY(bench.runner.isPaused() && !bench.runner.isWaiting());
        const int begun = bench.runner.log().begun();
        QVERIFY2(bench.reachWaiting(),
                 qPrintable(QStringLiteral("paused after %1 steps, %2 begun, state %3: %4")
                                .arg(begun)
                                .arg(bench.runner.log().begun())
                                .arg(int(bench.runner.state()))
                                .arg(bench.runner.endText(bench.project))));
        QCOMPARE(bench.runner.log().step(), waiting);
        bench.standstill();
        QVERIFY(isStill(bench.cell.truth()));
        QVERIFY(bench.standstill() == 0);
        QVERIFY(bench.runner.isWaiting());
        QCOMPARE(bench.cell.truth().runtimeState, RuntimeState::Playing);
        QVERIFY(!bench.session.state().canMove());
        bench.runner.resume();
        QVERIFY(!bench.runner.isPaused());
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
        QVERIFY((bench.cell.truth().q.values - expected.endJoints.values).cwiseAbs().maxCoeff() < 0.002);
        // No step ran twice because of the wait.
        QCOMPARE(bench.runner.log().timings()[static_cast<std::size_t>(waiting - 1)].count,
                 expected.timings[static_cast<std::size_t>(waiting - 1)].count);
    }

    void aPauseBeforeTheStartHoldsTheFirstStep() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.move("pick"), bench.move("place")});
        QVERIFY(bench.begin(Holding::Free));
        bench.runner.pause();
        QVERIFY(bench.reachWaiting());
        QCOMPARE(bench.runner.log().step(), 1);
        QVERIFY(bench.standstill() == 0);
        // The next run is not paused.
        bench.runner.stop(StopCause::StopButton);
        QVERIFY(bench.awaitEnd());
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(!bench.runner.isPaused());
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
    }

    void aRunPausesAtBreakpoints() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        // The second and third step follow each other in one control period.
        bench.setSteps(
            {step("wait", {{"time", 0.1}}),
             step("loop", {{"times", 2}}, {step("setOutput", {{"output", 1}}), bench.move("place")}),
             step("force", {{"axes", "base"}, {"force", 5}}, {step("wait", {{"time", 0.1}})})});
        const ProgramScript script = bench.plan().script;
        const auto id = [&](int number) {
            return script.steps.at(static_cast<std::size_t>(number - 1)).step;
        };
        QVERIFY(script.canPauseBefore(id(3)) && script.canPauseBefore(id(4)));
        QVERIFY2(!script.canPauseBefore(id(6)), "a pause is permitted in the force section");
        bench.runner.setBreakpoints({id(3), id(4), id(6)});
        QVERIFY(bench.begin(Holding::Free));
        const auto reach = [&](int number) {
            return bench.reachWaiting() && bench.runner.isPaused() && bench.runner.log().step() == number &&
                   bench.standstill() == 0 && bench.runner.isWaiting();
        };
        QVERIFY(reach(3));
        bench.runner.resume();
        QVERIFY(bench.reachStep(4));
        QVERIFY(reach(4));
        // A single step, the end with the cycle and a pause do not continue the program.
        bench.runner.step();
        QVERIFY(bench.reachStep(3));
        QVERIFY(reach(3));
        bench.runner.setEndsWithCycle(true);
        bench.runner.setEndsWithCycle(false);
        bench.runner.pause();
        QVERIFY(reach(3));
        bench.runner.resume();
        QVERIFY(bench.reachStep(4));
        QVERIFY(reach(4));
        // Removing a breakpoint does not move the arm.
        bench.runner.setBreakpoints({});
        QVERIFY(reach(4));
        bench.runner.resume();
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
        QCOMPARE(bench.runner.log().timings()[3].count, 2);
        // A breakpoint that is removed during a run affects neither the run nor the displayed state.
        bench.runner.setBreakpoints({id(3)});
        QVERIFY(bench.begin(Holding::Free));
        bench.runner.setBreakpoints({});
        int waits = 0;
        const auto counting = QObject::connect(&bench.runner, &ProgramRunner::changed, &bench.runner,
                                               [&] { waits += bench.runner.isWaiting() ? 1 : 0; });
        QVERIFY(bench.awaitEnd());
        QObject::disconnect(counting);
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
        QCOMPARE(waits, 0);
    }

    // The robot may reach the breakpoint in the batch of samples in which the run begins.
    void aRunPausesAtABreakpointOfItsFirstStep() {
        for (int offset = 0; offset < 8; ++offset) {
            RunBench bench;
            QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
            bench.setSteps({step("wait", {{"time", 0.1}}), bench.move("place")});
            bench.runner.setBreakpoints({bench.plan().script.steps.at(0).step});
            bench.cell.advanceMs(2 * offset);
            QVERIFY(bench.begin(Holding::Free));
            QVERIFY(bench.reachWaiting());
            QCOMPARE(bench.runner.log().step(), 1);
            QVERIFY(bench.standstill() == 0 && bench.runner.isWaiting());
            bench.runner.step();
            QVERIFY(bench.cell.advanceUntil([&] { return bench.runner.log().begun() == 1; }, kLongMs));
            QVERIFY(bench.reachWaiting());
            QCOMPARE(bench.runner.log().step(), 2);
            bench.runner.stop(StopCause::StopButton);
            QVERIFY(bench.awaitEnd());
            // A single step passes the breakpoint, and a held run does not stop there.
            QVERIFY(bench.begin(Holding::Free, 1));
            QVERIFY(bench.reachWaiting());
            QCOMPARE(bench.runner.log().step(), 2);
            bench.runner.stop(StopCause::StopButton);
            QVERIFY(bench.awaitEnd());
            if (offset == 0) {
                QVERIFY(bench.begin(Holding::Held));
                QVERIFY(bench.awaitEnd());
                QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
            }
        }
    }

    void aStopEndsARunAtABreakpoint() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({step("wait", {{"time", 0.1}}), bench.endless()});
        bench.runner.setBreakpoints({bench.plan().script.steps.at(2).step});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.reachWaiting());
        bench.session.stop(StopCause::Space);
        QVERIFY(bench.standstill() == 0);
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Stopped);
        // The next run waits there again, and a removed breakpoint has no effect after the end.
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.reachWaiting());
        bench.runner.stop(StopCause::StopButton);
        QVERIFY(bench.awaitEnd());
        bench.runner.setBreakpoints({});
        QVERIFY(bench.standstill() == 0);
    }

    void variablesAreShownAndChangedAtABreakpoint_data() {
        QTest::addColumn<QString>("assumption");
        for (const char* assumption :
             {"inputs=whole", "inputs=first-half", "inputs=last-half", "inputs=scattered",
              "outputs=next-period", "registers=zeroed", "thread-order=main-first"}) {
            QTest::newRow(assumption) << assumption;
        }
    }
    void variablesAreShownAndChangedAtABreakpoint() {
        QFETCH(QString, assumption);
        RunBench bench(sampleProject().waypoints.at(0).joints, {assumption});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps(
            {bench.assign("count", "whole", "2"), bench.assign("depth", "number", "0.5"),
             bench.assign("done", "flag", "False"), bench.assign("label", "text", "\"a\""),
             step("script", {{"text", "global own = 4"}}), bench.move("pick"),
             step("while", {{"condition", "count > 2 and done and depth == -2.5"}}, {bench.move("place")}),
             step("setOutput", {{"output", 1}})});
        const ProgramScript script = bench.plan().script;
        QVERIFY2(!script.text.contains("tiller_take_change"),
                 "the exported script waits for changes from a PC");
        bench.runner.setBreakpoints({script.steps.at(5).step, script.steps.at(6).step});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.reachWaiting());
        QVERIFY(bench.showsVariables({"count 2", "depth 0.5", "done False", "label \"a\"", "own 4"}));
        const auto variable = [&](const char* name) { return bench.variable(name); };
        QVERIFY(bench.runner.changeObstacle(variable("count")).isEmpty());
        QVERIFY(bench.runner.changeObstacle(variable("label")).contains("Only numbers"));
        QVERIFY(bench.runner.changeObstacle(variable("own")).contains("“Set variable” step"));
        for (const auto& [name, text] :
             {std::pair("count", "2.5"), std::pair("count", "3000000000"), std::pair("depth", "deep"),
              std::pair("depth", "nan"), std::pair("done", "1"), std::pair("label", "b"),
              std::pair("own", "5"), std::pair("unknown", "5")}) {
            QVERIFY2(!bench.runner.changeVariable(name, text), name);
        }
        QVERIFY(bench.runner.isWaiting() && bench.runner.variables().pending().isEmpty());
        // A change neither moves the arm nor continues the program.
        const auto change = [&](const char* name, const char* text) {
            const qsizetype changes = bench.changes.size();
            if (!bench.runner.changeVariable(name, text) ||
                bench.runner.variables().pending() != QLatin1String(name) ||
                bench.runner.changeVariable(name, text)) {
                return false;
            }
            bench.runner.resume();
            bench.runner.step();
            return bench.cell.advanceUntil([&] { return bench.changes.size() > changes; }, kLongMs) &&
                   bench.runner.isWaiting() && bench.standstill() == 0;
        };
        QVERIFY(change("count", "7"));
        QVERIFY(change("depth", "-2.5"));
        QVERIFY(change("done", "true"));
        QCOMPARE(bench.changes, (QStringList{"Variable “count”: 2 → 7", "Variable “depth”: 0.5 → -2.5",
                                             "Variable “done”: False → True"}));
        QCOMPARE(variable("count").text, QStringLiteral("7"));
        QVERIFY(bench.runner.variables().pending().isEmpty());
        // After it has been resumed, the program uses the changed values.
        bench.runner.resume();
        QVERIFY(bench.reachStep(7));
        QVERIFY(bench.reachWaiting());
        QVERIFY(change("count", "-2147483648"));
        QVERIFY(change("count", "2147483647"));
        bench.runner.resume();
        QVERIFY(bench.reachStep(8));
        QVERIFY(bench.runner.changeObstacle(variable("count")).contains("Pause the program"));
        QVERIFY(!bench.runner.changeVariable("count", "3"));
        bench.runner.pause();
        QVERIFY(bench.reachWaiting());
        QVERIFY(
            bench.showsVariables({"count 2147483647", "depth -2.5", "done True", "label \"a\"", "own 4"}));
        QVERIFY(change("done", "False"));
        bench.runner.resume();
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
        QVERIFY(bench.runner.changeObstacle(variable("count")).contains("No program is running"));
        QCOMPARE(variable("count").text, QStringLiteral("2147483647"));  // the last values
    }

    // A later step can still set the variable, although the registers contain the change.
    void aChangeIsTakenOnce() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({step("wait", {{"time", 0.1}}), bench.assign("n", "whole", "1"),
                        step("wait", {{"time", 0.1}}), step("wait", {{"time", 0.1}})});
        QVERIFY(bench.begin(Holding::Free, 1));
        QVERIFY(bench.reachWaiting());
        QVERIFY(bench.showsVariables({"n 0"}));
        QVERIFY(bench.runner.changeVariable("n", "5"));
        QVERIFY(bench.cell.advanceUntil([&] { return bench.changes.size() == 1; }, kLongMs));
        for (int i = 0; i < 2; ++i) {
            const int begun = bench.runner.log().begun();
            bench.runner.step();
            QVERIFY(bench.cell.advanceUntil([&] { return bench.runner.log().begun() > begun; }, kLongMs));
            QVERIFY(bench.reachWaiting());
            bench.cell.advanceMs(300);
            QVERIFY(bench.showsVariables({"n 1"}));
        }
        bench.runner.stop(StopCause::StopButton);
        QVERIFY(bench.awaitEnd());
    }

    void aChangeThatTheRobotDoesNotTakeIsReported() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.assign("n", "whole", "1"), bench.move("pick"), bench.move("place")});
        QVERIFY(bench.begin(Holding::Free, 1));
        QVERIFY(bench.reachWaiting());
        QVERIFY(bench.showsVariables({"n 1"}));
        // The change is made before the session has detected the pause on the teach pendant.
        QVERIFY(bench.sendFromOutside("pause program\n"));
        while (bench.cell.truth().runtimeState != RuntimeState::Paused) {
            bench.clock.advanceNs(2 * kNsPerMs);
            bench.cell.robot.step();
        }
        QVERIFY(bench.runner.changeVariable("n", "5"));
        QVERIFY(bench.cell.advanceUntil([&] { return bench.runner.isPausedOnRobot(); }, kLongMs));
        QVERIFY(bench.runner.changeObstacle(bench.variable("n")).contains("teach pendant"));
        QVERIFY(bench.cell.advanceUntil([&] { return bench.changes.size() == 1; }, kLongMs));
        QVERIFY2(bench.changes.at(0).contains("did not confirm"), qPrintable(bench.changes.at(0)));
        // The change has no effect when the program is resumed.
        QVERIFY(bench.sendFromOutside("run program\n"));
        QVERIFY(bench.cell.advanceUntil([&] { return !bench.runner.isPausedOnRobot(); }, kLongMs));
        bench.cell.advanceMs(500);
        QVERIFY(bench.runner.isWaiting());
        QVERIFY(bench.showsVariables({"n 1"}));
        bench.runner.stop(StopCause::StopButton);
        QVERIFY(bench.awaitEnd());
    }

    // A stop before the robot has confirmed a change ends the run, and the next run does not apply the
    // change.
    void aStopDuringAChangeEndsTheRun() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({step("wait", {{"time", 0.1}}), step("wait", {{"time", 0.1}}),
                        bench.assign("n", "whole", "1"), bench.endless()});
        for (int run = 0; run < 2; ++run) {
            QVERIFY(bench.begin(Holding::Free, 1));
            QVERIFY(bench.reachWaiting());
            bench.cell.advanceMs(300);
            QVERIFY(bench.showsVariables({"n 0"}));
            QVERIFY(bench.runner.changeVariable("n", "5"));
            bench.session.stop(StopCause::Escape);
            QVERIFY(bench.standstill() == 0);
            QVERIFY(bench.awaitEnd());
            QCOMPARE(bench.runner.end(), ProgramRunner::End::Stopped);
            QCOMPARE(bench.runner.variables().pending(), QString());
        }
        QVERIFY(bench.changes.isEmpty());
    }

    void valuesStayFixedIfAChangeCouldMoveTheArm_data() {
        QTest::addColumn<bool>("inWatch");
        QTest::newRow("thread") << false;
        QTest::newRow("parallel watch") << true;
    }
    void valuesStayFixedIfAChangeCouldMoveTheArm() {
        QFETCH(bool, inWatch);
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const QString move = QStringLiteral("movej([0, -1.6, 1.6, -1.5, -1.5, 0])\n");
        bench.setSteps({bench.assign("go", "flag", "False"),
                        inWatch ? step("watch", {{"condition", "go"}}, {step("script", {{"text", move}})})
                                : step("script", {{"text", "thread mover():\nwhile not go:\nsync()\nend\n" +
                                                               move + "end\nmovers = run mover()"}}),
                        step("wait", {{"time", 0.1}}), bench.move("pick")});
        bench.runner.setBreakpoints({bench.plan().script.steps.back().step});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.reachWaiting());
        QVERIFY(bench.cell.advanceUntil([&] { return bench.variable("go").text == "False"; }, kLongMs));
        QVERIFY(bench.runner.changeObstacle(bench.variable("go")).contains("URScript step"));
        QVERIFY(!bench.runner.changeVariable("go", "True"));
        bench.cell.advanceMs(500);
        QVERIFY(bench.standstill() == 0);
        bench.runner.stop(StopCause::StopButton);
        QVERIFY(bench.awaitEnd());
    }

    void theVariablesAndTheNodeOfAnotherProgramAreShown() {
        RunBench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(
            bench.sendFromOutside("def other():\n  global parts = 3\n  $ 2 \"Wait for part\"\n  while "
                                  "True:\n    sync()\n  end\nend\n"));
        QVERIFY(bench.cell.advanceUntil(
            [&] {
                return !bench.session.state().programNode.isEmpty() && bench.session.state().programVariables;
            },
            kLongMs));
        QCOMPARE(bench.session.state().programNode, QStringLiteral("Wait for part"));
        const auto parts = [&] { return bench.session.state().programVariables->front(); };
        QVERIFY(bench.cell.advanceUntil([&] { return parts().text == "3"; }, kLongMs));
        QCOMPARE(parts().name, QStringLiteral("parts"));
        QVERIFY(bench.showsVariables({"parts 3"}));
        QVERIFY(bench.runner.changeObstacle(bench.variable("parts")).contains("another client"));
        QVERIFY(!bench.runner.changeVariable("parts", "4"));
        QVERIFY(bench.sendFromOutside("stop program\n"));
        QVERIFY(bench.cell.advanceUntil([&] { return !bench.session.state().programVariables; }, kLongMs));
        QCOMPARE(bench.session.state().programNode, QString());
        QVERIFY(bench.showsVariables({}));
    }

    void singleStepsRunInTheOrderOfTheModel() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps(
            {step("assign", {{"variable", "n"}, {"type", "whole"}, {"value", "0"}}),
             step("loop", {{"times", 2}},
                  {bench.move("pick"), step("setOutput", {{"output", 1}}), bench.move("place")}),
             step("try", {}, {step("wait", {{"time", 0.1}}), step("fail")}),
             step("onError", {}, {step("wait", {{"time", 0.1}})}),
             step("if", {{"condition", "n > 0"}}, {step("wait")}), step("else", {}, {bench.move("home")}),
             step("switch", {{"value", "n"}},
                  {step("case", {{"value", "1"}}, {step("wait")}), step("default", {}, {step("folder")})}),
             step("forEachWaypoint", {{"group", "row"}, {"variable", "at"}},
                  {step("moveL", {{"pose", "at"}, {"blend", 0.005}})})});
        QVERIFY2(bench.plan().obstacle.isEmpty(), qPrintable(bench.plan().obstacle));
        PreviewOptions fromHere;
        fromHere.start = bench.session.state().q;
        const Preview model = previewProgram(bench.project, bench.plan().script,
                                             optionsFor(bench.project, bench.session.state()), fromHere);
        QVERIFY(bench.begin(Holding::Free, 0));
        std::vector<int> order;
        while (bench.cell.advanceUntil(
            [&] { return bench.runner.isWaiting() || bench.runner.state() == ProgramRunner::State::Ended; },
            kLongMs)) {
            if (bench.runner.state() == ProgramRunner::State::Ended) {
                break;
            }
            QCOMPARE(bench.runner.log().begun(), static_cast<int>(order.size()));
            order.push_back(bench.runner.log().step());
            bench.runner.step();
            bench.runner.step();  // has no effect until the program waits again
            const int begun = static_cast<int>(order.size());
            QVERIFY(bench.cell.advanceUntil(
                [&] { return bench.runner.log().begun() >= begun || !bench.runner.isWaiting(); }, kLongMs));
        }
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
        QCOMPARE(order, model.order);
    }

    void aRunEndsWithItsCycle_data() {
        QTest::addColumn<QString>("change");
        for (const char* change :
             {"while running", "while paused", "in a section", "with a blend", "withdrawn"}) {
            QTest::newRow(change) << QString::fromLatin1(change);
        }
    }
    void aRunEndsWithItsCycle() {
        QFETCH(QString, change);
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        project::ProgramStep last = bench.move("place");
        last.fields["blend"] = change == "with a blend" ? 0.02 : 0.0;
        const auto endless =
            step("loop", {{"times", 0}}, {bench.move("pick"), step("loop", {}, {bench.move("home")}), last});
        const bool isNested = change == "in a section";
        bench.setSteps(isNested ? std::vector{step("try", {}, {endless}), step("onError", {}, {step("wait")})}
                                : std::vector{endless});
        const int pick = isNested ? 3 : 2;
        const int place = pick + 3;
        QVERIFY(!bench.plan().script.cycles.empty());
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.reachStep(pick + 2));
        if (change == "while paused") {
            bench.runner.pause();
            QVERIFY(bench.reachWaiting());
        }
        bench.runner.setEndsWithCycle(true);
        QVERIFY(bench.runner.endsWithCycle());
        if (change == "while paused") {
            bench.cell.advanceMs(100);
            QVERIFY(bench.runner.isWaiting());
            bench.runner.resume();
        }
        if (change == "withdrawn") {
            bench.runner.setEndsWithCycle(false);
            QVERIFY(bench.reachStep(place));
            QVERIFY(bench.reachStep(pick));
            bench.runner.setEndsWithCycle(true);
        }
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
        QCOMPARE(bench.runner.log().timings()[static_cast<std::size_t>(place - 1)].count,
                 change == "withdrawn" ? 2 : 1);
        // The arm has completed the last move.
        const double distance = distanceMm(bench.cell.truth().tcpPose, bench.project.waypoints.at(2).pose);
        QVERIFY2(distance < 0.5, qPrintable(QString::number(distance)));
        QVERIFY(bench.session.state().canMove());
        // The next run does not end early.
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(!bench.runner.endsWithCycle());
    }

    void countedLoopsAreNoCycle() {
        RunBench bench;
        bench.setSteps({step("loop", {{"times", 3}}, {bench.move("pick")})});
        QVERIFY(bench.plan().script.cycles.empty());
        QVERIFY(!bench.plan().script.gatedText().contains("tiller_turn"));
    }

    void aRunFromAStepEqualsTheTailOfTheFullRun() {
        project::Project project = sampleProject();
        const auto move = [&](const char* kind, const char* waypoint) {
            return step(kind, {{"waypoint", waypointId(project, waypoint)}});
        };
        const project::Program program = makeProgram(
            "Test",
            {move("moveJ", "pick"), step("setOutput", {{"output", 1}}), move("moveL", "place"),
             step("loop", {{"times", 2}}, {move("moveL", "home"), step("moveRelative", {{"x", 0.05}})}),
             step("wait", {{"time", 0.1}}), step("moveRelative", {{"z", 0.03}}),
             step("if", {{"condition", "DI1"}}, {step("wait")}), step("else", {}, {move("moveJ", "pick")}),
             step("speed", {{"factor", 0.5}}, {move("moveL", "row 1")})});
        project.programs.append(program);
        const ProgramScript script = writeScript(project, program.id);
        QVERIFY(script.ok());
        const Preview full = previewProgram(project, script);
        QVERIFY(full.isGood());
        int starts = 0;
        for (const project::ProgramStep& first : program.steps) {
            const StartStepChoice choice = chooseStartStep(project, program.id, first.id, {}, script, &full);
            if (first.kind == "else") {
                QVERIFY(!choice.start && !choice.obstacle.isEmpty());
                continue;
            }
            QVERIFY2(choice.start, qPrintable(choice.obstacle));
            ScriptOptions options;
            options.from = first.id;
            PreviewOptions fromThere;
            fromThere.start = choice.start->q;
            const Preview tail =
                previewProgram(project, writeScript(project, program.id, options), options, fromThere);
            QVERIFY(tail.isGood());
            const auto begin = std::find(full.order.begin(), full.order.end(), script.numberOf(first.id));
            QCOMPARE(tail.order, (std::vector<int>(begin, full.order.end())));
            QVERIFY((tail.endPose.position - full.endPose.position).norm() < 0.0005);
            ++starts;
        }
        QCOMPARE(starts, 8);
        const QUuid fourth = program.steps[3].id;
        QVERIFY(!chooseStartStep(project, program.id, fourth, {}, script, nullptr).obstacle.isEmpty());
        QVERIFY(!chooseStartStep(project, program.id, program.steps[3].steps[0].id, {}, script, &full)
                     .obstacle.isEmpty());

        // Runs the program in a session. The run is refused unless the arm is at the start position of the
        // step.
        const StartStep start = *chooseStartStep(project, program.id, fourth, {}, script, &full).start;
        {
            RunBench elsewhere;
            QVERIFY2(elsewhere.cell.bringUp(), qPrintable(elsewhere.cell.what()));
            const RunPlan refused = planRun(project, program.id, elsewhere.session.state(), {}, start);
            QVERIFY2(refused.obstacle.contains("start position"), qPrintable(refused.obstacle));
            QVERIFY(!elsewhere.runner.start(refused, Holding::Held).ok());
        }
        RunBench there(start.q);
        QVERIFY2(there.cell.bringUp(), qPrintable(there.cell.what()));
        const RunPlan plan = planRun(project, program.id, there.session.state(), {}, start);
        QVERIFY2(plan.obstacle.isEmpty(), qPrintable(plan.obstacle));
        QVERIFY(there.runner.start(plan, Holding::Free).ok());
        QVERIFY(there.awaitEnd());
        QCOMPARE(there.runner.end(), ProgramRunner::End::Completed);
        QVERIFY(there.steps.front() >= 4);
        QVERIFY((there.cell.truth().q.values - full.endJoints.values).cwiseAbs().maxCoeff() < 0.002);
    }

    // The end positions must agree within 0.1 mm, and the durations within 1 %.
    void previewsOfRandomProgramsEqualTheRun_data() {
        QTest::addColumn<int>("first");
        for (int first = 0; first < 200; first += 25) {
            QTest::addRow("programs %d to %d", first + 1, first + 25) << first;
        }
    }
    void previewsOfRandomProgramsEqualTheRun() {
        QFETCH(int, first);
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const project::Project project = bench.project;
        auto seed = static_cast<quint32>(1000 + 1000 * first);
        for (int done = 0; done < 25; ++seed) {
            RandomMoves maker(seed, project);
            project::Program made = maker.program();
            // The preview also includes the braking of the arm after the program.
            made.steps.push_back(step("wait", {{"time", 0.1}}));
            bench.project = project;
            bench.project.programs.append(made);
            bench.program = made.id;
            const RunPlan plan = bench.plan();
            // Not ok: e.g. blends that are too large. In a force section, the noise of the sensor moves the
            // arm.
            if (!plan.script.ok() || plan.script.text.contains("force_mode(")) {
                continue;
            }
            QVERIFY2(plan.obstacle.isEmpty(), qPrintable(plan.obstacle));
            PreviewOptions fromHere;
            fromHere.start = bench.session.state().q;
            fromHere.timeLimit = 60;
            fromHere.operatorTime = 1e6;  // no operator closes a message
            const Preview preview = previewProgram(
                bench.project, plan.script, optionsFor(bench.project, bench.session.state()), fromHere);
            if (!preview.isGood()) {
                continue;
            }
            QVERIFY(bench.begin(Holding::Free));
            QVERIFY(bench.awaitEnd());
            const QByteArray what = "seed " + QByteArray::number(seed);
            QVERIFY2(bench.runner.end() == ProgramRunner::End::Completed, what);
            const double distance = distanceMm(bench.cell.truth().tcpPose, preview.endPose);
            QVERIFY2(distance < 0.1, what + ": " + QByteArray::number(distance) + " mm");
            const double seconds = bench.runner.log().seconds();
            // [s]; the preview includes the runtime state Stopping after the program, the run does not
            constexpr double kStopping = 0.03;
            constexpr double kPeriods = 0.006;  // [s]; resolution of both times
            QVERIFY2(
                seconds < 1.01 * preview.duration + kPeriods && seconds > 0.99 * preview.duration - kStopping,
                what + ": " + QByteArray::number(seconds) + " s, preview " +
                    QByteArray::number(preview.duration) + " s");
            ++done;
        }
    }

    void aStepThatThePreviewDoesNotReachIsRefused() {
        project::Project project = sampleProject();
        const project::Program program = makeProgram("Test", {step("wait"), step("end"), step("wait")});
        project.programs.append(program);
        const ProgramScript script = writeScript(project, program.id);
        const Preview full = previewProgram(project, script);
        const StartStepChoice choice =
            chooseStartStep(project, program.id, program.steps[2].id, {}, script, &full);
        QVERIFY2(choice.obstacle.contains("does not reach"), qPrintable(choice.obstacle));
    }

    void everyStopEndsAPausedRun_data() { everyStopEndsARun_data(); }
    void everyStopEndsAPausedRun() {
        QFETCH(Holding, holding);
        QFETCH(QString, stop);
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.endless()});
        QVERIFY(bench.begin(holding));
        QVERIFY(bench.reachMotion());
        bench.runner.pause();
        QVERIFY(bench.reachWaiting());
        bench.standstill();
        bool linked = true;
        QVERIFY2(bench.happen(stop, linked), qPrintable(stop));
        QVERIFY(bench.runner.isWaiting() || !bench.runner.isActive() ||
                bench.runner.state() == ProgramRunner::State::Stopping);
        if (linked) {
            bench.cell.advanceMs(static_cast<int>(1000 * kStandstillTime));
        } else {
            QVERIFY(bench.programEnds(static_cast<int>(1000 * kStandstillTime)));
        }
        // A late resume has no effect.
        bench.runner.resume();
        QVERIFY((linked ? bench.standstill() : bench.standstillWithoutLink()) == 0);
        QVERIFY(linked ? bench.awaitEnd() : bench.awaitEndWithoutLink());
        QVERIFY(bench.runner.end() == ProgramRunner::End::Stopped ||
                bench.runner.end() == ProgramRunner::End::Failed);
        QVERIFY((linked ? bench.standstill() : bench.standstillWithoutLink()) == 0);
    }

    // The button is released while the program is being sent.
    void aReleaseBeforeTheStartPreventsTheRun() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.endless()});
        QVERIFY(bench.begin(Holding::Held));
        bench.cell.everyRefresh = {};
        bench.runner.stop(StopCause::Released);
        QVERIFY(bench.standstill() == 0);
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Stopped);
        QVERIFY2(bench.runner.endText(bench.project).contains("before the first step"),
                 qPrintable(bench.runner.endText(bench.project)));
        QVERIFY(bench.session.state().canMove());
        QVERIFY(bench.begin(Holding::Held));
        QVERIFY(bench.reachMotion());
    }

    // A hold that began before the connection was lost must not keep a new run active.
    void aButtonOfAnEarlierConnectionDoesNotHoldARun() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.endless()});
        const auto earlier = bench.runner.start(bench.plan(), Holding::Held);
        QVERIFY(earlier.ok());
        bench.session.disconnectFromRobot();
        bench.cell.robot.stop();
        bench.session.refresh();
        QVERIFY(!bench.runner.isActive());
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.begin(Holding::Held));
        QVERIFY(bench.reachMotion());
        QVERIFY(!bench.session.hold(*earlier));
        bench.hold(*earlier);
        QVERIFY(bench.awaitEnd());
        // The run can end a few cycles before the arm has finished braking.
        const double braking = bench.standstill();
        QVERIFY2(braking <= kStandstillTime, qPrintable(QString::number(braking)));
        QVERIFY(bench.standstill() == 0);
    }

    void aHeldRunDoesNotStartWithoutRefresh() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.endless()});
        QVERIFY(bench.begin(Holding::Held));
        bench.cell.everyRefresh = {};
        bench.cell.advanceWithFrozenInterface(500);
        // If the program started within 100 ms of the press, it has ended by now.
        QVERIFY(isStill(bench.cell.truth()));
        QVERIFY(bench.standstill() == 0);
        QVERIFY(bench.awaitEnd());
    }

    void failingStepsAreNamed() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.move("pick"), step("fail", {{"text", "no part"}})});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::StepFailed);
        QVERIFY2(bench.runner.endText(bench.project).contains("Step 2 (Fail)"),
                 qPrintable(bench.runner.endText(bench.project)));
    }

    void scriptErrorsAreReported() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.move("pick"), step("script", {{"text", "unknown_function(1)"}})});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Failed);
        QVERIFY2(bench.runner.endText(bench.project).contains("unknown_function"),
                 qPrintable(bench.runner.endText(bench.project)));
    }

    void runsAreRefusedWithTheReason() {
        RunBench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.endless()});
        QVERIFY(!bench.plan().obstacle.isEmpty());
        QVERIFY(!bench.runner.start(bench.plan(), Holding::Held).ok());
        QVERIFY(
            !bench.session.beginProgram("p", "def p():\nend\n", Holding::Free, bench.session.stops()).ok());
        bench.session.takeControl();
        QVERIFY(bench.cell.advanceUntil([&] { return bench.session.state().canMove(); }, kLongMs));
        QCOMPARE(bench.plan().obstacle, QString());

        project::Project other = bench.project;
        other.robot = RobotModelId::UR10e;
        const QString model = planRun(other, bench.program, bench.session.state()).obstacle;
        QVERIFY2(model.contains("UR10e"), qPrintable(model));
        other = bench.project;
        for (int i = 0; i < other.waypoints.size(); ++i) {
            project::Waypoint point = other.waypoints.at(i);
            point.tcpOffset.position.z() += 0.1;
            other.waypoints.replace(i, point);
        }
        const QString tcp = planRun(other, bench.program, bench.session.state()).obstacle;
        QVERIFY2(tcp.contains("TCP"), qPrintable(tcp));
        const QString wrong = planRun(other, QUuid::createUuid(), bench.session.state()).obstacle;
        QVERIFY(!wrong.isEmpty());

        collision::CellSurroundings cell;
        cell.unplaced.push_back({"box", "table"});
        bench.session.setSurroundings(cell);
        const auto unplaced = bench.runner.start(bench.plan(), Holding::Held);
        QVERIFY(!unplaced.ok());
        QVERIFY2(unplaced.error().toString().contains("box"), qPrintable(unplaced.error().toString()));
        bench.session.setSurroundings({});

        bench.session.setProjectGuard([] { return QStringLiteral("another project"); });
        QVERIFY(!bench.runner.start(bench.plan(), Holding::Held).ok());
        bench.session.setProjectGuard([] { return QString(); });
        QVERIFY(!bench.runner.isActive());
        QVERIFY(bench.standstill() == 0);
        QVERIFY(bench.session.state().canMove());
    }

    void invalidProgramsMoveNothing() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const JointPositions before = bench.cell.truth().q;
        InvalidPrograms programs;
        for (int i = 0; i < 500; ++i) {
            const InvalidProgram invalid = programs.next();
            const RunPlan plan = planRun(invalid.project, invalid.program, bench.session.state());
            QVERIFY2(plan.obstacle.startsWith("Step "), qPrintable(plan.obstacle));
            QVERIFY(plan.script.text.isEmpty());
            for (const Holding holding : {Holding::Held, Holding::Free}) {
                const auto begun = bench.runner.start(plan, holding);
                QVERIFY(!begun.ok() && begun.error().toString().contains(plan.obstacle));
            }
            QVERIFY(!bench.runner.isActive());
            bench.cell.advanceMs(4);
            QVERIFY(bench.cell.truth().q.values == before.values);
        }
        QVERIFY(bench.standstill() == 0);
        QVERIFY(bench.session.state().canMove());  // the control program still runs
    }

    void runsWithoutAHeldButtonNeedAPreviewFromTheStart() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.move("pick"), bench.move("place")});
        const RunPlan plan = bench.plan();
        const auto why = [&](const Preview* preview, const QString& text) {
            return obstacleWithoutHold(plan.obstacle, plan.script.text, bench.session.state(), preview, text);
        };
        QVERIFY(!why(nullptr, {}).isEmpty());
        const ScriptOptions options = optionsFor(bench.project, bench.session.state());
        PreviewOptions fromHere;
        fromHere.start = bench.session.state().q;
        Preview preview = previewProgram(bench.project, plan.script, options, fromHere);
        QVERIFY(preview.isGood());
        QCOMPARE(why(&preview, plan.script.text), QString());
        QVERIFY(!why(&preview, "def other():\nend\n").isEmpty());
        // The first waypoint is at a different position.
        const Preview elsewhere = previewProgram(bench.project, plan.script, options);
        QVERIFY(why(&elsewhere, plan.script.text).contains("start position"));
        preview.findings.push_back({Finding::Kind::Collision, 1, 0, "near"});
        QVERIFY(!why(&preview, plan.script.text).isEmpty());
    }

    void slowedDurationFollowsTheLimits() {
        Preview preview;
        Pose there;
        there.position.x() = 0.1;
        preview.path = {{0, 1, {}, {}}, {0.5, 1, {}, there}, {2.5, 2, {}, there}};
        QCOMPARE(slowedDuration(preview, {}, 1), 2.5);
        QCOMPARE(slowedDuration(preview, {.tool = 0.05}, 1), 4.0);
        QCOMPARE(slowedDuration(preview, {.tool = 0.05}, 0.5), 8.0);
        preview.path[2].q = JointPositions(0.4, 0, 0, 0, 0, 0);
        QCOMPARE(slowedDuration(preview, {.tool = 0.05, .joint = 0.1}, 1), 6.0);
        QCOMPARE(slowedDuration({}, {}, 1), 0.0);
    }

    void jointMovesOfAHeldRunKeepTheTcpSpeed_data() {
        QTest::addColumn<bool>("previewed");
        QTest::newRow("previewed") << true;
        QTest::newRow("without preview") << false;
    }
    void jointMovesOfAHeldRunKeepTheTcpSpeed() {
        QFETCH(const bool, previewed);
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        // Base, shoulder and elbow turn together.
        project::Waypoint far = bench.project.waypoints.at(0);
        far.id = QUuid::createUuid();
        far.name = QStringLiteral("far");
        far.joints.values += (Vector6() << 0.5, 0.4, 0.4, 0, 0, 0).finished();
        far.pose =
            kinematics::forwardTcp(robotModel(bench.session.state().model).dh, far.joints, far.tcpOffset);
        bench.project.waypoints.append(far);
        bench.setSteps({step("moveJ", {{"waypoint", waypointId(bench.project, "far")}})});
        std::optional<Preview> preview;
        if (previewed) {
            PreviewOptions options;
            options.start = bench.session.state().q;
            preview = previewProgram(bench.project, bench.plan().script, {}, options);
            QVERIFY(preview->completed);
        }
        constexpr double kTool = 0.1;
        const SpeedLimits limits = heldLimits(kTool, 2, bench.session.state(), preview ? &*preview : nullptr);
        const RunPlan plan = planRun(bench.project, bench.program, bench.session.state(), limits);
        QVERIFY2(plan.obstacle.isEmpty(), qPrintable(plan.obstacle));
        const auto begun = bench.runner.start(plan, Holding::Held);
        QVERIFY(begun.ok());
        bench.hold(*begun);
        double fastest = 0;
        QVERIFY(bench.cell.advanceUntil(
            [&] {
                fastest = std::max(fastest, bench.cell.truth().tcpSpeed.linear.norm());
                return bench.runner.state() == ProgramRunner::State::Ended;
            },
            kLongMs));
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
        QVERIFY2(fastest <= kTool * 1.02, qPrintable(QString::number(fastest)));
        QVERIFY2(fastest >= kTool * (previewed ? 0.85 : 0.1), qPrintable(QString::number(fastest)));
    }

    // The joint moves of a branch that the preview did not run may need a lower speed limit.
    void stepsThatThePreviewDidNotRunAreKnown() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const auto previewOf = [&](const std::vector<project::ProgramStep>& steps) {
            bench.setSteps(steps);
            PreviewOptions options;
            options.start = bench.session.state().q;
            return previewProgram(bench.project, bench.plan().script, {}, options);
        };
        const auto notRun = [&](const Preview& preview) {
            return stepNumbersText(stepsNotRun(bench.project, bench.plan().script, preview));
        };
        const project::ProgramStep move = step("moveJ", {{"waypoint", waypointId(bench.project, "pick")}});
        QCOMPARE(notRun(previewOf({move, step("comment", {{"text", "x"}})})), QString("steps "));
        QCOMPARE(notRun(previewOf({step("if", {{"condition", "True"}}, {move})})), QString("steps "));
        const std::vector<project::ProgramStep> branch{step("if", {{"condition", "False"}}, {move, move})};
        QCOMPARE(notRun(previewOf({bench.move("place"), branch.front()})), QString("step 4"));
        // All steps of the branch are named, also those that do not matter for the question.
        QCOMPARE(
            notRun(previewOf(
                {step("if", {{"condition", "False"}},
                      {bench.move("pick"), step("setOutput", {{"output", 0}}),
                       step("loop", {{"times", 2}}, {bench.move("pick"), step("comment", {{"text", "x"}})})}),
                 bench.move("place")})),
            QString("steps 2 to 5"));
        QCOMPARE(notRun(previewOf({step("if", {{"condition", "False"}}, {step("setOutput", {{"output", 0}})}),
                                   bench.move("place")})),
                 QString("steps "));
        QCOMPARE(stepNumbersText({2, 5, 6, 7, 9}), QString("steps 2, 5 to 7, 9"));
        QCOMPARE(stepNumbersText({12}), QString("step 12"));
    }

    void aRefusedStartKeepsThePreviousRun() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.move("pick")});
        QVERIFY(bench.begin(Holding::Free));
        QVERIFY(bench.awaitEnd());
        const QString script = bench.runner.script().text;
        const double seconds = bench.runner.log().seconds();
        bench.session.setProjectGuard([] { return QStringLiteral("other TCP"); });
        bench.setSteps({bench.move("place"), bench.move("pick")});
        QVERIFY(!bench.runner.start(bench.plan(), Holding::Free).ok());
        QCOMPARE(bench.runner.state(), ProgramRunner::State::Ended);
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Completed);
        QCOMPARE(bench.runner.script().text, script);
        QCOMPARE(bench.runner.log().seconds(), seconds);
    }

    void aVariableOfUrscriptTextNamesTheReason() {
        RunVariables variables;
        variables.begin({});
        script::ProgramVariable variable;
        variable.name = "count";
        variable.type = script::ProgramVariable::Type::Whole;
        QVERIFY2(variables.fixedReason(variable).contains("URScript"),
                 qPrintable(variables.fixedReason(variable)));
    }

    void aCollisionOfThePreviewIsNamed() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.move("pick")});
        Preview preview;
        QVERIFY(collisionText(bench.project, bench.plan().script, preview).isEmpty());
        preview.findings.push_back({Finding::Kind::StepFailed, 1, 0.5, QStringLiteral("failed")});
        QVERIFY(collisionText(bench.project, bench.plan().script, preview).isEmpty());
        preview.findings.push_back({Finding::Kind::Collision, 1, 1.5, QStringLiteral("too close")});
        QVERIFY(collisionText(bench.project, bench.plan().script, preview).contains("too close"));
    }

    void aStopWhileTheProgramIsSentNamesItsCause() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.endless()});
        QVERIFY(bench.begin(Holding::Free));
        QCOMPARE(bench.runner.state(), ProgramRunner::State::Sending);
        bench.session.stop(StopCause::Space);
        QVERIFY(bench.cell.advanceUntil([&] { return bench.runner.state() == ProgramRunner::State::Ended; },
                                        kLongMs));
        QCOMPARE(bench.runner.end(), ProgramRunner::End::Stopped);
        QVERIFY2(bench.runner.endText(bench.project).contains("Space"),
                 qPrintable(bench.runner.endText(bench.project)));
        QVERIFY(isStill(bench.cell.truth()));
    }

    void speedLimitsSlowTheMoves() {
        RunBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.setSteps({bench.move("pick"), bench.move("place")});
        const RunPlan plan =
            planRun(bench.project, bench.program, bench.session.state(), {.tool = 0.02, .joint = 0.1});
        QVERIFY2(plan.obstacle.isEmpty(), qPrintable(plan.obstacle));
        const auto begun = bench.runner.start(plan, Holding::Held);
        QVERIFY(begun.ok());
        bench.hold(*begun);
        double fastest = 0;
        bench.cell.advanceUntil(
            [&] {
                fastest = std::max(fastest, bench.cell.truth().tcpSpeed.linear.norm());
                return bench.runner.log().step() == 2;
            },
            kLongMs);
        QVERIFY2(fastest > 0.015 && fastest < 0.021, qPrintable(QString::number(fastest)));
    }
};

QTEST_MAIN(TestProgramRun)
#include "tst_program_run.moc"
