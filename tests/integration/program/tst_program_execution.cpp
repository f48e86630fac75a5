// SPDX-License-Identifier: MIT
//
// Check and run of a program without a session, on the simulated controller through its real ports.

#include <QTest>
#include <functional>
#include <memory>
#include <tuple>
#include <utility>

#include "program_samples.h"
#include "robot/control/controller.h"
#include "robot/control/motions.h"
#include "robot/receive/receiver.h"
#include "robot/script/script_client.h"
#include "robot/simulator/simulator.h"
#include "robot/station/program/execution/program_execution.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::program;
using namespace tiller::test;

namespace {

QString executionAddress() {
    const auto pid = static_cast<unsigned>(QCoreApplication::applicationPid());
    return QStringLiteral("127.%1.%2.24").arg(100 + pid % 100).arg((pid / 100) % 250);
}

simulator::SimulatorOptions robotOptions(const project::Project& project) {
    simulator::SimulatorOptions options;
    options.listenAddress = executionAddress();
    options.poweredOn = true;
    options.startJoints = project.waypoints.at(0).joints;
    options.fastTransitions = true;
    return options;
}

receive::ReceiverOptions receiverOptions() {
    receive::ReceiverOptions options;
    options.host = executionAddress();
    options.fields = executionFields();
    return options;
}

control::ControllerOptions controllerOptions() {
    control::ControllerOptions options;
    options.host = executionAddress();
    // A delay of a busy test computer does not end the run.
    options.dataTimeout = std::chrono::seconds(2);
    options.connectionTimeout = std::chrono::seconds(2);
    return options;
}

/// A robot under control.
struct ExecutionBench {
    project::Project project = sampleProject();
    QUuid program;
    simulator::Simulator robot{robotOptions(project)};
    receive::Receiver receiver{receiverOptions()};
    control::Controller controller{controllerOptions()};

    ExecutionBench() { setSteps({step("loop", {{"times", 20}}, {move("pick"), move("place")})}); }
    project::ProgramStep move(const char* waypoint) const {
        return step("moveL", {{"waypoint", waypointId(project, waypoint)}});
    }
    void setSteps(std::vector<project::ProgramStep> steps) {
        const project::Program made = makeProgram("Test", std::move(steps));
        project.programs.append(made);
        program = made.id;
    }
    /// Sets steps that move to "place" and switch output 1 on only if the variable "count" was changed to 7.
    void setStepsWithVariables() {
        const auto assign = [](const char* variable, const char* type, const char* value) {
            return step("assign", {{"variable", variable}, {"type", type}, {"value", value}});
        };
        setSteps(
            {assign("count", "whole", "2"), assign("depth", "number", "0.5"),
             assign("label", "text", "\"a\""), move("pick"),
             step("if", {{"condition", "count == 7"}}, {step("setOutput", {{"output", 1}}), move("place")}),
             step("wait", {{"time", 0.3}})});
    }
    Result<void> bringUp() {
        if (const auto started = robot.start(); !started) {
            return started;
        }
        if (const auto started = receiver.start(); !started) {
            return started;
        }
        if (const auto first = receiver.waitForData(testTimeout()); !first) {
            return first.error();
        }
        return controller.takeControl(testTimeout());
    }
    CheckedProgram check(PreviewOptions preview = {}) const {
        return checkForRobot(project, program, {}, preview, receiver.latest());
    }
    /// Starts the program, which pauses before the step with this number.
    std::unique_ptr<ProgramExecution> startUntil(int number) {
        const CheckedProgram checked = check();
        for (const QString& obstacle : checked.obstacles) {
            qWarning("%s", qPrintable(obstacle));
        }
        return std::make_unique<ProgramExecution>(
            controller, receiver.subscribe(), checked,
            QSet<QUuid>{checked.script.steps.at(static_cast<std::size_t>(number - 1)).step});
    }
    bool isMoving() const { return robot.truth().tcpSpeed.linear.norm() > 0.05; }
    bool isAt(const JointPositions& q) const {
        return (robot.truth().q.values - q.values).cwiseAbs().maxCoeff() < 1e-3;
    }
};

bool isWaiting(const ProgramExecution& execution) {
    return execution.status().state == ProgramExecution::State::Waiting;
}

/// The variables as "name value".
QStringList shown(const ProgramExecution& execution) {
    QStringList texts;
    for (const script::ProgramVariable& variable : execution.variables()) {
        texts << variable.name + ' ' + variable.text;
    }
    return texts;
}

/// A deadline that calls this function while a call waits. The call ends when the function returns true.
Deadline during(std::function<bool()> action) {
    return Deadline::after(std::chrono::seconds(60), CancelToken(std::move(action)));
}

}  // namespace

