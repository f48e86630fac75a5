// SPDX-License-Identifier: MIT

#include <QTest>

#include "tests/integration/simulator/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

enum MessageKind {
    kText = 0,
    kPopup = 2,
    kVersion = 3,
    kSafetyMode = 5,
    kErrorCode = 6,
    kKey = 7,
    kException = 10
};

/// KEY messages as "STARTED name".
QByteArrayList keysOf(const std::vector<QByteArray>& messages) {
    QByteArrayList keys;
    for (const QByteArray& body : messages) {
        const int length = static_cast<unsigned char>(body[8]);
        keys << body.mid(9, length).mid(12) + ' ' + body.mid(9 + length);
    }
    return keys;
}

/// Everything a test may want to know of a stretch of the primary stream.
struct Heard {
    QByteArrayList keys, texts;
    std::vector<QByteArray> errors, exceptions, safetyModes;
    int states = 0;

    explicit Heard(RawPrimary& primary) {
        std::vector<QByteArray> keyBodies;
        for (const QByteArray& package : primary.packages()) {
            if (package[4] == 16) {
                ++states;
                continue;
            }
            const QByteArray body = package.mid(15);
            switch (package[14]) {
                case kText:
                    texts << body;
                    break;
                case kKey:
                    keyBodies.push_back(body);
                    break;
                case kErrorCode:
                    errors.push_back(body);
                    break;
                case kException:
                    exceptions.push_back(body);
                    break;
                case kSafetyMode:
                    safetyModes.push_back(body);
                    break;
                default:
                    break;
            }
        }
        keys = keysOf(keyBodies);
    }
};

/// Sub-packages of a RobotState as type -> whole sub-package.
QMap<int, QByteArray> partsOf(const QByteArray& state) {
    QMap<int, QByteArray> parts;
    for (qsizetype at = 5; at + 5 <= state.size();) {
        const qsizetype length = wordAt(state, at);
        if (length < 5 || at + length > state.size()) {
            return {};
        }
        parts.insert(state[at + 4], state.mid(at, length));
        at += length;
    }
    return parts;
}

}  // namespace

class TestPrimaryService : public QObject {
    Q_OBJECT

