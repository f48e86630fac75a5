// SPDX-License-Identifier: MIT
// The dashboard commands and their effects on power, safety, modes and connections.
#include <QTest>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

class TestDashboardService : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void repliesAreExact_data() {
        QTest::addColumn<QByteArray>("command");
        QTest::addColumn<QByteArray>("reply");
        const auto row = [](const char* command, const char* reply) {
            QTest::newRow(command) << QByteArray(command) << QByteArray(reply);
        };
        row("robotmode", "Robotmode: RUNNING");
        row("RobotMode", "Robotmode: RUNNING");
        row("safetymode", "Safetymode: NORMAL");
        row("safetystatus", "Safetystatus: NORMAL");
        row("running", "Program running: false");
        row("programState", "STOPPED <unnamed>");
        row("get loaded program", "No program loaded");
        row("load missing.urp", "File not found: missing.urp");
        row("load installation x.installation", "File not found: x.installation");
        row("play", "Failed to execute: play");
        row("pause", "Failed to execute: pause");
        row("stop", "Stopped");
        row("power on", "Powering on");
        row("brake release", "Brake releasing");
        row("unlock protective stop", "Protective stop releasing");
        row("close safety popup", "closing safety popup");
        row("popup hello there", "showing popup");
        row("close popup", "closing popup");
        row("addToLog something", "Added log message");
        row("addToLog", "No log message to add");
        row("saveLog", "Log saved to disk");
        row("PolyscopeVersion", "URSoftware 5.22.1.1214193 (Mar 12 2025)");
        row("version", "5.22.1.1214193");
        row("get robot model", "UR5");
        row("is in remote control", "true");
        row("set operational mode automatic", "Operational mode AUTOMATIC is set");
        row("set operational mode x", "Failed setting operational mode: x");
        row("get operational mode", "NONE");
        row("setUserRole programmer", "could not understand: 'setUserRole programmer'");
        row("make coffee", "could not understand: 'make coffee'");
        row("", "could not understand: ''");
        row("  robotmode \r", "Robotmode: RUNNING");
    }
    void repliesAreExact() {
        QFETCH(QByteArray, command);
        QFETCH(QByteArray, reply);
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.greeting, QByteArray("Connected: Universal Robots Dashboard Server\n"));
        QCOMPARE(dashboard.ask(command), reply + '\n');
    }

    void cb3HasUserRolesButNoRemoteControl() {
        auto options = VirtualRobot::options();
        options.model = RobotModelId::UR5;
        options.software = {3, 15, 8, 106339};
        VirtualRobot robot(options);
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.ask("setUserRole operator"), QByteArray("Setting user role: operator\n"));
        QCOMPARE(dashboard.ask("getUserRole"), QByteArray("OPERATOR\n"));
        QVERIFY(dashboard.ask("is in remote control").startsWith("could not understand"));
        QCOMPARE(dashboard.ask("PolyscopeVersion"), QByteArray("URSoftware 3.15.8.106339 (Jun 20 2022)\n"));
    }

    void thePowerCycleOfTheClientLibraryTestsWorks() {
        VirtualRobot robot(VirtualRobot::poweredOff());
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.ask("power off"), QByteArray("Powering off\n"));
        QVERIFY(robot.untilMode(dashboard, "POWER_OFF"));
        QCOMPARE(dashboard.ask("power on"), QByteArray("Powering on\n"));
        QVERIFY(robot.untilMode(dashboard, "POWER_ON"));
        QVERIFY(robot.untilMode(dashboard, "BOOTING"));
        QVERIFY(robot.untilMode(dashboard, "IDLE"));
        QCOMPARE(dashboard.ask("brake release"), QByteArray("Brake releasing\n"));
        QVERIFY(robot.untilMode(dashboard, "RUNNING"));
        QCOMPARE(dashboard.ask("power on"), QByteArray("Powering on\n"));
        robot.controller.stepSeconds(1);
        QVERIFY(robot.untilMode(dashboard, "RUNNING"));
        QCOMPARE(dashboard.ask("power off"), QByteArray("Powering off\n"));
        QVERIFY(robot.untilMode(dashboard, "POWER_OFF"));
        QCOMPARE(dashboard.ask("brake release"), QByteArray("Brake releasing\n"));
        QVERIFY(robot.untilMode(dashboard, "RUNNING"));
    }

    void aProtectiveStopCanBeUnlockedOnlyAfterFiveSeconds() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        RawPrimary primary = robot.primary();
        primary.send("def p():\n  protective_stop()\nend\n");
        robot.controller.drainSockets();
        QVERIFY(robot.stepUntil(
            [&] { return dashboard.ask("safetymode") == "Safetymode: PROTECTIVE_STOP\n"; }, 1));
        QCOMPARE(dashboard.ask("safetystatus"), QByteArray("Safetystatus: PROTECTIVE_STOP\n"));
        QCOMPARE(dashboard.ask("robotmode"), QByteArray("Robotmode: RUNNING\n"));
        const QByteArray refusal =
            "Cannot unlock protective stop until 5s after occurrence. Always inspect cause of protective "
            "stop "
            "before unlocking\n";
        QCOMPARE(dashboard.ask("unlock protective stop"), refusal);
        robot.controller.stepSeconds(4.9);
        QCOMPARE(dashboard.ask("unlock protective stop"), refusal);
        QCOMPARE(dashboard.ask("safetymode"), QByteArray("Safetymode: PROTECTIVE_STOP\n"));
        robot.controller.stepSeconds(0.1);
        QCOMPARE(dashboard.ask("unlock protective stop"), QByteArray("Protective stop releasing\n"));
        QVERIFY(robot.stepUntil([&] { return dashboard.ask("safetymode") == "Safetymode: NORMAL\n"; }, 1));
        QCOMPARE(dashboard.ask("robotmode"), QByteArray("Robotmode: RUNNING\n"));
    }

    void commandsExistFromTheirVersionOn_data() {
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::addColumn<QByteArray>("command");
        QTest::addColumn<bool>("exists");
        const auto row = [](int major, int minor, const char* command, bool exists) {
            QTest::addRow("%s in %d.%d", command, major, minor)
                << major << minor << QByteArray(command) << exists;
        };
        row(5, 3, "safetystatus", false);
        row(5, 4, "safetystatus", true);
        row(3, 10, "safetystatus", false);
        row(3, 11, "safetystatus", true);
        row(5, 5, "get serial number", false);
        row(5, 6, "get serial number", true);
        row(3, 12, "get robot model", true);
        row(3, 11, "get robot model", false);
        row(5, 5, "is in remote control", false);
        row(5, 6, "is in remote control", true);
        row(3, 15, "is in remote control", false);
        row(5, 0, "set operational mode manual", true);
        row(3, 15, "set operational mode manual", false);
        row(5, 5, "get operational mode", false);
        row(5, 7, "generate flight report", false);
        row(5, 8, "generate flight report", true);
        row(3, 13, "generate flight report", true);
        row(5, 8, "saveLog", true);
        row(3, 12, "saveLog", false);
        row(3, 6, "restart safety", false);
        row(3, 7, "restart safety", true);
        row(5, 0, "restart safety", false);
        row(5, 1, "restart safety", true);
        row(3, 15, "getUserRole", true);
        row(5, 22, "getUserRole", false);
        row(3, 15, "version", false);
        row(5, 0, "version", true);
    }
    void commandsExistFromTheirVersionOn() {
        QFETCH(int, major);
        QFETCH(int, minor);
        QFETCH(QByteArray, command);
        QFETCH(bool, exists);
        auto options = VirtualRobot::options();
        options.software = {quint32(major), quint32(minor), 0, 0};
        options.model = major == 3 ? RobotModelId::UR5 : RobotModelId::UR5e;
        VirtualRobot robot(options);
        const QByteArray reply = robot.dashboard().ask(command);
        QVERIFY2(reply.startsWith("could not understand") != exists, reply);
    }

    void stopEndsAProgramSentOverASocket() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        RawPrimary primary = robot.primary();
        primary.send("def p():\n  sleep(100)\nend\n");
        robot.controller.drainSockets();
        robot.controller.step(2);
        QCOMPARE(dashboard.ask("running"), QByteArray("Program running: true\n"));
        QCOMPARE(dashboard.ask("programState"),
                 QByteArray("STOPPED <unnamed>\n"));  // the loaded program
        QCOMPARE(dashboard.ask("stop"), QByteArray("Stopped\n"));
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 1));
    }

    void theOperationalModeIsSetAndCleared() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.ask("set operational mode AUTOMATIC"),
                 QByteArray("Operational mode AUTOMATIC is set\n"));
        QCOMPARE(dashboard.ask("get operational mode"), QByteArray("AUTOMATIC\n"));
        QVERIFY(dashboard.ask("clear operational mode")
                    .startsWith("No longer controlling the operational mode."));
        QCOMPARE(dashboard.ask("get operational mode"), QByteArray("NONE\n"));
    }

    void restartingTheSafetySystemClearsViolationAndFault() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        robot.controller.fault();
        robot.controller.step(2);
        QCOMPARE(dashboard.ask("safetymode"), QByteArray("Safetymode: FAULT\n"));
        QCOMPARE(dashboard.ask("robotmode"), QByteArray("Robotmode: POWER_OFF\n"));
        dashboard.ask("power on");
        robot.controller.stepSeconds(3);
        QCOMPARE(dashboard.ask("robotmode"), QByteArray("Robotmode: POWER_OFF\n"));
        QCOMPARE(dashboard.ask("restart safety"), QByteArray("Restarting safety\n"));
        robot.controller.step(2);
        QCOMPARE(dashboard.ask("safetymode"), QByteArray("Safetymode: NORMAL\n"));
        dashboard.ask("brake release");
        QVERIFY(robot.untilMode(dashboard, "RUNNING"));
    }

    void commandsInLocalControlAreRefusedOnAGatedRobot() {
        auto options = VirtualRobot::options();
        options.remoteControl = false;
        options.gateLocalControl = true;
        {
            VirtualRobot robot(options);  // clients on the controller itself have all permissions
            QCOMPARE(robot.dashboard().ask("power off"), QByteArray("Powering off\n"));
        }
        options.gateLoopbackClients = true;
        VirtualRobot robot(options);
        RawDashboard dashboard = robot.dashboard();
        const QByteArray refusal =
            "Command is not allowed due to safety reasons, please switch robot to Remote Control mode and "
            "reconnect to port 29999\n";
        for (const char* command : {"power on", "power off", "brake release", "unlock protective stop",
                                    "play", "stop", "pause", "load x.urp", "restart safety", "shutdown"}) {
            QCOMPARE(dashboard.ask(command), refusal);
        }
        QCOMPARE(dashboard.ask("is in remote control"), QByteArray("false\n"));
        QCOMPARE(dashboard.ask("popup x"), QByteArray("showing popup\n"));
        robot.controller.setRemoteControl(true);
        robot.controller.drainSockets();
        // The permissions are determined when a client connects.
        QCOMPARE(dashboard.ask("power on"), refusal);
        RawDashboard remote = robot.dashboard();
        QCOMPARE(remote.ask("power on"), QByteArray("Powering on\n"));
        // Switching to Local revokes the permissions, and switching back does not restore them.
        robot.controller.setRemoteControl(false);
        robot.controller.drainSockets();
        QCOMPARE(remote.ask("power on"), refusal);
        robot.controller.setRemoteControl(true);
        robot.controller.drainSockets();
        QCOMPARE(remote.ask("power on"), refusal);
        QCOMPARE(robot.dashboard().ask("power on"), QByteArray("Powering on\n"));
    }

    void quitClosesOnlyItsOwnConnection() {
        VirtualRobot robot;
        RawDashboard leaving = robot.dashboard();
        RawDashboard staying = robot.dashboard();
        QCOMPARE(leaving.ask("quit"), QByteArray("Disconnected\n"));
        QVERIFY(leaving.waitClosed());
        QCOMPARE(staying.ask("robotmode"), QByteArray("Robotmode: RUNNING\n"));
    }

    void shutdownEndsEverything() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.ask("shutdown"), QByteArray("Shutting down\n"));
        QVERIFY(dashboard.waitClosed());
        QVERIFY(rtde.waitClosed());
    }

    void anUnterminatedLineIsDiscarded() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        dashboard.send(QByteArray(100'000, 'x'));
        QVERIFY(dashboard.waitClosed());
    }
};

QTEST_GUILESS_MAIN(TestDashboardService)
#include "tst_dashboard_service.moc"