class TestProgramExecution : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aCheckedProgramRuns() {
        ExecutionBench bench;
        const auto up = bench.bringUp();
        QVERIFY2(up.ok(), why(up).constData());
        const CheckedProgram checked = bench.check();
        QCOMPARE(checked.obstacles, QStringList());
        ProgramExecution execution(bench.controller, bench.receiver.subscribe(), checked);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isMoving(), 60'000);
        QVERIFY(execution.isActive());
    }

    void variablesAreShownAndChangedWhileTheProgramWaits() {
        ExecutionBench bench;
        const auto up = bench.bringUp();
        QVERIFY2(up.ok(), why(up).constData());
        bench.setStepsWithVariables();
        const auto execution = bench.startUntil(5);
        QTRY_VERIFY_WITH_TIMEOUT(isWaiting(*execution), 60'000);
        const QStringList before{"count 2", "depth 0.5", "label \"a\""};
        QTRY_COMPARE_WITH_TIMEOUT(shown(*execution), before, 60'000);
        for (const auto& [name, text, reason] :
             {std::tuple("count", "2.5", "not a whole number"), std::tuple("depth", "deep", "not a number"),
              std::tuple("label", "b", "Only numbers"), std::tuple("none", "1", "no variable")}) {
            const auto refused = execution->changeVariable(name, text, testTimeout());
            QVERIFY(!refused.ok() && refused.error().code == ErrorCode::InvalidArgument);
            QVERIFY2(refused.error().toString().contains(reason), why(refused).constData());
        }
        const JointPositions q = bench.robot.truth().q;
        const auto changed = execution->changeVariable("count", "7", testTimeout());
        QVERIFY2(changed.ok(), why(changed).constData());
        QCOMPARE(shown(*execution).at(0), QStringLiteral("count 7"));
        const auto again = execution->changeVariable("depth", "-2.5", testTimeout());
        QVERIFY2(again.ok(), why(again).constData());
        QVERIFY(isWaiting(*execution) && bench.isAt(q));

        execution->resume();
        QTRY_VERIFY_WITH_TIMEOUT(bench.isMoving(), 60'000);
        const auto running = execution->changeVariable("count", "8", testTimeout());
        QVERIFY2(running.error().toString().contains("Pause the program first."), why(running).constData());
        const auto ended = execution->wait(testTimeout());
        QVERIFY2(ended.ok(), why(ended).constData());
        QVERIFY((bench.robot.truth().digitalOutputs & 2U) != 0);
        QCOMPARE(shown(*execution), (QStringList{"count 7", "depth -2.5", "label \"a\""}));
        const auto late = execution->changeVariable("count", "8", testTimeout());
        QVERIFY2(late.error().toString().contains("No program is running."), why(late).constData());
    }

    // A stop, a step of another thread and the loss of the connection end the call. None of them moves the
    // arm.
    void aChangeEndsWithTheProgram_data() {
        QTest::addColumn<QString>("event");
        for (const char* event : {"stop", "other client", "emergency stop", "cut link", "cancelled"}) {
            QTest::newRow(event) << event;
        }
    }
    void aChangeEndsWithTheProgram() {
        QFETCH(QString, event);
        ExecutionBench bench;
        const auto up = bench.bringUp();
        QVERIFY2(up.ok(), why(up).constData());
        bench.setStepsWithVariables();
        const auto execution = bench.startUntil(5);
        QTRY_VERIFY_WITH_TIMEOUT(isWaiting(*execution) && shown(*execution).size() == 3, 60'000);
        const JointPositions q = bench.robot.truth().q;
        script::ScriptClient pendant(bench.robot.listenAddress(), bench.robot.ports().primary);
        QVERIFY(pendant.connect(testTimeout()).ok());
        bool isFirst = true;
        const Result<void> changed = execution->changeVariable(
            "count", "7", during([&] {
                if (!std::exchange(isFirst, false)) {
                    return event == "cancelled";
                }
                if (event == "stop") {
                    execution->stop();
                } else if (event == "other client") {
                    (void)pendant.send("stop program\n", testTimeout());
                } else if (event != "cancelled") {
                    (void)bench.robot.inject(event == "cut link" ? "link lost" : "emergency-stop on");
                }
                return event == "cancelled";
            }));
        if (!changed.ok()) {
            QCOMPARE(changed.error().code, event == "cancelled" ? ErrorCode::Cancelled : ErrorCode::Stopped);
            QVERIFY2(changed.error().toString().contains("did not confirm"), why(changed).constData());
        } else {
            // The robot can confirm the change before it receives the event.
            QVERIFY(event == "other client" || event == "emergency stop");
        }
        QVERIFY(isWaiting(*execution) || event != "cancelled");
        execution->stop();
        QVERIFY(!execution->wait(testTimeout()).ok());
        QVERIFY(bench.isAt(q));
        QVERIFY((bench.robot.truth().digitalOutputs & 2U) == 0);
    }

    // Otherwise, the program could use the changed value when it waits again.
    void aChangeEndsWhenTheProgramContinues() {
        ExecutionBench bench;
        const auto up = bench.bringUp();
        QVERIFY2(up.ok(), why(up).constData());
        bench.setStepsWithVariables();
        const auto execution = bench.startUntil(5);
        QTRY_VERIFY_WITH_TIMEOUT(isWaiting(*execution) && shown(*execution).size() == 3, 60'000);
        const Result<void> changed = execution->changeVariable(
            "depth", "7", during([&] {
                const auto second = execution->changeVariable("count", "7", testTimeout());
                if (second.ok() || !second.error().toString().contains("another variable")) {
                    qWarning("%s", why(second).constData());
                }
                execution->resume();
                return false;
            }));
        QVERIFY(!changed.ok());
        QCOMPARE(changed.error().code, ErrorCode::Stopped);
        const auto ended = execution->wait(testTimeout());
        QVERIFY2(ended.ok(), why(ended).constData());
        QVERIFY((bench.robot.truth().digitalOutputs & 2U) == 0);
    }

    // The path from another position has not been checked.
    void anArmThatMovedAfterTheCheckIsNotMoved() {
        ExecutionBench bench;
        const auto up = bench.bringUp();
        QVERIFY2(up.ok(), why(up).constData());
        const CheckedProgram checked = bench.check();
        QCOMPARE(checked.obstacles, QStringList());
        JointPositions moved = bench.robot.truth().q;
        moved.values[0] += 0.05;
        auto move = control::Motions(bench.controller).moveJ(moved, {});
        QVERIFY2(move.ok(), why(move).constData());
        const auto there = move->wait(testTimeout());
        QVERIFY2(there.ok(), why(there).constData());

        ProgramExecution execution(bench.controller, bench.receiver.subscribe(), checked);
        const Result<void> ended = execution.wait(testTimeout());
        QVERIFY(!ended.ok());
        QCOMPARE(ended.error().code, ErrorCode::Stopped);
        QVERIFY2(ended.error().toString().contains("Move the arm to the start position first."),
                 why(ended).constData());
        QVERIFY(execution.status().state == ProgramExecution::State::Stopped);
        QVERIFY(bench.isAt(moved));
        QVERIFY(bench.controller.status().inControl);
    }

    // A rotated TCP changes the path of the waypoints as much as a shifted TCP.
    void aProgramForAnotherTcpIsRefused_data() {
        QTest::addColumn<Pose>("tcp");
        QTest::newRow("shifted") << Pose(0, 0, 0.01, 0, 0, 0);
        QTest::newRow("rotated") << Pose(0, 0, 0, 0, 0, 0.1);
    }
    void aProgramForAnotherTcpIsRefused() {
        QFETCH(const Pose, tcp);
        ExecutionBench bench;
        const auto up = bench.bringUp();
        QVERIFY2(up.ok(), why(up).constData());
        for (int i = 0; i < bench.project.waypoints.size(); ++i) {
            project::Waypoint point = bench.project.waypoints.at(i);
            point.tcpOffset = tcp;
            point.pose = kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, point.joints, tcp);
            bench.project.waypoints.replace(i, point);
        }
        const CheckedProgram checked = bench.check();
        QCOMPARE(checked.obstacles.size(), 1);
        QVERIFY2(checked.obstacles.front().contains("TCP"), qPrintable(checked.obstacles.front()));
    }

    // A halt resets the state of the program on the robot in the same way as the normal end of the program.
    void aHaltWithoutSamplesIsNotTheEndOfTheProgram() {
        ExecutionBench bench;
        const auto up = bench.bringUp();
        QVERIFY2(up.ok(), why(up).constData());
        ProgramExecution execution(bench.controller, bench.receiver.subscribe(), bench.check());
        QTRY_VERIFY_WITH_TIMEOUT(bench.isMoving() && execution.status().lastStep > 0, 60'000);
        bench.receiver.stop();
        script::ScriptClient pendant(bench.robot.listenAddress(), bench.robot.ports().primary);
        QVERIFY(pendant.connect(testTimeout()).ok());
        QVERIFY(pendant.send("stop program\n", testTimeout()).ok());
        const Result<void> ended = execution.wait(testTimeout());
        QVERIFY(!ended.ok());
        QVERIFY2(ended.error().toString().contains("unknown whether"), why(ended).constData());
        QVERIFY(execution.status().state == ProgramExecution::State::Stopped);
    }

    // Without samples, the arm position is unknown.
    void aProgramDoesNotStartWithoutSamples() {
        ExecutionBench bench;
        const auto up = bench.bringUp();
        QVERIFY2(up.ok(), why(up).constData());
        const CheckedProgram checked = bench.check();
        const JointPositions q = bench.robot.truth().q;
        bench.receiver.stop();
        ProgramExecution execution(bench.controller, bench.receiver.subscribe(), checked);
        const Result<void> ended = execution.wait(testTimeout());
        QVERIFY(!ended.ok());
        QVERIFY2(ended.error().toString().contains("position of the arm"), why(ended).constData());
        QVERIFY(bench.isAt(q));
    }
};

QTEST_GUILESS_MAIN(TestProgramExecution)
#include "tst_program_execution.moc"