    /// Sends a script and steps until nothing more is to be expected.
    static Heard run(VirtualRobot& robot, RawPrimary& primary, const QByteArray& script, double seconds) {
        primary.takeAll();
        primary.send(script);
        robot.controller.drainSockets();
        robot.controller.stepSeconds(seconds);
        return Heard(primary);
    }

private Q_SLOTS:
    void theVersionComesFirst() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const QByteArray message = primary.next();
        QCOMPARE(message.size(), 55);
        QCOMPARE(int(message[4]), 20);
        QCOMPARE(int(message[13]), -2);
        QCOMPARE(int(message[14]), int(kVersion));
        QCOMPARE(message.mid(15, 10), QByteArray("\x09URControl"));
        QCOMPARE(int(message[25]), 5);
        QCOMPARE(int(message[26]), 22);
        QCOMPARE(intAt(message, 27), 1);
    }

    void theFirstStateDescribesTheArmAndLaterOnesDoNot() {
        auto options = VirtualRobot::options();
        options.software = {5, 8, 0, 0};  // the one that was recorded
        VirtualRobot robot(options);
        RawPrimary primary = robot.primary();
        primary.next();
        robot.controller.stepSeconds(0.21);
        const QByteArray first = primary.next();
        QCOMPARE(first.size(), 1386);
        const auto parts = partsOf(first);
        QCOMPARE(parts.keys(), (QList<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
        const int sizes[] = {47, 251, 37, 75, 101, 225, 445, 61, 9, 53, 43, 26, 8};
        for (int type = 0; type <= 12; ++type) {
            QCOMPARE(parts[type].size(), sizes[type]);
        }
        // The order of the vendor's simulator.
        QCOMPARE(int(first[5 + 4]), 0);
        QCOMPARE(int(first[52 + 4]), 1);
        QCOMPARE(int(first[303 + 4]), 4);
        QCOMPARE(int(first[404 + 4]), 5);
        QCOMPARE(int(first[629 + 4]), 9);
        QCOMPARE(int(first[682 + 4]), 3);
        QCOMPARE(int(first[757 + 4]), 2);
        QCOMPARE(int(first[794 + 4]), 6);

        const QByteArray mode = parts[0];
        QCOMPARE(mode.mid(13, 7), QByteArray("\1\1\1\0\0\0\0", 7));
        QCOMPARE(int(mode[20]), 7);
        QCOMPARE(doubleAt(mode, 22), 1.0);
        QCOMPARE(doubleAt(mode, 38), 1.0);
        QVERIFY(std::abs(doubleAt(parts[1], 5) - -1.6007) < 1e-3);
        QCOMPARE(int(parts[1][5 + 40]), int(char(253)));
        QCOMPARE(doubleAt(parts[5], 77 + 8), -0.425);
        QCOMPARE(intAt(parts[6], 437), 1);
        QCOMPARE(intAt(parts[6], 441), 3);
        QCOMPARE(int(parts[3][65]), 1);

        QCOMPARE(primary.next().size(), 716);
    }

    void statesComeTenTimesASecond() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.next();
        robot.controller.drainSockets();
        robot.controller.stepSeconds(2.0);
        QCOMPARE(Heard(primary).states, 20);
    }

    void theSecondaryPortSaysNothingButItsVersionAndStates() {
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

    void scriptsRunFromAllThreePortsAndNotFromTheReadOnlyOnes_data() {
        QTest::addColumn<int>("port");
        QTest::addColumn<bool>("runs");
        QTest::newRow("primary") << 30001 << true;
        QTest::newRow("secondary") << 30002 << true;
        QTest::newRow("realtime") << 30003 << true;
        QTest::newRow("read-only primary") << 30011 << false;
        QTest::newRow("read-only secondary") << 30012 << false;
        QTest::newRow("read-only realtime") << 30013 << false;
    }
    void scriptsRunFromAllThreePortsAndNotFromTheReadOnlyOnes() {
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

    void anErrorInAScriptIsShownWithItsPlaceAndLeavesTheRunningProgramAlone() {
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

    void aNewProgramReplacesTheOneThatRuns() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const QByteArray endless = ":\n  while True:\n    sync()\n  end\nend\n";
        run(robot, primary, "def a()" + endless, 0.1);
        const Heard heard = run(robot, primary, "def b()" + endless, 0.1);
        QCOMPARE(heard.keys, (QByteArrayList{"STOPPED a", "STARTED b"}));
        QCOMPARE(robot.programState(), RuntimeState::Playing);
    }

    void stopProgramAndANewProgramMayComeInOneWrite() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const QByteArray endless = ":\n  while True:\n    sync()\n  end\nend\n";
        run(robot, primary, "def a()" + endless, 0.1);
        const Heard heard = run(robot, primary, "stop program\ndef b()" + endless, 0.1);
        QCOMPARE(heard.keys, (QByteArrayList{"STOPPED a", "STARTED b"}));
        QCOMPARE(robot.programState(), RuntimeState::Playing);
    }

    void aSecondaryProgramRunsBesideWithoutAWord() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        run(robot, primary, "def a():\n  while True:\n    sync()\n  end\nend\n", 0.1);
        const Heard heard = run(robot, primary, "sec s():\n  set_standard_digital_out(1, True)\nend\n", 0.1);
        QVERIFY(heard.keys.isEmpty());
        QCOMPARE(robot.controller.truth().digitalOutputs, 2ULL);
        QCOMPARE(robot.programState(), RuntimeState::Playing);
    }

    void aProgramMovesTheArmAndIsRunningMeanwhile() {
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

    void commandWordsPowerTheArm() {
        auto options = VirtualRobot::options();
        options.poweredOn = false;
        VirtualRobot robot(options);
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

    // A control script for both series holds what only one of them can, behind a condition.
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

    // Of the frames that are always there the base alone can be moved, in the world.
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

    void aProtectiveStopAskedForByAProgramIsReportedOnce() {
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

        // An early unlock over this port is not lost.
        const Heard unlocked = run(robot, primary, "set unlock protective stop\n", 0.5);
        QCOMPARE(unlocked.safetyModes.size(), std::size_t(1));
        QCOMPARE(int(unlocked.safetyModes[0][8]), 1);
    }

    void aLineOutOfReachIsAProtectiveStopAndTheArmMovesAgainAfterwards() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        const Heard heard = run(robot, primary, "def p():\n  movel(p[10,0,0,0,0,0])\nend\n", 1.0);
        QCOMPARE(heard.errors.size(), std::size_t(1));
        QVERIFY(intAt(heard.errors[0], 8) >= 2);
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::ProtectiveStop);
        run(robot, primary, "set unlock protective stop\n", 0.5);
        QCOMPARE(robot.controller.truth().safetyMode, SafetyMode::Normal);
        run(robot, primary, "def q():\n  movej([-1.5, -1.7, -2.2, -0.8, 1.6, 0], a=1.4, v=1.05)\nend\n", 2);
        QVERIFY(std::abs(robot.controller.truth().q[0] - -1.5) < 1e-3);
    }

    void inLocalControlAGatedRobotReadsNoScriptsAndSaysSo() {
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

        // A connection made in Local stays read-only; a new one may write.
        robot.controller.setRemoteControl(true);
        QVERIFY(run(robot, local, "def p():\n  sleep(1)\nend\n", 0.2).keys.isEmpty());
        RawPrimary remote = robot.primary();
        QCOMPARE(run(robot, remote, "def p():\n  sleep(1)\nend\n", 0.2).keys, QByteArrayList{"STARTED p"});
    }

    void cb3KnowsNoLocalControl() {
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

    void newerSoftwareAddsToTheState() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.next();
        robot.controller.stepSeconds(0.21);
        const auto parts = partsOf(primary.next());
        QCOMPARE(parts[6].size(), 449);
        QCOMPARE(parts[13].size(), 7);
    }

    void theProgramsVariablesAreToldOnceAndWhenTheyChange() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.send(
            "def p():\n  global n = 1\n  global where = p[1,0,0,0,0,0]\n  global words = \"hi\"\n"
            "  global all = [True, False]\n  sleep(0.5)\n  n = 7\n  sleep(100)\nend\n");
        robot.controller.drainSockets();
        const auto variables = [&] {
            QList<QByteArray> found;
            for (const QByteArray& package : primary.packages()) {
                if (package[4] == 25) {
                    found << package.mid(13);
                }
            }
            return found;
        };
        robot.controller.stepSeconds(0.4);
        const QList<QByteArray> first = variables();
        QVERIFY(first.size() >= 2);
        QCOMPARE(first[0], QByteArray("\0\0\0", 3) + "n\nwhere\nwords\nall\n");
        QByteArray expected("\1\0\0", 3);
        expected += QByteArray("\5\0\0\0\1", 5);
        expected += QByteArray("\3\x3f\x80\0\0", 5) + QByteArray(20, '\0');
        expected += QByteArray("\1\0\2hi", 5);
        expected += QByteArray("\2\0\2\4\1\4\0", 7);
        QCOMPARE(first.back(), expected);
        robot.controller.stepSeconds(0.5);
        const QList<QByteArray> changed = variables();
        QCOMPARE(changed.size(), qsizetype(1));
        QCOMPARE(changed[0].mid(3, 5), QByteArray("\5\0\0\0\7", 5));
        robot.controller.stepSeconds(0.5);
        QVERIFY(variables().isEmpty());
    }

    void theRealtimeRecordHasTheSizeOfItsSoftware_data() {
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::addColumn<int>("size");
        QTest::newRow("3.0") << 3 << 0 << 1044;
        QTest::newRow("3.2") << 3 << 2 << 1060;
        QTest::newRow("3.5") << 3 << 5 << 1108;
        QTest::newRow("3.10") << 3 << 10 << 1116;
        QTest::newRow("3.15") << 3 << 15 << 1140;
        QTest::newRow("5.3") << 5 << 3 << 1108;
        QTest::newRow("5.8") << 5 << 8 << 1116;
        QTest::newRow("5.9") << 5 << 9 << 1140;
        QTest::newRow("5.22") << 5 << 22 << 1220;
    }
    void theRealtimeRecordHasTheSizeOfItsSoftware() {
        QFETCH(int, major);
        QFETCH(int, minor);
        QFETCH(int, size);
        auto options = VirtualRobot::options();
        options.software = {static_cast<quint32>(major), static_cast<quint32>(minor), 0, 0};
        options.model = major == 3 ? RobotModelId::UR5 : RobotModelId::UR5e;
        VirtualRobot robot(options);
        RawPrimary realtime(robot.host(), robot.controller.ports().realtime);
        robot.controller.drainSockets();
        robot.controller.step(2);
        const QByteArray first = realtime.next();
        QCOMPARE(first.size(), size);
        const QByteArray second = realtime.next();
        QVERIFY(std::abs(doubleAt(second, 4) - doubleAt(first, 4) - robot.controller.stepTime()) < 1e-9);
        QVERIFY(std::abs(doubleAt(first, 252) - -1.6007) < 1e-3);  // q actual
        QCOMPARE(doubleAt(first, 756), 7.0);                       // robot mode
        QCOMPARE(doubleAt(first, 812), 1.0);                       // safety mode
    }

    void aRealtimeClientThatNeverReadsKeepsItsConnection() {
        VirtualRobot robot;
        RawClient deaf(robot.host(), robot.controller.ports().realtime);
        deaf.socket().setReadBufferSize(64);
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(10, "timestamp");
        QVERIFY(rtde.start());
        robot.controller.step(10'000);  // some twelve megabytes
        QCOMPARE(rtde.packages().size(), std::size_t(200));
        deaf.send("def p():\n  set_standard_digital_out(0, True)\nend\n");
        robot.controller.drainSockets();
        robot.controller.step(5);
        QCOMPARE(robot.controller.truth().digitalOutputs, 1ULL);
    }
};

QTEST_GUILESS_MAIN(TestPrimaryService)
#include "tst_primary_service.moc"
