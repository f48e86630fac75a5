// SPDX-License-Identifier: MIT
// One interface for every robot. The same calls bring a simulated e-Series robot, a CB3 and a PolyScope X
// robot from power off to a running program, and each robot reports its properties.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "robot/dashboard/robot_service.h"
#include "robot/simulator/simulator.h"
#include "tests/support/raw_peer.h"

using namespace tiller;
using namespace tiller::dashboard;

Q_DECLARE_METATYPE(tiller::SoftwareVersion)

namespace {

Deadline testTimeout() {
    return Deadline::after(std::chrono::seconds(60));
}

struct Robot {
    explicit Robot(const SoftwareVersion& software, bool poweredOn = false)
        : controller([&] {
            simulator::SimulatorOptions options;
            options.software = software;
            options.model = software.isCb3() ? RobotModelId::UR5 : RobotModelId::UR5e;
            options.anyFreePorts = true;
            options.fastTransitions = true;
            options.poweredOn = poweredOn;
            const QByteArray script = "def wait():\\n  while True:\\n    sleep(1)\\n  end\\nend\\n";
            write("wait.urp", QByteArray(script).replace("\\n", "\n"));
            write("wait.urpx", "{\"script\":\"" + script + "\"}");
            options.programsFolder = programs.path();
            return options;
        }()) {
        const auto started = controller.start();
        if (!started) {
            qFatal("%s", qPrintable(started.error().toString()));
        }
        const simulator::Ports ports = controller.ports();
        const bool x = software.isPolyScopeX();
        auto opened =
            openService({controller.listenAddress(), x ? test::RawPeer::deadPort() : ports.dashboard,
                         x ? ports.robotApi : test::RawPeer::deadPort()},
                        testTimeout());
        if (!opened) {
            qFatal("%s", qPrintable(opened.error().toString()));
        }
        service = std::move(opened).value();
    }
    void write(const char* name, const QByteArray& content) {
        QFile file(programs.filePath(QLatin1String(name)));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) {
            qFatal("%s cannot be written", name);
        }
    }
    Result<void> perform(RobotCommand command) { return service->perform(command, testTimeout()); }

    QTemporaryDir programs;
    simulator::Simulator controller;
    std::unique_ptr<RobotService> service;
};

void everySoftware() {
    QTest::addColumn<SoftwareVersion>("software");
    QTest::newRow("CB3") << SoftwareVersion{3, 15, 8, 0};
    QTest::newRow("e-Series") << SoftwareVersion{5, 22, 1, 0};
    QTest::newRow("PolyScope X 10.12") << SoftwareVersion{10, 12, 0, 0};
    QTest::newRow("PolyScope X 10.11") << SoftwareVersion{10, 11, 0, 0};
}

}  // namespace

