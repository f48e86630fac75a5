// SPDX-License-Identifier: MIT
//
// Check and run of a program without a session, on the simulated controller through its real ports.

#include <QTest>

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

    ExecutionBench() {
        const auto move = [this](const char* waypoint) {
            return step("moveL", {{"waypoint", waypointId(project, waypoint)}});
        };
        const project::Program made =
            makeProgram("Test", {step("loop", {{"times", 20}}, {move("pick"), move("place")})});
        project.programs.append(made);
        program = made.id;
    }
    Result<void> bringUp() {
        if (const auto started = robot.start(); !started) {
            return started;
        }
        if (const auto started = receiver.start(); !started) {
            return started;
        }
        if (const auto first = receiver.waitForData(patience()); !first) {
            return first.error();
        }
        return controller.takeControl(patience());
    }
    CheckedProgram check(PreviewOptions preview = {}) const {
        return checkForRobot(project, program, {}, preview, receiver.latest());
    }
    bool isMoving() const { return robot.truth().tcpSpeed.linear.norm() > 0.05; }
    bool isAt(const JointPositions& q) const {
        return (robot.truth().q.values - q.values).cwiseAbs().maxCoeff() < 1e-3;
    }
};

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
        const auto there = move->wait(patience());
        QVERIFY2(there.ok(), why(there).constData());

        ProgramExecution execution(bench.controller, bench.receiver.subscribe(), checked);
        const Result<void> ended = execution.wait(patience());
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
        QVERIFY(pendant.connect(patience()).ok());
        QVERIFY(pendant.send("stop program\n", patience()).ok());
        const Result<void> ended = execution.wait(patience());
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
        const Result<void> ended = execution.wait(patience());
        QVERIFY(!ended.ok());
        QVERIFY2(ended.error().toString().contains("position of the arm"), why(ended).constData());
        QVERIFY(bench.isAt(q));
    }
};

QTEST_GUILESS_MAIN(TestProgramExecution)
#include "tst_program_execution.moc"
