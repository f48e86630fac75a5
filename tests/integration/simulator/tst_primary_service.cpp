// SPDX-License-Identifier: MIT
// Programs and commands sent to the primary, secondary and realtime ports, and the resulting messages.
#include <QTest>

#include "tests/support/primary_listener.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Returns the safety mode in a robot state package; -1 if the package does not contain it.
int safetyModeIn(const QByteArray& state) {
    constexpr int kMasterboard = 3, kOffset = 65;
    for (qsizetype at = 5; at + 5 <= state.size() && intAt(state, at) >= 5; at += intAt(state, at)) {
        if (state[at + 4] == kMasterboard) {
            return static_cast<unsigned char>(state[at + kOffset]);
        }
    }
    return -1;
}

}  // namespace

class TestPrimaryService : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void secondaryPortSendsOnlyItsVersionAndStates() {
        VirtualRobot robot;
        RawPrimary secondary(robot.host(), robot.controller.ports().secondary);
        QCOMPARE(int(secondary.next()[14]), int(kVersion));
        const Heard heard = run(robot, secondary, "def p():\n  textmsg(\"x\")\nend\n", 0.5);
        QVERIFY(heard.keys.isEmpty());
        QVERIFY(heard.texts.isEmpty());
        QVERIFY(heard.states > 0);
    }

    void aProgramIsAnnouncedRunAndReportedEnded() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const Heard heard =
            run(robot, primary, "def hello():\n  textmsg(\"n = \", 1 + 1)\n  sleep(0.1)\nend\n", 0.5);
        QCOMPARE(heard.keys, (QByteArrayList{"STARTED hello", "STOPPED hello"}));
        QCOMPARE(heard.texts, QByteArrayList{"n = 2"});
        QVERIFY(heard.exceptions.empty());
    }

    void theSpeedSliderIsSetByCommand() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        for (const char* words :
             {"set speed 0.35\n", "set speed\n", "set speed fast\n", "set speed 0.35 1\n"}) {
            primary.send(words);
            robot.controller.drainSockets();
            robot.controller.step();
            QCOMPARE(robot.controller.truth().speedSlider, 0.35);
        }
    }

    void scriptsRunFromAllPortsExceptReadOnlyOnes_data() {
        QTest::addColumn<int>("port");
        QTest::addColumn<bool>("runs");
        QTest::newRow("primary") << 30001 << true;
        QTest::newRow("secondary") << 30002 << true;
        QTest::newRow("realtime") << 30003 << true;
        QTest::newRow("read-only primary") << 30011 << false;
        QTest::newRow("read-only secondary") << 30012 << false;
        QTest::newRow("read-only realtime") << 30013 << false;
    }
    void scriptsRunFromAllPortsExceptReadOnlyOnes() {
        QFETCH(int, port);
        QFETCH(bool, runs);
        VirtualRobot robot;
        const simulator::Ports ports = robot.controller.ports();
        const QMap<int, quint16> actual = {{30001, ports.primary},           {30002, ports.secondary},
                                           {30003, ports.realtime},          {30011, ports.primaryReadOnly},
                                           {30012, ports.secondaryReadOnly}, {30013, ports.realtimeReadOnly}};
        RawClient sender(robot.host(), actual[port]);
        sender.send("def p():\n  set_standard_digital_out(3, True)\nend\n");
        robot.controller.drainSockets();
        robot.controller.step(10);
        QCOMPARE(robot.controller.truth().digitalOutputs, runs ? 8ULL : 0ULL);
    }

    void aScriptErrorHasItsPositionAndKeepsTheProgramRunning() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        run(robot, primary, "def first():\n  while True:\n    sync()\n  end\nend\n", 0.1);
        const Heard heard = run(robot, primary, "def p():\n  foo()\nend\n", 0.2);
        QCOMPARE(heard.exceptions.size(), std::size_t(1));
        QCOMPARE(intAt(heard.exceptions[0], 0), 2);
        QCOMPARE(intAt(heard.exceptions[0], 4), 3);
        QCOMPARE(heard.exceptions[0].mid(8), QByteArray("compile_error_name_not_found:foo:"));
        QVERIFY(heard.keys.isEmpty());
        QCOMPARE(robot.programState(), RuntimeState::Playing);
    }

    void aSyntaxErrorIsAnException() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const Heard heard = run(robot, primary, "def p():\n  x = (1 +\nend\n", 0.2);
        QCOMPARE(heard.exceptions.size(), std::size_t(1));
        QVERIFY(heard.keys.isEmpty());
    }

    void aRunTimeErrorEndsTheProgram() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const Heard heard = run(robot, primary, "def p():\n  movej(p[10,0,0,0,0,0])\nend\n", 0.5);
        QCOMPARE(heard.exceptions.size(), std::size_t(1));
        QCOMPARE(heard.keys, (QByteArrayList{"STARTED p", "STOPPED p"}));
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::Normal);
    }

    void newProgramReplacesTheRunningOne_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::newRow("by itself") << QByteArray();
        QTest::newRow("with a stop in the same write") << QByteArray("stop program\n");
    }
    void newProgramReplacesTheRunningOne() {
        QFETCH(QByteArray, before);
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const QByteArray endless = ":\n  while True:\n    sync()\n  end\nend\n";
        run(robot, primary, "def a()" + endless, 0.1);
        const Heard heard = run(robot, primary, before + "def b()" + endless, 0.1);
        QCOMPARE(heard.keys, (QByteArrayList{"STOPPED a", "STARTED b"}));
        QCOMPARE(robot.programState(), RuntimeState::Playing);
    }

    void secondaryProgramRunsInParallelWithoutMessages() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        run(robot, primary, "def a():\n  while True:\n    sync()\n  end\nend\n", 0.1);
        const Heard heard = run(robot, primary, "sec s():\n  set_standard_digital_out(1, True)\nend\n", 0.1);
        QVERIFY(heard.keys.isEmpty());
        QCOMPARE(robot.controller.truth().digitalOutputs, 2ULL);
        QCOMPARE(robot.programState(), RuntimeState::Playing);
    }

    void aProgramIsReportedRunningWhileItMovesTheArm() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.send("movej([-1.5, -1.7, -2.0, -0.8, 1.6, 0.1], a=1.4, v=1.05)\n");
        robot.controller.drainSockets();
        robot.controller.step(5);
        QCOMPARE(robot.programState(), RuntimeState::Playing);
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 5));
        QVERIFY(std::abs(robot.controller.truth().q[0] - -1.5) < 1e-3);
        QVERIFY(robot.controller.truth().qd.values.norm() < 0.01);
    }

    void stoppingAProgramDeceleratesTheArm() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.send("def p():\n  speedj([0.5,0,0,0,0,0], 5, 10)\nend\n");
        robot.controller.drainSockets();
        robot.controller.stepSeconds(0.5);
        QVERIFY(robot.controller.truth().qd[0] > 0.45);
        const Heard heard = run(robot, primary, "stop program\n", 0.4);
        QCOMPARE(heard.keys, QByteArrayList{"STOPPED p"});
        QVERIFY(std::abs(robot.controller.truth().qd[0]) < 0.01);
        QCOMPARE(robot.programState(), RuntimeState::Stopped);
    }

    void aStopIsNotYetEffectiveInTheFirstMillisecond() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        run(robot, primary, "def p():\n  sleep(10)\nend\n", 0.1);
        primary.send("stop program\n");
        robot.controller.drainSockets();
        robot.controller.step();
        QVERIFY(robot.programState() != RuntimeState::Stopped);
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 2));
    }

    void powerCommandsPowerTheArm() {
        VirtualRobot robot(VirtualRobot::poweredOff());
        RawPrimary primary = robot.primary();
        const auto send = [&](const char* words) {
            primary.send(QByteArray(words) + '\n');
            robot.controller.drainSockets();
        };
        const auto mode = [&] { return robot.controller.truth().robotMode; };
        send("power on");
        robot.controller.step();
        QVERIFY(mode() != RobotMode::Idle);
        QVERIFY(robot.stepUntil([&] { return mode() == RobotMode::Idle; }));
        send("set robotmode run");
        QVERIFY(robot.stepUntil([&] { return mode() == RobotMode::Running; }));
        send("power off");
        robot.controller.step();
        QCOMPARE(mode(), RobotMode::Running);
        QVERIFY(robot.stepUntil([&] { return mode() == RobotMode::PowerOff; }));
        send("set robotmode run");
        QVERIFY(robot.stepUntil([&] { return mode() == RobotMode::Running; }));
    }

    // A control script for both series contains functions that exist in only one series, inside a condition.
    void gainScalingCompilesOnACb3AndFailsOnlyWhenCalled() {
        auto options = VirtualRobot::options();
        options.model = RobotModelId::UR5;
        options.software = {3, 15, 8, 106339};
        VirtualRobot robot(options);
        RawPrimary primary = robot.primary();
        const Heard guarded = run(robot, primary,
                                  "def p():\n  if get_steptime() < 0.008:\n    "
                                  "force_mode_set_gain_scaling(0.5)\n  end\nend\n",
                                  0.5);
        QCOMPARE(guarded.keys, (QByteArrayList{"STARTED p", "STOPPED p"}));
        QVERIFY(guarded.exceptions.empty());
        const Heard called = run(robot, primary, "def q():\n  force_mode_set_gain_scaling(0.5)\nend\n", 0.5);
        QCOMPARE(called.exceptions.size(), std::size_t(1));
        QVERIFY(called.exceptions[0].contains("force_mode_set_gain_scaling"));
    }

    // Of the permanent frames, only the base can be moved relative to the world.
    void theBaseCanBeMovedInTheWorld() {
        auto options = VirtualRobot::options();
        options.software = {10, 12, 0, 0};
        VirtualRobot robot(options);
        RawPrimary primary = robot.primary();
        const Heard heard = run(
            robot, primary,
            "def p():\n  add_frame(\"table\", p[1,0,0,0,0,0], \"world\")\n"
            "  add_frame(\"part\", p[0,0.5,0,0,0,0], \"base\")\n"
            "  move_frame(\"base\", p[0.25,0,0,0,0,0], \"world\")\n"
            "  textmsg(get_pose(\"table\", \"base\"))\n  textmsg(get_pose(\"part\", \"world\"))\n"
            "  move_frame(\"base\", p[0,0,0.5,0,0,0], \"base\")\n  textmsg(get_pose(\"base\", \"world\"))\n"
            "  reset_world_model()\n  textmsg(get_pose(\"base\", \"world\"))\n  move_frame(\"tcp\", "
            "p[0,0,0,0,0,0], \"base\")\nend\n",
            0.5);
        QCOMPARE(heard.texts, (QByteArrayList{"p[0.75,0,0,0,0,0]", "p[0.25,0.5,0,0,0,0]",
                                              "p[0.25,0,0.5,0,0,0]", "p[0,0,0,0,0,0]"}));
        QCOMPARE(heard.exceptions.size(), std::size_t(1));
    }

    void aProtectiveStopRequestedByAProgramIsReportedOnce() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const Heard heard = run(robot, primary, "def p():\n  protective_stop()\nend\n", 0.5);
        QCOMPARE(heard.errors.size(), std::size_t(1));
        QCOMPARE(intAt(heard.errors[0], 0), 209);
        QCOMPARE(intAt(heard.errors[0], 4), 0);
        QCOMPARE(intAt(heard.errors[0], 8), 2);  // warning
        QCOMPARE(heard.safetyModes.size(), std::size_t(1));
        QCOMPARE(int(heard.safetyModes[0][8]), 3);
        QCOMPARE(heard.keys, (QByteArrayList{"STARTED p", "STOPPED p"}));
        QCOMPARE(robot.controller.truth().robotMode, RobotMode::Running);

        // An early unlock command through this port is not lost.
        const Heard unlocked = run(robot, primary, "set unlock protective stop\n", 0.5);
        QCOMPARE(unlocked.safetyModes.size(), std::size_t(1));
        QCOMPARE(int(unlocked.safetyModes[0][8]), 1);
    }

    // Clients wait for the message and then read the newest state, which must match.
    void safetyModeIsReportedAfterTheMatchingState_data() {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<QList<int>>("modes");
        const auto row = [](const char* fault, const QList<int>& modes) {
            QTest::newRow(fault) << QString(fault) << QByteArray() << modes;
        };
        row("protective-stop", {3});
        row("emergency-stop on", {7});
        row("system-emergency-stop on", {6});
        row("safeguard on", {5});
        row("reduced on", {2});
        row("violation", {8});
        row("fault", {9});
        QTest::newRow("protective_stop()")
            << QString() << QByteArray("def p():\n  protective_stop()\nend\n") << QList<int>{3};
        QTest::newRow("stop category 0 of a path")
            << QString() << QByteArray("def p():\n  movel(p[10,0,0,0,0,0])\nend\n") << QList<int>{3};
    }
    void safetyModeIsReportedAfterTheMatchingState() {
        QFETCH(QString, fault);
        QFETCH(QByteArray, script);
        QFETCH(QList<int>, modes);
        // The change occurs at different times between two states.
        for (const int ticksBefore : {1, 13, 26, 39, 49, 50, 51}) {
            VirtualRobot robot;
            RawPrimary primary = robot.primary();
            robot.controller.drainSockets();
            robot.controller.step(50 + ticksBefore);
            primary.packages();
            if (script.isEmpty()) {
                QVERIFY(robot.controller.inject(fault).ok());
            } else {
                primary.send(script);
                robot.controller.drainSockets();
            }
            // The linear move continues up to the limit of the reach.
            robot.controller.stepSeconds(script.contains("movel") ? 15 : 1);
            int shown = 1;
            QList<int> reported;
            for (const QByteArray& package : primary.packages()) {
                if (package[4] == 16) {
                    shown = safetyModeIn(package);
                } else if (package[4] == 20 && package[14] == kSafetyMode) {
                    reported << static_cast<unsigned char>(package[15 + 8]);
                    QCOMPARE(shown, reported.back());
                }
            }
            QCOMPARE(reported, modes);
        }
    }

    // Changes during a pause are reported only once, with the current value.
    void lastSafetyModeIsReportedAfterAPause() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        robot.controller.drainSockets();
        robot.controller.step(60);
        primary.packages();
        robot.controller.silence(true);
        QVERIFY(robot.controller.inject("safeguard on").ok());
        robot.controller.step(10);
        QVERIFY(robot.controller.inject("safeguard off").ok());
        QVERIFY(robot.controller.inject("protective-stop").ok());
        robot.controller.step(10);
        robot.controller.silence(false);
        robot.controller.stepSeconds(0.5);
        int shown = 0;
        QList<int> reported;
        for (const QByteArray& package : primary.packages()) {
            if (package[4] == 16) {
                shown = safetyModeIn(package);
            } else if (package[4] == 20 && package[14] == kSafetyMode) {
                reported << static_cast<unsigned char>(package[15 + 8]);
                QCOMPARE(shown, reported.back());
            }
        }
        QCOMPARE(reported, QList<int>{3});
    }

    void theArmMovesAgainAfterAnUnreachableLineStoppedIt() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const Heard heard = run(robot, primary, "def p():\n  movel(p[10,0,0,0,0,0])\nend\n", 15.0);
        QCOMPARE(heard.errors.size(), std::size_t(1));
        QVERIFY(intAt(heard.errors[0], 8) >= 2);
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::ProtectiveStop);
        run(robot, primary, "set unlock protective stop\n", 0.5);
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::Normal);
        run(robot, primary, "def q():\n  movej([-1.5, -1.7, -2.2, -0.8, 1.6, 0], a=1.4, v=1.05)\nend\n", 10);
        QVERIFY(std::abs(robot.controller.truth().q[0] - -1.5) < 1e-3);
    }

    void gatedRobotRefusesScriptsInLocalControl() {
        auto options = VirtualRobot::options();
        options.gateLocalControl = true;
        VirtualRobot robot(options);
        RawPrimary before = robot.primary();
        before.next();
        robot.controller.setRemoteControl(false);
        robot.controller.drainSockets();
        QVERIFY(before.waitClosed());

        RawPrimary local = robot.primary();
        const Heard heard = run(robot, local, "def p():\n  sleep(1)\nend\n", 0.2);
        QCOMPARE(heard.errors.size(), std::size_t(1));
        QCOMPARE(intAt(heard.errors[0], 0), 210);
        QVERIFY(heard.keys.isEmpty());

        // A connection that was opened in Local remains read-only. A new connection may write.
        robot.controller.setRemoteControl(true);
        QVERIFY(run(robot, local, "def p():\n  sleep(1)\nend\n", 0.2).keys.isEmpty());
        RawPrimary remote = robot.primary();
        QCOMPARE(run(robot, remote, "def p():\n  sleep(1)\nend\n", 0.2).keys, QByteArrayList{"STARTED p"});
    }

    void cb3HasNoLocalControl() {
        auto options = VirtualRobot::options();
        options.model = RobotModelId::UR5;
        options.software = {3, 15, 8, 106339};
        options.remoteControl = false;
        options.gateLocalControl = true;
        options.gateLoopbackClients = true;
        VirtualRobot robot(options);
        RawPrimary primary = robot.primary();
        primary.send("def p():\n  set_standard_digital_out(1, True)\nend\n");
        robot.controller.drainSockets();
        robot.controller.step(5);
        QCOMPARE(robot.controller.truth().digitalOutputs, 2ULL);
        QCOMPARE(robot.dashboard().ask("power off"), QByteArray("Powering off\n"));
    }
};

QTEST_GUILESS_MAIN(TestPrimaryService)
#include "tst_primary_service.moc"