class TestRobotService : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theSameCallsPowerEveryRobot_data() { everySoftware(); }
    void theSameCallsPowerEveryRobot() {
        QFETCH(SoftwareVersion, software);
        Robot robot(software);
        QCOMPARE(robot.service->kind(),
                 software.isPolyScopeX() ? ServiceKind::RobotApi : ServiceKind::Dashboard);
        const auto reaches = [&](RobotMode wanted) {
            return QTest::qWaitFor([&] { return robot.controller.truth().robotMode == wanted; }, 60'000);
        };
        QVERIFY(reaches(RobotMode::PowerOff));
        QVERIFY(robot.perform(RobotCommand::PowerOn).ok());
        QVERIFY(reaches(RobotMode::Idle));
        QVERIFY(robot.perform(RobotCommand::ReleaseBrakes).ok());
        QVERIFY(reaches(RobotMode::Running));
        QVERIFY(robot.perform(RobotCommand::PowerOff).ok());
        QVERIFY(reaches(RobotMode::PowerOff));
    }

    void theSameCallsRunAProgram_data() { everySoftware(); }
    void theSameCallsRunAProgram() {
        QFETCH(SoftwareVersion, software);
        Robot robot(software, true);
        const QString name =
            software.isPolyScopeX() ? QStringLiteral("wait.urpx") : QStringLiteral("wait.urp");
        const auto loaded = robot.service->loadProgram(name, testTimeout());
        QVERIFY2(loaded.ok(), qPrintable(loaded.error().toString()));
        const auto reaches = [&](RuntimeState wanted) {
            return QTest::qWaitFor([&] { return robot.controller.truth().runtimeState == wanted; }, 60'000);
        };
        for (const auto& [command, state] : {std::pair{RobotCommand::Play, RuntimeState::Playing},
                                             {RobotCommand::Pause, RuntimeState::Paused},
                                             {RobotCommand::Play, RuntimeState::Playing},
                                             {RobotCommand::StopProgram, RuntimeState::Stopped}}) {
            const auto done = robot.perform(command);
            QVERIFY2(done.ok(), qPrintable(done.error().toString()));
            QVERIFY(reaches(state));
        }
    }

    void theProgramsAreListed_data() { everySoftware(); }
    void theProgramsAreListed() {
        QFETCH(SoftwareVersion, software);
        Robot robot(software);
        const auto names = robot.service->programs(testTimeout());
        if (software >= SoftwareVersion{10, 12, 0, 0}) {
            QVERIFY2(names.ok(), qPrintable(names.error().toString()));
            QVERIFY2(names->contains("wait"), qPrintable(names->join(", ")));
        } else {
            QCOMPARE(names.error().code, ErrorCode::VersionUnsupported);
        }
    }

    void everyServiceReportsItsCapabilities() {
        {
            Robot robot({10, 12, 0, 0});
            const auto report = robot.service->look(testTimeout());
            QVERIFY(report.ok());
            QCOMPARE(report->remoteControl, std::optional(true));
            QCOMPARE(report->program, QStringLiteral("Default program"));
            QVERIFY(!report->operationalMode.isEmpty());
            robot.controller.setRemoteControl(false);
            QCOMPARE(robot.service->look(testTimeout())->remoteControl, std::optional(false));
        }
        {
            Robot robot({10, 11, 0, 0});
            const auto report = robot.service->look(testTimeout());
            QVERIFY(report.ok());
            QVERIFY2(!report->remoteControl,
                     "a remote control state is reported although this software cannot be queried for it");
        }
        {
            Robot robot({3, 15, 8, 0});
            const auto report = robot.service->look(testTimeout());
            QVERIFY(report.ok());
            QVERIFY(!report->remoteControl);
        }
        {
            Robot robot({5, 22, 1, 0});
            QCOMPARE(robot.service->look(testTimeout())->remoteControl, std::optional(true));
        }
    }

    void aProtectiveStopIsUnlockedOnRequestOnly_data() { everySoftware(); }
    void aProtectiveStopIsUnlockedOnRequestOnly() {
        QFETCH(SoftwareVersion, software);
        Robot robot(software, true);
        robot.controller.protectiveStop();
        const auto safety = [&] { return robot.controller.truth().safetyMode; };
        QTRY_COMPARE_WITH_TIMEOUT(safety(), SafetyMode::ProtectiveStop, 60'000);
        for (const RobotCommand command :
             {RobotCommand::PowerOn, RobotCommand::ReleaseBrakes, RobotCommand::ClosePopups,
              RobotCommand::Play, RobotCommand::Pause, RobotCommand::StopProgram}) {
            static_cast<void>(robot.perform(command));
        }
        QCOMPARE(safety(), SafetyMode::ProtectiveStop);
        // The dashboard refuses the command for five seconds. Afterwards, there is nothing left to unlock
        // through the Robot API.
        bool unlocked = false;
        QTRY_VERIFY_WITH_TIMEOUT(
            (unlocked = unlocked || robot.service->unlockProtectiveStop(testTimeout()).ok()), 60'000);
        QTRY_COMPARE_WITH_TIMEOUT(safety(), SafetyMode::Normal, 60'000);
    }
};

QTEST_GUILESS_MAIN(TestRobotService)
#include "tst_robot_service.moc"
