// SPDX-License-Identifier: MIT
#include <QTest>
#include <random>
#include <set>
#include <thread>

#include "robot/control/control_loop.h"
#include "robot/core/clock.h"
#include "robot/kinematics/arm_kinematics.h"

using namespace tiller;
using namespace tiller::control;

namespace {

constexpr std::int32_t kSession = 4711;
constexpr double kPeriod = 0.002;
constexpr std::int64_t kPeriodNs = 2 * kNsPerMs;
constexpr double kDeg = 3.14159265358979323846 / 180;
const JointPositions kPose(-90 * kDeg, -100 * kDeg, -110 * kDeg, -60 * kDeg, 90 * kDeg, 0);

// Time, mailbox, loop, and a robot that answers as control.script does: one package late, in good order.
struct Bench {
    VirtualClock clock;
    Mailbox mailbox;
    MotionLimits limits;
    ControlLoop loop{mailbox, limits};
    Feedback data;
    Command command;  ///< the last one sent
    bool answering = true;

    Bench() {
        data.runtimeState = RuntimeState::Playing;
        data.robotMode = RobotMode::Running;
        data.safetyMode = SafetyMode::Normal;
        data.q = kPose;
        data.tcpPose = kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, kPose);
        data.timestamp = 60;
        loop.begin(kSession, kPeriod, ArmLimits::of(robotModel(RobotModelId::UR5e)), clock.nowNs());
    }

    std::int64_t now() const { return clock.nowNs(); }

    const Command& tick(int times = 1) {
        for (int i = 0; i < times; ++i) {
            clock.advanceNs(kPeriodNs);
            data.hostNs = now();
            data.timestamp += kPeriod;
            command = loop.tick(data);
            if (answering) {
                data.echo.sequence = command.sequence;
                data.echo.epoch = command.epoch;
                data.echo.session = command.session;
                data.echo.state =
                    command.kind == ScriptCommand::Idle ? ScriptState::Ready : ScriptState::Executing;
            }
        }
        return command;
    }

    void takeControl() {
        tick(3);
        QVERIFY(loop.isInControl());
    }

    MotionId startJog(double x) {
        MotionCommand jog;
        jog.kind = MotionCommand::Kind::Jog;
        jog.jog.twist.linear.x() = x;
        return mailbox.start(jog, now());
    }

    MotionId startMove(bool held) {
        MotionCommand move;
        move.kind = MotionCommand::Kind::MoveJ;
        move.held = held;
        move.target = {1, 2, 3, 4, 5, 6};
        move.speed = 0.5;
        move.acceleration = 1.4;
        return mailbox.start(move, now());
    }

    StopCause causeOf(MotionId motion) const { return mailbox.epoch().state(motion).cause; }
};

}  // namespace

