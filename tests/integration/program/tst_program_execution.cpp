// SPDX-License-Identifier: MIT
//
// Check and run of a program without a session, on the simulated controller through its real ports.

#include <QTest>

#include "program_samples.h"
#include "robot/control/controller.h"
#include "robot/receive/receiver.h"
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
};

}  // namespace

class TestProgramExecution : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // A rotated TCP changes the path of the waypoints as much as a shifted one.
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
};

QTEST_GUILESS_MAIN(TestProgramExecution)
#include "tst_program_execution.moc"
