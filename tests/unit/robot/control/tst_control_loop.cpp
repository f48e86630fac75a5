// SPDX-License-Identifier: MIT
#include <QTest>
#include <set>

#include "tests/unit/robot/control/loop_bench.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

using Bench = LoopBench;

}  // namespace

class TestControlLoop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void controlIsConfirmedByAnEchoOfThisSession() {
        Bench bench;
        bench.answering = false;
        bench.data.echo = {17,           3, ScriptState::Ready,
                           kSession - 1, 0, {}};  // an older program that is still running
        bench.tick(2);
        bench.data.echo.sequence = bench.command.sequence;
        bench.tick(2);
        QVERIFY(!bench.loop.isInControl());
        bench.answering = true;
        bench.tick(2);
        QVERIFY(bench.loop.isInControl());
        QCOMPARE(bench.loop.status().loss, ControlLoss::None);
    }

    void aStoppedProgramGivesNoControl() {
        Bench bench;
        bench.data.runtimeState = RuntimeState::Stopped;
        bench.tick(5);
        QVERIFY(!bench.loop.isInControl());
    }

    void everyPackageGetsAFreshSequenceNumber() {
        Bench bench;
        std::set<std::int32_t> seen;
        for (int i = 0; i < 1000; ++i) {
            seen.insert(bench.tick().sequence);
        }
        QCOMPARE(seen.size(), 1000U);
    }

    void aJogIsSentInTheNextPackage() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.05);
        const Command& command = bench.tick();
        QCOMPARE(command.kind, ScriptCommand::JogCartesian);
        QCOMPARE(command.values[0], 0.05);
        QCOMPARE(command.epoch, static_cast<std::int32_t>(jog));
        QCOMPARE(command.acceleration, bench.limits.jogAcceleration);
        bench.tick();
        QVERIFY(bench.loop.status().executing);
        QCOMPARE(bench.loop.status().motion, jog);
    }

    void aStopIsSentInTheNextPackage() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.05);
        bench.tick();
        bench.mailbox.stop(StopCause::Space, bench.now());
        const Command& command = bench.tick();
        QCOMPARE(command.kind, ScriptCommand::Idle);
        QVERIFY(command.epoch > static_cast<std::int32_t>(jog));
        QCOMPARE(bench.loop.status().lastMotion, jog);
        QCOMPARE(bench.loop.status().lastCause, StopCause::Space);
    }

    void aJogWithoutRefreshEndsAfter100Ms() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.05);
        const std::int64_t pressed = bench.now();
        while (bench.tick().kind == ScriptCommand::JogCartesian) {
            QVERIFY(bench.now() - pressed <= 100 * kNsPerMs);
        }
        QVERIFY(bench.now() - pressed > 100 * kNsPerMs);
        QVERIFY(bench.now() - pressed <= 102 * kNsPerMs);
        QCOMPARE(bench.causeOf(jog), StopCause::EventLoopStalled);
        QVERIFY(!bench.mailbox.refresh(jog, bench.now()));
        QCOMPARE(bench.tick(10).kind, ScriptCommand::Idle);
    }

    void aRefreshedJogContinues() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.05);
        for (int i = 0; i < 500; ++i) {
            QCOMPARE(bench.tick().kind, ScriptCommand::JogCartesian);
            if (i % 40 == 0) {
                QVERIFY(bench.mailbox.refresh(jog, bench.now()));
            }
        }
    }

    void leavingASafeModeEndsTheMotion_data() {
        QTest::addColumn<int>("robotMode");
        QTest::addColumn<int>("safetyMode");
        QTest::addColumn<bool>("ends");
        QTest::newRow("reduced") << 7 << 2 << false;
        QTest::newRow("protective stop") << 7 << 3 << true;
        QTest::newRow("recovery") << 7 << 4 << true;
        QTest::newRow("safeguard") << 7 << 5 << true;
        QTest::newRow("emergency stop") << 7 << 7 << true;
        QTest::newRow("three position device") << 7 << 13 << true;
        QTest::newRow("a mode of the future") << 7 << 99 << true;
        QTest::newRow("idle") << 5 << 1 << true;
        QTest::newRow("backdrive") << 6 << 1 << true;
        QTest::newRow("power off") << 3 << 1 << true;
    }
    void leavingASafeModeEndsTheMotion() {
        QFETCH(int, robotMode);
        QFETCH(int, safetyMode);
        QFETCH(bool, ends);
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.05);
        bench.tick();
        bench.data.robotMode = static_cast<RobotMode>(robotMode);
        bench.data.safetyMode = static_cast<SafetyMode>(safetyMode);
        const bool moving = bench.tick().kind == ScriptCommand::JogCartesian;
        QCOMPARE(moving, !ends);
        QCOMPARE(bench.mailbox.epoch().isActive(jog), !ends);
        if (ends) {
            QCOMPARE(bench.causeOf(jog), StopCause::UnsafeMode);
            // After the return to normal mode, the previous jog has ended and a new jog must be started.
            bench.data.robotMode = RobotMode::Running;
            bench.data.safetyMode = SafetyMode::Normal;
            QCOMPARE(bench.tick(5).kind, ScriptCommand::Idle);
            QVERIFY(!bench.mailbox.refresh(jog, bench.now()));
        }
    }

    void aStoppedProgramIsControlLostUntilTakenAgain() {
        for (const RuntimeState state :
             {RuntimeState::Stopped, RuntimeState::Paused, RuntimeState::Pausing}) {
            Bench bench;
            bench.takeControl();
            const MotionId jog = bench.startJog(0.05);
            bench.tick();
            bench.data.runtimeState = state;
            QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
            QCOMPARE(bench.causeOf(jog), StopCause::ControlLost);
            QVERIFY(!bench.loop.isInControl());
            QCOMPARE(bench.loop.status().loss, ControlLoss::ScriptStopped);
            // The program is resumed with Play and responds again, but no motion is permitted.
            bench.data.runtimeState = RuntimeState::Playing;
            bench.tick(10);
            QVERIFY(!bench.loop.isInControl());
            const MotionId next = bench.startJog(0.05);
            QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
            QCOMPARE(bench.causeOf(next), StopCause::ControlLost);
        }
    }

    void anUnresponsiveProgramEndsTheMotionThenControl() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startMove(false);
        bench.tick();
        bench.answering = false;
        const std::int64_t silentSince = bench.now();
        while (bench.mailbox.epoch().isActive(jog)) {
            bench.tick();
            QVERIFY(bench.now() - silentSince < 120 * kNsPerMs);
        }
        QVERIFY(bench.now() - silentSince > 98 * kNsPerMs);
        QCOMPARE(bench.causeOf(jog), StopCause::ControlLost);
        QVERIFY(bench.loop.isInControl());
        bench.tick(250);
        QVERIFY(!bench.loop.isInControl());
        QCOMPARE(bench.loop.status().loss, ControlLoss::EchoStalled);
    }

    // The host was suspended. The backlog does not mean that the program has ended.
    void suspendedHostKeepsControlButNotTheMotion() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startMove(false);
        bench.tick();
        const Echo before = bench.data.echo;
        bench.answering = false;
        bench.clock.advanceNs(700 * kNsPerMs);
        bench.data.echo = before;
        for (int i = 0; i < 350; ++i) {  // the whole backlog
            bench.data.hostNs = bench.now();
            bench.data.timestamp += kPeriod;
            bench.command = bench.loop.tick(bench.data);
        }
        QCOMPARE(bench.causeOf(jog), StopCause::DataStale);
        bench.data.echo.sequence = bench.command.sequence;
        bench.answering = true;
        bench.tick(5);
        QVERIFY(bench.loop.isInControl());
        QCOMPARE(bench.command.kind, ScriptCommand::Idle);
    }

    void aDelayedMotionReportsTheMeasuredTimes_data() {
        QTest::addColumn<QString>("delay");
        QTest::addColumn<QString>("text");
        QTest::newRow("late data") << QStringLiteral("data")
                                   << QStringLiteral(
                                          "no data from the robot for 104 ms (limit 100 ms): the "
                                          "control thread was waiting for data.");
        QTest::newRow("suspended thread")
            << QStringLiteral("thread")
            << QStringLiteral(
                   "no data from the robot for 142 ms (limit 100 ms): this computer was busy, and its "
                   "control thread did not run for 142 ms.");
        QTest::newRow("longer timeout") << QStringLiteral("silence")
                                        << QStringLiteral("no data from the robot for 304 ms (limit 300 ms)");
        QTest::newRow("no response") << QStringLiteral("answer")
                                     << QStringLiteral(
                                            "the control program on the robot did not respond for "
                                            "102 ms (limit 100 ms)");
        QTest::newRow("heartbeat lost on this computer")
            << QStringLiteral("late heartbeat")
            << QStringLiteral(
                   "the robot received no heartbeat for more than 100 ms. This computer sent at "
                   "least one every 92 ms. Use real-time priority");
        QTest::newRow("heartbeat lost in the network")
            << QStringLiteral("lost heartbeat")
            << QStringLiteral(
                   "the robot received no heartbeat for more than 100 ms. This computer sent at "
                   "least one every 2 ms. Check the network");
    }
    void aDelayedMotionReportsTheMeasuredTimes() {
        QFETCH(QString, delay);
        QFETCH(QString, text);
        Bench bench;
        bench.takeControl();
        MotionCommand move;
        move.kind = MotionCommand::Kind::MoveJ;
        move.held = false;
        move.speed = 0.5;
        move.acceleration = 1.4;
        move.heartbeatTimeout = std::chrono::milliseconds(delay == QStringLiteral("silence") ? 300 : 0);
        const MotionId id = bench.mailbox.start(move, bench.now());
        bench.tick(2);
        Command out;
        if (delay == QStringLiteral("data") || delay == QStringLiteral("silence")) {
            while (bench.mailbox.epoch().isActive(id)) {  // the thread polls every 4 ms
                bench.clock.advanceNs(4 * kNsPerMs);
                bench.loop.fallback(bench.now(), out);
            }
        } else if (delay == QStringLiteral("thread")) {
            bench.clock.advanceNs(140 * kNsPerMs);
            bench.tick();
        } else if (delay == QStringLiteral("answer")) {
            bench.answering = false;
            while (bench.mailbox.epoch().isActive(id)) {
                bench.tick();
            }
        } else {
            bench.clock.advanceNs(delay == QStringLiteral("late heartbeat") ? 90 * kNsPerMs : 0);
            bench.tick();
            bench.data.echo.state = ScriptState::Expired;
            bench.tick();
        }
        QVERIFY(!bench.mailbox.epoch().isActive(id));
        QCOMPARE(bench.loop.delay().motion, id);
        QCOMPARE(bench.loop.delay().cause, bench.causeOf(id));
        QVERIFY2(bench.loop.delay().text().startsWith(text), qPrintable(bench.loop.delay().text()));
    }

    // A stop by the caller has no measured delay, even if the data are late afterwards.
    void aStopIsNotReportedAsADelay() {
        Bench bench;
        bench.takeControl();
        const MotionId move = bench.startMove(false);
        bench.tick(2);
        bench.mailbox.stop(StopCause::ApiCall, bench.now());
        bench.clock.advanceNs(200 * kNsPerMs);
        bench.tick();
        QVERIFY(bench.loop.delay().motion != move);
    }

    void aStalledStreamEndsTheMotionWithoutATick() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startMove(false);
        bench.tick();
        Command out;
        bench.clock.advanceNs(100 * kNsPerMs);
        QVERIFY(!bench.loop.fallback(bench.now(), out));
        QVERIFY(bench.mailbox.epoch().isActive(jog));
        bench.clock.advanceNs(kNsPerMs);
        QVERIFY(bench.loop.fallback(bench.now(), out));
        QCOMPARE(out.kind, ScriptCommand::Idle);
        QVERIFY(out.epoch > static_cast<std::int32_t>(jog));
        QVERIFY(out.sequence != bench.command.sequence);
        QCOMPARE(bench.causeOf(jog), StopCause::DataStale);
        QVERIFY(!bench.loop.fallback(bench.now(), out));  // sent only once
        QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
    }

    // If no data arrive after a release, the stop is sent without waiting for them.
    void aStopDoesNotWaitForALatePackage() {
        Bench bench;
        bench.takeControl();
        bench.startJog(0.05);
        bench.tick();
        bench.mailbox.stop(StopCause::Released, bench.now());
        Command out;
        bench.clock.advanceNs(5 * kNsPerMs);
        QVERIFY(!bench.loop.fallback(bench.now(), out));
        bench.clock.advanceNs(6 * kNsPerMs);
        QVERIFY(bench.loop.fallback(bench.now(), out));
        QCOMPARE(out.kind, ScriptCommand::Idle);
    }

    // Applies to a jog, to force mode alone, and to a stream that has just sent a setpoint.
    void aStopIsSentBetweenTwoPackages() {
        LoopBench bench;
        bench.takeControl();
        Command command;
        bench.startJog(0.1);
        bench.tick();
        QVERIFY(!bench.loop.early(bench.now(), command));
        bench.mailbox.stop(StopCause::Released, bench.now());
        QVERIFY(bench.loop.early(bench.now(), command));
        QVERIFY(command.kind == ScriptCommand::Idle);
        QVERIFY(!bench.loop.early(bench.now(), command));

        bench.loop.permitForce(true);
        QVERIFY(bench.tick().forcePermitted);
        QVERIFY(!bench.loop.early(bench.now(), command));
        bench.mailbox.stop(StopCause::Released, bench.now());
        bench.loop.permitForce(false);
        QVERIFY(bench.loop.early(bench.now(), command));
        QVERIFY(!command.forcePermitted);
        QVERIFY(!bench.loop.early(bench.now(), command));

        bench.startStream();
        bench.tick();
        QVERIFY(bench.loop.early(bench.now(), command));
        QVERIFY(command.kind == ScriptCommand::SpeedL);
        QVERIFY(!bench.loop.early(bench.now(), command));
        bench.mailbox.stop(StopCause::Released, bench.now());
        QVERIFY(bench.loop.early(bench.now(), command));
        QVERIFY(command.kind == ScriptCommand::Idle);
    }

    void aHungHolderIsDetectedWhileTheStreamStalls() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.05);
        bench.tick();
        bench.clock.advanceNs(99 * kNsPerMs);
        Command out;
        QVERIFY(bench.loop.fallback(bench.now(), out));
        QCOMPARE(bench.causeOf(jog), StopCause::EventLoopStalled);
    }
};

QTEST_GUILESS_MAIN(TestControlLoop)
#include "tst_control_loop.moc"