class TestControlLoop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void controlIsProvedByAnEchoOfThisSession() {
        Bench bench;
        bench.answering = false;
        bench.data.echo = {17, 3, ScriptState::Ready, kSession - 1};  // an older program, still alive
        bench.tick(2);
        bench.data.echo.sequence = bench.command.sequence;
        bench.tick(2);
        QVERIFY(!bench.loop.isInControl());
        bench.answering = true;
        bench.tick(2);
        QVERIFY(bench.loop.isInControl());
        QCOMPARE(bench.loop.status().loss, ControlLoss::None);
    }

    void aProgramThatDoesNotRunIsNoControl() {
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

    void aRefreshedJogGoesOn() {
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
            // All well again: the old jog stays dead, a new one is needed.
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
            // Somebody presses play: the program answers again, and still nothing may move.
            bench.data.runtimeState = RuntimeState::Playing;
            bench.tick(10);
            QVERIFY(!bench.loop.isInControl());
            const MotionId next = bench.startJog(0.05);
            QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
            QCOMPARE(bench.causeOf(next), StopCause::ControlLost);
        }
    }

    void aProgramThatAnswersNoMoreEndsTheMotionThenTheControl() {
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

    // The host was away for a while: the packages that waited are no proof that the program is gone.
    void aHostThatWasAwayKeepsControlButNotTheMotion() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startMove(false);
        bench.tick();
        const Echo before = bench.data.echo;
        bench.answering = false;
        bench.clock.advanceNs(700 * kNsPerMs);
        bench.data.echo = before;
        for (int i = 0; i < 350; ++i) {  // the backlog, all at once
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
        QVERIFY(!bench.loop.fallback(bench.now(), out));  // once is enough
        QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
    }

    // Release while no data come: the stop does not wait for the stream to come back.
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

    void aHungHolderIsFoundOutEvenWhenTheStreamStalls() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.05);
        bench.tick();
        bench.clock.advanceNs(99 * kNsPerMs);
        Command out;
        QVERIFY(bench.loop.fallback(bench.now(), out));
        QCOMPARE(bench.causeOf(jog), StopCause::EventLoopStalled);
    }

    void aMoveIsSentWithItsParametersUntilItIsDone() {
        Bench bench;
        bench.takeControl();
        const MotionId move = bench.startMove(false);
        for (int i = 0; i < 200; ++i) {
            const Command& command = bench.tick();
            QCOMPARE(command.kind, ScriptCommand::MoveJ);
            QCOMPARE(command.values[5], 6.0);
            QCOMPARE(command.speed, 0.5);
            QCOMPARE(command.acceleration, 1.4);
        }
        bench.data.echo.state = ScriptState::Done;
        QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
        QCOMPARE(bench.causeOf(move), StopCause::Completed);
        QCOMPARE(bench.loop.status().lastCause, StopCause::Completed);
    }

    void doneOfAnOlderEpochIsNotDone() {
        Bench bench;
        bench.takeControl();
        const MotionId move = bench.startMove(false);
        bench.answering = false;
        bench.tick();
        bench.data.echo.epoch = static_cast<std::int32_t>(move) - 1;
        bench.data.echo.state = ScriptState::Done;
        bench.tick(3);
        QVERIFY(bench.mailbox.epoch().isActive(move));
    }

    void theRobotsOwnTimeToLiveEndsTheMotionHereToo() {
        Bench bench;
        bench.takeControl();
        const MotionId move = bench.startMove(false);
        bench.tick(2);
        bench.data.echo.state = ScriptState::Expired;
        QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
        QCOMPARE(bench.causeOf(move), StopCause::LinkLost);
    }

    void aHeldMoveEndsWithoutItsHolder() {
        Bench bench;
        bench.takeControl();
        const MotionId move = bench.startMove(true);
        bench.tick(49);
        QVERIFY(bench.mailbox.epoch().isActive(move));
        bench.tick(3);
        QCOMPARE(bench.causeOf(move), StopCause::EventLoopStalled);
    }

    void aJogIntoALimitEndsAndNamesIt() {
        Bench bench;
        bench.takeControl();
        bench.data.q[3] = kJointPositionLimit - 0.005;
        MotionCommand jog;
        jog.kind = MotionCommand::Kind::Jog;
        jog.jog.kind = JogTarget::Kind::Joint;
        jog.jog.qd[3] = 0.2;
        const MotionId motion = bench.mailbox.start(jog, bench.now());
        QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
        QCOMPARE(bench.causeOf(motion), StopCause::LimitReached);
        QCOMPARE(bench.loop.status().limiter.kind, LimiterKind::JointLimit);
        QCOMPARE(bench.loop.status().limiter.joint, 3);
        // Away from it is free, and the name goes away.
        jog.jog.qd[3] = -0.2;
        bench.mailbox.start(jog, bench.now());
        QCOMPARE(bench.tick().kind, ScriptCommand::JogJoints);
        QCOMPARE(bench.loop.status().limiter.kind, LimiterKind::None);
    }

    void aChangedTcpEndsTheJog() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.05);
        bench.tick(3);
        bench.data.tcpOffset.position.z() = 0.1;
        bench.tick();
        QCOMPARE(bench.causeOf(jog), StopCause::SelectionChanged);
    }

    void fasterThanAskedBrakesBriskly() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.2);
        bench.tick();
        bench.data.tcpSpeed.linear.x() = 0.2;
        JogTarget slower;
        slower.twist.linear.x() = 0.02;
        QVERIFY(bench.mailbox.refresh(jog, slower, bench.now()));
        QCOMPARE(bench.tick().acceleration, bench.limits.jogDeceleration);
        bench.data.tcpSpeed.linear.x() = 0.02;
        QCOMPARE(bench.tick().acceleration, bench.limits.jogAcceleration);
    }

    void theStopIsMeasuredFromTheMomentItWasAskedFor() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.1);
        bench.tick();
        bench.data.tcpSpeed.linear.x() = 0.1;
        bench.tick(20);
        bench.clock.advanceNs(kNsPerMs);
        QVERIFY(bench.mailbox.end(jog, StopCause::Released, bench.now()));
        bench.clock.advanceNs(-kNsPerMs);
        for (int i = 0; i < 25; ++i) {  // 50 ms, 2 mm
            bench.data.tcpPose.position.x() += 0.00008;
            bench.tick();
        }
        bench.data.tcpSpeed.linear.x() = 0;
        bench.tick(5);
        const StopMeasurement stop = bench.loop.status().lastStop;
        QCOMPARE(stop.count, 1U);
        QCOMPARE(stop.cause, StopCause::Released);
        QVERIFY(std::abs(stop.durationMs - 51) < 0.01);
        QVERIFY(std::abs(stop.distanceMm - 2) < 0.01);
    }

    void theRoundTripIsTheTimeUntilTheEcho() {
        Bench bench;
        bench.takeControl();
        bench.tick(10);
        QVERIFY(std::abs(bench.loop.status().roundTripMs - 2) < 1e-9);
    }

    void aLostConnectionEndsMotionAndControl() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.1);
        bench.tick();
        bench.loop.lost(bench.now(), ControlLoss::LinkLost);
        QCOMPARE(bench.causeOf(jog), StopCause::LinkLost);
        QVERIFY(!bench.loop.isInControl());
        QCOMPARE(bench.loop.status().loss, ControlLoss::LinkLost);
        QCOMPARE(bench.loop.status().lastMotion, jog);
    }

    void beingAskedToEndTellsTheProgram() {
        Bench bench;
        bench.takeControl();
        bench.startJog(0.1);
        bench.tick();
        bench.loop.requestEnd();
        QCOMPARE(bench.tick().kind, ScriptCommand::End);
        bench.data.runtimeState = RuntimeState::Stopped;
        bench.tick();
        QCOMPARE(bench.loop.status().loss, ControlLoss::Released);
    }

    // Random presses, refreshes, hangs, stalls and stops. Two things must always hold: a package that moves
    // carries the epoch of a motion that was alive when it was made, and no motion is seen moving again once
    // it has been seen stopped.
    void randomSequencesNeverMoveWhatWasStopped() {
        std::mt19937 random(20261121);
        const auto chance = [&](int oneIn) {
            return std::uniform_int_distribution<int>(1, oneIn)(random) == 1;
        };
        Bench bench;
        bench.takeControl();
        MotionId jog = kNoMotion;
        std::int64_t refreshedNs = 0;
        std::int32_t lastMoving = 0;
        std::int32_t lastStopped = 0;
        int moved = 0;
        for (int step = 0; step < 200'000; ++step) {
            if (chance(30)) {
                jog = bench.startJog(0.05);
                refreshedNs = bench.now();
            }
            if (chance(10) && bench.mailbox.refresh(jog, bench.now())) {
                refreshedNs = bench.now();
            }
            if (chance(40)) {
                bench.mailbox.end(jog, StopCause::Released, bench.now());
            }
            if (chance(60)) {
                bench.mailbox.stop(StopCause::Escape, bench.now());
            }
            if (chance(200)) {
                bench.clock.advanceNs(std::uniform_int_distribution<std::int64_t>(1, 300)(random) * kNsPerMs);
                Command out;
                if (bench.loop.fallback(bench.now(), out)) {
                    QCOMPARE(out.kind, ScriptCommand::Idle);
                    lastStopped = out.epoch;
                }
            }
            const Command& command = bench.tick();
            if (command.kind == ScriptCommand::Idle) {
                lastStopped = command.epoch;
                continue;
            }
            ++moved;
            QVERIFY(command.epoch > lastStopped);
            QVERIFY(command.epoch >= lastMoving);
            QVERIFY(bench.now() - refreshedNs <= kHoldTimeNs);
            QVERIFY(bench.mailbox.epoch().isActive(static_cast<MotionId>(command.epoch)));
            lastMoving = command.epoch;
        }
        QVERIFY(moved > 10'000);
    }

    // Eight threads start, hold, change and stop motions without rest while the loop ticks.
    void stopIsFinalForTheRobotUnderContention() {
        Bench bench;
        bench.takeControl();
        std::atomic<bool> quit{false};
        std::vector<std::thread> threads;
        for (int t = 0; t < 8; ++t) {
            threads.emplace_back([&, t] {
                JogTarget target;
                MotionCommand start;
                start.kind = MotionCommand::Kind::Jog;
                for (int n = 1; !quit; ++n) {
                    target.twist.linear.x() = 0.001 * (n % 50);
                    start.jog = target;
                    const MotionId jog = bench.mailbox.start(start, bench.clock.nowNs());
                    bench.mailbox.refresh(jog, target, bench.clock.nowNs());
                    if ((n + t) % 3 == 0) {
                        bench.mailbox.stop(StopCause::Space, bench.clock.nowNs());
                    }
                    bench.mailbox.refresh(jog, target, bench.clock.nowNs());
                    std::this_thread::yield();
                }
            });
        }
        std::int32_t lastStopped = 0;
        std::int32_t last = 0;
        int moving = 0;
        int idle = 0;
        bool inOrder = true;
        while (moving < 500 || idle < 500) {
            const Command& command = bench.tick();
            inOrder = inOrder && command.epoch >= last;
            last = command.epoch;
            if (command.kind == ScriptCommand::Idle) {
                lastStopped = command.epoch;
                ++idle;
            } else {
                inOrder = inOrder && command.epoch > lastStopped;
                ++moving;
            }
        }
        quit = true;
        for (auto& thread : threads) {
            thread.join();
        }
        QVERIFY(inOrder);
        bench.mailbox.stop(StopCause::StopButton, bench.clock.nowNs());
        for (int i = 0; i < 100; ++i) {
            QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
        }
    }
};

QTEST_GUILESS_MAIN(TestControlLoop)
#include "tst_control_loop.moc"
