// SPDX-License-Identifier: MIT
//
// Every transition of robot mode, safety mode and program state that a simulated robot can make, observed on
// all interfaces at once.

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/integration/simulator/mode_observer.h"

using namespace tiller;
using namespace tiller::test;

namespace {

enum Mode { Disconnected, ConfirmSafety, Booting, PowerOff, PowerOn, Idle, Backdrive, Running };
// Intermediate states last until the arm has stopped or has reached its speed.
enum Program { Stopping, Stopped, Playing, Pausing, Paused, Resuming };

const char* const kEndless = "p:def forever():\n  while True:\n    sync()\n  end\nend";
const char* const kMoving =
    "p:def go():\n  while True:\n    movej([-1.2,-1.7,-2.2,-0.8,1.6,0], a=3, v=1)\n"
    "    movej([-1.8,-1.7,-2.2,-0.8,1.6,0], a=3, v=1)\n  end\nend";

}  // namespace

class TestModeTransitions : public QObject {
    Q_OBJECT

    /// Prefixes of actions: "d:" sends a line to the dashboard, "p:" sends to the primary port, "f:" triggers
    /// a fault, and "t:" advances time [s].
    static void act(VirtualRobot& robot, ModeObserver& observer, const QByteArray& action) {
        const QByteArray words = action.mid(2);
        if (action.startsWith("d:")) {
            observer.dashboard().ask(words);
        } else if (action.startsWith("p:")) {
            observer.primary().send(words + '\n');
            robot.controller.drainSockets();
        } else if (action.startsWith("f:")) {
            const Result<QString> done = robot.controller.inject(QString::fromUtf8(words));
            QVERIFY2(done.ok(), qPrintable(done.error().context));
        } else {
            observer.step(int(words.toDouble() * 500 + 0.5));
        }
        observer.step(1);
    }

private Q_SLOTS:
    void everyTransitionIsConsistentOnAllInterfaces_data() {
        QTest::addColumn<bool>("powered");
        QTest::addColumn<QList<QByteArray>>("before");
        QTest::addColumn<QList<QByteArray>>("event");
        QTest::addColumn<QList<int>>("robotModes");  // the expected modes, including the first one
        QTest::addColumn<QList<int>>("runtimeStates");
        QTest::addColumn<int>("safetyMode");
        QTest::addColumn<int>("safetyStatus");
        using Steps = QList<QByteArray>;
        using Path = QList<int>;
        const auto row = [](const char* name, bool powered, const Steps& before, const Steps& event,
                            const Path& modes, const Path& states, int safety = 1, int status = 0) {
            QTest::newRow(name) << powered << before << event << modes << states << safety
                                << (status == 0 ? safety : status);
        };
        const Path stopped{Stopped};
        const Path running{Running};
        const Path upToIdle{PowerOff, PowerOn, Booting, Idle};
        const Path upToRunning{PowerOff, PowerOn, Booting, Idle, Running};
        const Path off{Running, PowerOff};

        // Robot mode
        row("power on, dashboard", false, {}, {"d:power on"}, upToIdle, stopped);
        row("power on, primary", false, {}, {"p:power on"}, upToIdle, stopped);
        row("brake release from IDLE, dashboard", false, {"d:power on", "t:3"}, {"d:brake release"},
            {Idle, Running}, stopped);
        row("brake release from IDLE, primary", false, {"d:power on", "t:3"}, {"p:set robotmode run"},
            {Idle, Running}, stopped);
        row("brake release from POWER_OFF, dashboard", false, {}, {"d:brake release"}, upToRunning, stopped);
        row("brake release from POWER_OFF, primary", false, {}, {"p:set robotmode run"}, upToRunning,
            stopped);
        row("power on in IDLE", false, {"d:power on", "t:3"}, {"d:power on"}, {Idle}, stopped);
        row("power on in RUNNING", true, {}, {"p:power on"}, running, stopped);
        row("power off in RUNNING", true, {}, {"d:power off"}, off, stopped);
        row("power off in IDLE", false, {"d:power on", "t:3"}, {"p:power off"}, {Idle, PowerOff}, stopped);
        row("power off while booting", false, {"d:brake release", "t:0.5"}, {"d:power off"},
            {Booting, PowerOff}, stopped);
        row("power off while powering on", false, {"d:power on", "t:0.05"}, {"d:power off"},
            {PowerOn, PowerOff}, stopped);
        row("power off in POWER_OFF", false, {}, {"d:power off"}, {PowerOff}, stopped);
        row("power off and on: from RUNNING to IDLE", true, {}, {"d:power off", "d:power on"},
            {Running, PowerOff, PowerOn, Booting, Idle}, stopped);
        row("power off with a program", true, {kEndless, "t:0.1"}, {"d:power off"}, off, {Playing, Stopped});
        row("power loss with a program", true, {kMoving, "t:0.5"}, {"f:power-loss"}, off, {Playing, Stopped});
        row("backdrive", false, {"d:power on", "t:3"}, {"f:backdrive on"}, {Idle, Backdrive}, stopped);
        row("backdrive ends", false, {"d:power on", "t:3", "f:backdrive on"}, {"f:backdrive off"},
            {Backdrive, Idle}, stopped);
        row("power off in BACKDRIVE", false, {"d:power on", "t:3", "f:backdrive on"}, {"d:power off"},
            {Backdrive, PowerOff}, stopped);
        row("restart safety in RUNNING", true, {kEndless, "t:0.1"}, {"d:restart safety"}, off,
            {Playing, Stopped});
        row("restart safety in POWER_OFF", false, {}, {"d:restart safety"}, {PowerOff}, stopped);
        row("load installation", true, {}, {"d:load installation default.installation"}, off, stopped);

        // Safety
        row("reduced", true, {kEndless, "t:0.1"}, {"f:reduced on"}, running, {Playing}, 2);
        row("reduced ends", true, {"f:reduced on"}, {"f:reduced off"}, running, stopped, 1);
        row("protective stop, idle", true, {}, {"f:protective-stop"}, running, stopped, 3);
        row("protective stop, moving", true, {kMoving, "t:0.7"}, {"f:protective-stop"}, running,
            {Playing, Stopping, Stopped}, 3);
        row("protective stop, by script", true, {}, {"p:def p():\n  protective_stop()\nend"}, running,
            {Stopped, Stopping, Stopped}, 3);
        row("protective stop, of a .urp program", true, {"d:load wait.urp", "d:play", "t:0.1"},
            {"f:protective-stop"}, running, {Playing, Paused}, 3);
        row("unlock before 5 s", true, {"f:protective-stop", "t:4.9"}, {"d:unlock protective stop"}, running,
            stopped, 3);
        row("unlock after 5 s", true, {"f:protective-stop", "t:5"}, {"d:unlock protective stop"}, running,
            stopped, 1);
        row("unlock, primary", true, {"f:protective-stop", "t:5"}, {"p:set unlock protective stop"}, running,
            stopped, 1);
        row("play after the unlock", true,
            {"d:load wait.urp", "d:play", "t:0.1", "f:protective-stop", "t:5.1", "d:unlock protective stop",
             "t:1"},
            {"d:play"}, running, {Paused, Resuming, Playing}, 1);
        row("power off in a protective stop", true, {"f:protective-stop"}, {"d:power off"}, off, stopped, 3);
        row("restart safety ends a protective stop", true, {"f:protective-stop"}, {"d:restart safety"}, off,
            stopped, 1);
        row("recovery", true, {}, {"f:recovery on"}, running, stopped, 4);
        row("recovery ends", true, {"f:recovery on"}, {"f:recovery off"}, running, stopped, 1);
        row("safeguard, no program", true, {}, {"f:safeguard on"}, running, stopped, 5);
        row("safeguard, moving", true, {kMoving, "t:0.7"}, {"f:safeguard on"}, running,
            {Playing, Pausing, Paused}, 5);
        row("safeguard ends", true, {kMoving, "t:0.7", "f:safeguard on", "t:1"}, {"f:safeguard off"}, running,
            {Paused, Resuming, Playing}, 1);
        row("safeguard of a paused program", true,
            {kEndless, "t:0.1", "d:pause", "t:0.1", "f:safeguard on", "t:0.1"}, {"f:safeguard off"}, running,
            {Paused}, 1);
        row("automatic-mode safeguard", true, {"d:set operational mode automatic", kEndless, "t:0.1"},
            {"f:automatic-safeguard on"}, running, {Playing, Paused}, 5, 12);
        row("automatic-mode safeguard in MANUAL", true, {"d:set operational mode manual"},
            {"f:automatic-safeguard on"}, running, stopped, 1);
        row("automatic-mode safeguard ends with the mode", true,
            {"d:set operational mode automatic", "f:automatic-safeguard on"}, {"d:clear operational mode"},
            running, stopped, 1);
        row("three-position device", true, {"d:set operational mode manual", kEndless, "t:0.1"},
            {"f:enabling-device on"}, running, {Playing, Paused}, 5, 13);
        row("three-position device in its middle", true,
            {"d:set operational mode manual", kEndless, "t:0.1", "f:enabling-device on", "t:0.2"},
            {"f:enabling-device off"}, running, {Paused, Resuming, Playing}, 1);
        row("system emergency stop", true, {kMoving, "t:0.7"}, {"f:system-emergency-stop on"}, off,
            {Playing, Stopped}, 6);
        row("robot emergency stop", true, {kMoving, "t:0.7"}, {"f:emergency-stop on"}, off,
            {Playing, Stopped}, 7);
        row("emergency stop in IDLE", false, {"d:power on", "t:3"}, {"f:emergency-stop on"}, {Idle, PowerOff},
            stopped, 7);
        row("emergency stop released", true, {"f:emergency-stop on", "t:1"}, {"f:emergency-stop off"},
            {PowerOff}, stopped, 1);
        row("no power during an emergency stop", true, {"f:emergency-stop on", "t:1"}, {"d:brake release"},
            {PowerOff}, stopped, 7);
        row("power after an emergency stop", true, {"f:emergency-stop on", "t:1", "f:emergency-stop off"},
            {"d:brake release"}, upToRunning, stopped, 1);
        row("emergency stop ends a protective stop's right to power", true, {"f:protective-stop", "t:1"},
            {"f:emergency-stop on"}, off, stopped, 7);
        row("violation", true, {kMoving, "t:0.7"}, {"f:violation"}, off, {Playing, Stopped}, 8);
        row("fault", true, {kMoving, "t:0.7"}, {"f:fault"}, off, {Playing, Stopped}, 9);
        row("no power during a violation", true, {"f:violation", "t:1"}, {"d:power on"}, {PowerOff}, stopped,
            8);
        row("no power during a fault", true, {"f:fault", "t:1"}, {"p:power on"}, {PowerOff}, stopped, 9);
        row("restart safety after a violation", true, {"f:violation", "t:1"}, {"d:restart safety"},
            {PowerOff}, stopped, 1);
        row("restart safety after a fault", true, {"f:fault", "t:1"}, {"d:restart safety"}, {PowerOff},
            stopped, 1);
        row("power after the restart", true, {"f:fault", "t:1", "d:restart safety"}, {"d:brake release"},
            upToRunning, stopped, 1);

        // Program
        row("script from a socket", true, {}, {kEndless}, running, {Stopped, Playing});
        row("script that ends", true, {}, {"p:def p():\n  sleep(0.1)\nend"}, running,
            {Stopped, Playing, Stopped});
        row("a script replaces one", true, {kEndless, "t:0.1"}, {"p:def q():\n  sleep(0.1)\nend"}, running,
            {Playing, Stopped});
        row("play", true, {"d:load wait.urp"}, {"d:play"}, running, {Stopped, Playing});
        row("play without a program", true, {}, {"d:play"}, running, stopped);
        row("play without power", false, {"d:load wait.urp"}, {"d:play"}, {PowerOff}, stopped);
        row("pause", true, {"d:load wait.urp", "d:play", "t:0.1"}, {"d:pause"}, running, {Playing, Paused});
        row("pause while moving", true, {kMoving, "t:0.7"}, {"d:pause"}, running, {Playing, Pausing, Paused});
        row("play resumes", true, {"d:load wait.urp", "d:play", "t:0.1", "d:pause", "t:0.5"}, {"d:play"},
            running, {Paused, Resuming, Playing});
        row("stop", true, {"d:load wait.urp", "d:play", "t:0.1"}, {"d:stop"}, running,
            {Playing, Stopping, Stopped});
        row("stop while moving", true, {kMoving, "t:0.7"}, {"p:stop program"}, running,
            {Playing, Stopping, Stopped});
        row("stop a paused program", true, {kEndless, "t:0.1", "d:pause", "t:0.5"}, {"d:stop"}, running,
            {Paused, Stopping, Stopped});
        row("runtime exception", true, {kEndless, "t:0.1"}, {"f:script-error"}, running, {Playing, Stopped});
        row("a secondary program beside", true, {kEndless, "t:0.1"},
            {"p:sec s():\n  set_digital_out(0, True)\nend"}, running, {Playing});
        row("speed slider 0", true, {kMoving, "t:0.7"}, {"f:speed 0"}, running, {Playing});
        row("no program in a safeguard stop", true, {"f:safeguard on"}, {kEndless}, running, stopped, 5);
    }
    void everyTransitionIsConsistentOnAllInterfaces() {
        QFETCH(bool, powered);
        QFETCH(QList<QByteArray>, before);
        QFETCH(QList<QByteArray>, event);
        QFETCH(QList<int>, robotModes);
        QFETCH(QList<int>, runtimeStates);
        QFETCH(int, safetyMode);
        QFETCH(int, safetyStatus);
        QTemporaryDir folder;
        const auto write = [&folder](const char* name, const char* text) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(text);
        };
        write("wait.urp", "def wait():\n  while True:\n    sleep(1)\n  end\nend\n");
        write("default.installation", "nothing in it\n");
        auto options = VirtualRobot::options();
        options.poweredOn = powered;
        options.programsFolder = folder.path();
        VirtualRobot robot(options);
        QVERIFY(robot.started);
        ModeObserver observer(robot);
        for (const QByteArray& action : before) {
            act(robot, observer, action);
        }
        observer.forget();
        for (const QByteArray& action : event) {
            act(robot, observer, action);
        }
        // Step until the transition is complete, and then for the interval of a primary state.
        for (int i = 0;
             i < 200 && (observer.robotModes() != robotModes || observer.runtimeStates() != runtimeStates);
             ++i) {
            observer.step(25);
        }
        observer.settle();
        QCOMPARE(observer.robotModes(), robotModes);
        QCOMPARE(observer.runtimeStates(), runtimeStates);
        QCOMPARE(observer.last().safetyMode, safetyMode);
        QCOMPARE(observer.last().safetyStatus, safetyStatus);
        QVERIFY2(observer.complaints().isEmpty(), qPrintable(observer.complaints().join('\n')));
    }

    // Starting the controller closes all connections, so new clients connect to observe each mode of the
    // start.
    void controllerStartIsConsistentOnAllInterfaces() {
        VirtualRobot robot;
        {
            ModeObserver observer(robot);
            act(robot, observer, kEndless);
            observer.step(50);
            QCOMPARE(observer.last().runtimeState, int(Playing));
        }
        const auto look = [&robot](double after, int mode) {
            robot.controller.stepSeconds(after);
            ModeObserver observer(robot);
            observer.settle();
            QCOMPARE(observer.last().robotMode, mode);
            QCOMPARE(observer.last().runtimeState, int(Stopped));
            QVERIFY2(observer.complaints().isEmpty(), qPrintable(observer.complaints().join('\n')));
        };
        QVERIFY(robot.controller.inject("restart 2 unconfirmed").ok());
        look(0.1, Disconnected);
        look(1, ConfirmSafety);
        look(20, ConfirmSafety);
        QVERIFY(robot.controller.inject("confirm-safety").ok());
        look(0.1, Booting);
        look(1, PowerOff);
        robot.dashboard().ask("brake release");
        look(5, Running);
    }

    // PolyScope X has no dashboard, so the Robot API must be consistent with the other interfaces.
    void robotApiOfPolyScopeXReportsTheSame() {
        auto options = VirtualRobot::options();
        options.software = {10, 12, 0, 0};
        options.poweredOn = false;
        VirtualRobot robot(options);
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(500, "robot_mode,safety_mode");
        QVERIFY(rtde.start());
        const auto get = [&robot](const QByteArray& path) {
            RawClient web(robot.host(), robot.controller.ports().robotApi);
            web.send("GET /universal-robots/robot-api" + path + " HTTP/1.1\r\nConnection: close\r\n\r\n");
            web.waitClosed();
            const QByteArray answer = web.takeAll();
            return answer.mid(answer.indexOf("\r\n\r\n") + 4);
        };
        const auto put = [&robot](const QByteArray& action) {
            RawClient web(robot.host(), robot.controller.ports().robotApi);
            const QByteArray body = "{\"action\":\"" + action + "\"}";
            web.send(
                "PUT /universal-robots/robot-api/robotstate/v1/state HTTP/1.1\r\nConnection: close\r\n"
                "Content-Length: " +
                QByteArray::number(body.size()) + "\r\n\r\n" + body);
            web.waitClosed();
            return web.takeAll().mid(9, 3);
        };
        const auto agree = [&](const char* mode, const char* safety) {
            robot.controller.step();
            QByteArray data;
            for (const auto& package : rtde.packages()) {
                data = package.payload;
            }
            QCOMPARE(get("/robotstate/v1/robotmode"), "{\"mode\":\"" + QByteArray(mode) + "\"}");
            QCOMPARE(robotModeName(RobotMode(intAt(data, 1))), QString::fromLatin1(mode));
            QVERIFY(get("/robotstate/v1/safetymode").contains("\"mode\":\"" + QByteArray(safety) + '"'));
            if (qstrcmp(safety, "EMERGENCY_STOP") != 0) {
                QCOMPARE(safetyModeName(SafetyMode(intAt(data, 5))), QString::fromLatin1(safety));
            }
        };
        agree("POWER_OFF", "NORMAL");
        QCOMPARE(put("POWER_ON"), QByteArray("200"));
        agree("POWER_ON", "NORMAL");
        robot.controller.stepSeconds(3);
        agree("IDLE", "NORMAL");
        QCOMPARE(put("BRAKE_RELEASE"), QByteArray("200"));
        robot.controller.stepSeconds(2);
        agree("RUNNING", "NORMAL");
        QVERIFY(robot.controller.inject("protective-stop").ok());
        agree("RUNNING", "PROTECTIVE_STOP");
        QCOMPARE(put("UNLOCK_PROTECTIVE_STOP"), QByteArray("200"));
        robot.controller.stepSeconds(0.1);
        agree("RUNNING", "NORMAL");
        QCOMPARE(put("UNLOCK_PROTECTIVE_STOP"), QByteArray("409"));
        QVERIFY(robot.controller.inject("emergency-stop on").ok());
        robot.controller.stepSeconds(1);
        agree("POWER_OFF", "EMERGENCY_STOP");
        QCOMPARE(put("POWER_ON"), QByteArray("409"));
        QVERIFY(robot.controller.inject("emergency-stop off").ok());
        QVERIFY(robot.controller.inject("fault").ok());
        robot.controller.step(2);
        agree("POWER_OFF", "FAULT");
        QCOMPARE(put("RESTART_SAFETY"), QByteArray("200"));
        robot.controller.step(2);
        agree("POWER_OFF", "NORMAL");
        QCOMPARE(put("DANCE"), QByteArray("422"));
    }
};

QTEST_GUILESS_MAIN(TestModeTransitions)
#include "tst_mode_transitions.moc"
