// SPDX-License-Identifier: MIT
// During every type of motion, the process that moves the arm is killed, suspended or disconnected without
// warning. The robot must stop by itself within the 250 ms of the contract, measured by the robot's clock,
// and remain stopped. A second RTDE connection observes the robot. With TILLER_ALL=1, all
// combinations are run; otherwise all motions with a kill and some of the others. TILLER_MOVING_HELPER names
// another build of the program that moves the arm.
#include <QTest>
#include <algorithm>

#include "robot/control/controller.h"
#include "tests/support/moving_process.h"

using namespace tiller;
using control::ScriptState;

namespace {

enum class Loss { Killed, Suspended, Cut };
constexpr Loss kLosses[] = {Loss::Killed, Loss::Suspended, Loss::Cut};

const char* name(Loss loss) {
    return loss == Loss::Killed ? "kill -9" : loss == Loss::Suspended ? "suspended" : "cut cable";
}

QString program() {
    return qEnvironmentVariable("TILLER_MOVING_HELPER", QStringLiteral(MOVING_HELPER));
}

}  // namespace

class TestKilledProcess : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aKilledProcessStopsTheArm_data() {
        QTest::addColumn<QString>("way");
        QTest::addColumn<int>("loss");
        QTest::addColumn<double>("fast");
        QTest::addColumn<bool>("hand");
        QTest::addColumn<ScriptState>("end");
        // fast  speed at the event [m/s]
        auto row = [count = 0](const char* way, double fast, bool hand = false,
                               ScriptState end = ScriptState::Expired) mutable {
            for (const Loss loss : kLosses) {
                // Every motion is tested with a kill. The other events are combined with some motions, or
                // with all motions in a complete run.
                if (loss == Loss::Killed || qEnvironmentVariableIsSet("TILLER_ALL") || count++ % 7 == 0) {
                    QTest::addRow("%s, %s", way, name(loss))
                        << QString::fromLatin1(way) << static_cast<int>(loss) << fast << hand << end;
                }
            }
        };
        constexpr double kFast = 0.095;
        row("jog", kFast);
        row("jog a joint", kFast);
        row("jog until contact", kFast);
        row("move until contact", kFast);
        row("moveJ", kFast);
        row("moveL", kFast);
        row("path", kFast);
        row("servoJ", kFast);
        row("servoL", kFast);
        row("servoC", kFast);
        row("speedJ", kFast);
        row("speedL", kFast);
        row("torque", kFast);
        // The external force continues, so if the arm stops, it has left freedrive.
        row("freedrive", 0.05, true);
        row("teach mode", 0.05, true);
        // No motion is active, so nothing times out and the script stays Ready. guard_force() ends force
        // mode.
        row("force mode", 0.03, false, ScriptState::Ready);
        row("jog in force mode", kFast);
        row("section", kFast);
        row("section with a thread", kFast);
        row("section on a conveyor", kFast);
        row("section in force mode", 0.03);
        row("section in freedrive", 0.05, true);
    }
    void aKilledProcessStopsTheArm() {
        QFETCH(QString, way);
        QFETCH(int, loss);
        QFETCH(double, fast);
        QFETCH(bool, hand);
        QFETCH(ScriptState, end);
        simulator::SimulatorOptions options;
        if (way == QLatin1String("torque")) {
            options.software = {5, 25, 1, 0};
        }
        options.anyFreePorts = true;
        options.poweredOn = true;
        options.startJoints = JointPositions(-1.57, -1.2, -2.3, -1.2, 1.57, 0);
        simulator::Simulator robot(options);
        QVERIFY(robot.start().ok());
        robot.changeWorld([](simulator::arm::Environment& world) { world.setConveyorSpeed(0, 1000); });
        test::ArmWatcher watcher(robot, control::ControllerOptions().registers);
        test::MovingProcess helper(program(), {robot.listenAddress(), QString::number(robot.ports().primary),
                                               QString::number(robot.ports().rtde), way});
        const double testTimeout = 60;  // [s] robot time
        QVERIFY(watcher.look());
        const double begin = watcher.time;
        while (watcher.speed < fast) {
            QVERIFY(watcher.look());
            QVERIFY2(watcher.time - begin < testTimeout, "the helper never moved the arm");
            // Apply the force only now, because a force at the start of freedrive causes a protective stop.
            if (hand && watcher.state == ScriptState::Executing) {
                robot.pressHand({{0, 0, 12}, {0, 0, 0}});
            }
        }
        const double killedAt = robot.truth().timestamp;
        switch (static_cast<Loss>(loss)) {
            case Loss::Killed:
                helper.kill();
                break;
            case Loss::Suspended:
                helper.suspend();
                break;
            case Loss::Cut:
                // The observer does not receive data either, so query the robot itself.
                QVERIFY(robot.inject(QStringLiteral("link lost")).ok());
                break;
        }
        if (static_cast<Loss>(loss) == Loss::Cut) {
            const double ms = test::movesOn(robot, killedAt, killedAt + 1.0) * 1000;
            qInfo("%s: to standstill: %.0f ms", QTest::currentDataTag(), ms);
            QVERIFY2(ms <= 250, qPrintable(QString::number(ms)));
            return;
        }
        QVERIFY(watcher.lookUntil(killedAt + 1.0));
        // On a busy computer, the signal may be delayed, so measure from the last packet received by the
        // robot.
        const double ms = (watcher.lastMoved - std::max(killedAt, watcher.heardAt)) * 1000;
        qInfo("%s: to standstill: %.0f ms", QTest::currentDataTag(), ms);
        QVERIFY2(ms <= 250, qPrintable(QString::number(ms)));
        QVERIFY(watcher.stands);
        // Without a motion at the last heartbeat, the process may have ended the motion itself.
        if (watcher.heardIn == ScriptState::Executing) {
            // The last torque remains active until it expires. With a high torque, the arm may reach the
            // speed cap first.
            const bool atCap = way == QLatin1String("torque") && watcher.state == ScriptState::TcpTooFast;
            QVERIFY2(watcher.state == end || atCap,
                     qPrintable(QString::number(static_cast<int>(watcher.state))));
        }
        QCOMPARE(robot.truth().safetyMode, SafetyMode::Normal);
    }

    // The robot measures the duration of output pulses, so a killed process cannot leave an output on.
    void aKilledProcessLeavesNoOutputOn_data() {
        QTest::addColumn<int>("loss");
        for (const Loss loss : kLosses) {
            QTest::newRow(name(loss)) << static_cast<int>(loss);
        }
    }
    void aKilledProcessLeavesNoOutputOn() {
        QFETCH(int, loss);
        simulator::SimulatorOptions options;
        options.anyFreePorts = true;
        options.poweredOn = true;
        simulator::Simulator robot(options);
        QVERIFY(robot.start().ok());
        test::MovingProcess helper(program(), {robot.listenAddress(), QString::number(robot.ports().primary),
                                               QString::number(robot.ports().rtde), QStringLiteral("pulse")});
        const auto isOn = [&robot](int output) { return (robot.truth().digitalOutputs >> output & 1U) != 0; };
        // Returns the robot time at which the output was switched [s]; negative if it was not switched in
        // time.
        const auto timeOf = [&robot, &isOn](int output, bool on, double atMost) {
            const double begin = robot.truth().timestamp;
            while (isOn(output) != on) {
                if (robot.truth().timestamp > begin + atMost) {
                    return -1.0;
                }
                QTest::qSleep(1);
            }
            return robot.truth().timestamp;
        };
        const double began = timeOf(1, true, 60);
        QVERIFY2(began > 0, "the helper did not switch on an output");
        QVERIFY(isOn(2));
        const double lost = robot.truth().timestamp;
        switch (static_cast<Loss>(loss)) {
            case Loss::Killed:
                helper.kill();
                break;
            case Loss::Suspended:
                helper.suspend();
                break;
            case Loss::Cut:
                QVERIFY(robot.inject(QStringLiteral("link lost")).ok());
                break;
        }
        const double held = timeOf(2, false, 2);
        QVERIFY2(held > 0, "the held pulse did not end");
        const double timed = timeOf(1, false, 3);
        QVERIFY2(timed > 0, "the output stayed on");
        qInfo("%s: held pulse off after %.0f ms, pulse of 1500 ms off after %.0f ms", QTest::currentDataTag(),
              (held - lost) * 1000, (timed - began) * 1000);
        QVERIFY(std::abs(timed - began - 1.5) < 0.1);
    }
};

QTEST_GUILESS_MAIN(TestKilledProcess)
#include "tst_killed_process.moc"
