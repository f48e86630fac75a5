// SPDX-License-Identifier: MIT
// More tests of the control loop: moves and streams, limits, measured stops, motion away from limits, and
// stops under contention.
#include <QTest>
#include <random>
#include <thread>

#include "tests/unit/robot/control/loop_bench.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

using Bench = LoopBench;

}  // namespace

class TestControlLoopMotions : public QObject {
    Q_OBJECT

private Q_SLOTS:
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

    void aJogUntilContactIgnoresASingleNoisyPackage() {
        Bench bench;
        bench.data.tcpForce = Eigen::Vector3d(0, 0, 30);  // a permanent load at the tool is not a contact
        bench.takeControl();
        const auto begin = [&] {
            MotionCommand jog;
            jog.kind = MotionCommand::Kind::Jog;
            jog.jog.twist.linear.z() = -0.01;
            jog.jog.contactForce = 10;
            return bench.mailbox.start(jog, bench.now());
        };
        MotionId jog = begin();
        QCOMPARE(bench.tick(5).kind, ScriptCommand::JogCartesian);
        bench.data.tcpForce = Eigen::Vector3d(0, 0, 45);
        QCOMPARE(bench.tick(2).kind, ScriptCommand::JogCartesian);
        bench.data.tcpForce = Eigen::Vector3d(0, 0, 39);
        QCOMPARE(bench.tick(2).kind, ScriptCommand::JogCartesian);
        bench.data.tcpForce = Eigen::Vector3d(0, 0, 41);
        QCOMPARE(bench.tick(3).kind, ScriptCommand::Idle);
        QCOMPARE(bench.causeOf(jog), StopCause::Contact);
        // The next jog uses the current force as its reference.
        jog = begin();
        QCOMPARE(bench.tick(10).kind, ScriptCommand::JogCartesian);
        // Without force data there is no motion with contact detection.
        bench.data.tcpForce.reset();
        QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
        QCOMPARE(bench.causeOf(jog), StopCause::Contact);
    }

    void completionOfAnOlderEpochIsIgnored() {
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

    void timeToLiveOnTheRobotEndsTheMotionOnTheHost() {
        Bench bench;
        bench.takeControl();
        const MotionId move = bench.startMove(false);
        bench.tick(2);
        bench.data.echo.state = ScriptState::Expired;
        QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
        QCOMPARE(bench.causeOf(move), StopCause::LinkLost);
    }

    void aHeldMoveEndsWithoutRefresh() {
        Bench bench;
        bench.takeControl();
        const MotionId move = bench.startMove(true);
        bench.tick(49);
        QVERIFY(bench.mailbox.epoch().isActive(move));
        bench.tick(3);
        QCOMPARE(bench.causeOf(move), StopCause::EventLoopStalled);
    }

    void aJogIntoALimitEndsAndReportsIt() {
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
        // Motion away from the limit is not slowed down, and the limit is not reported.
        jog.jog.qd[3] = -0.2;
        bench.mailbox.start(jog, bench.now());
        QCOMPARE(bench.tick().kind, ScriptCommand::JogJoints);
        QCOMPARE(bench.loop.status().limiter.kind, LimiterKind::None);
    }

    void aPacketWithoutAPositionEndsTheJog() {
        for (const double nonsense : {std::nan(""), std::numeric_limits<double>::infinity()}) {
            Bench bench;
            bench.takeControl();
            const MotionId jog = bench.startJog(0.05);
            QCOMPARE(bench.tick(2).kind, ScriptCommand::JogCartesian);
            bench.data.q[4] = nonsense;
            QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
            QCOMPARE(bench.causeOf(jog), StopCause::LimitReached);
            QVERIFY(!bench.mailbox.epoch().isActive(bench.startJog(0.05)) ||
                    bench.tick().kind == ScriptCommand::Idle);
        }
    }

    void torquesAreSentWithTheCapAndEndAboveIt_data() {
        QTest::addColumn<ScriptState>("state");
        QTest::addColumn<LimiterKind>("limiter");
        QTest::newRow("TCP") << ScriptState::TcpTooFast << LimiterKind::TcpSpeed;
        QTest::newRow("elbow") << ScriptState::ElbowTooFast << LimiterKind::ElbowSpeed;
    }
    void torquesAreSentWithTheCapAndEndAboveIt() {
        QFETCH(ScriptState, state);
        QFETCH(LimiterKind, limiter);
        Bench bench;
        bench.takeControl();
        MotionCommand stream;
        stream.kind = MotionCommand::Kind::Program;
        stream.program = static_cast<std::int32_t>(ScriptCommand::Torque);
        stream.held = false;
        const MotionId motion = bench.mailbox.start(stream, bench.now());
        QCOMPARE(bench.tick().kind, ScriptCommand::Torque);
        QCOMPARE(bench.command.choice, 0);
        MotionCommand target;
        target.target = {1, 2, 3, 4, 5, 6};
        target.choice = 1;
        QVERIFY(bench.mailbox.change(motion, target, bench.now()));
        QCOMPARE(bench.tick().values[5], 6.0);
        QCOMPARE(bench.command.choice, 250);
        bench.data.echo.state = state;
        QCOMPARE(bench.tick().kind, ScriptCommand::Idle);
        QCOMPARE(bench.causeOf(motion), StopCause::LimitReached);
        QCOMPARE(bench.loop.status().limiter.kind, limiter);
        QCOMPARE(bench.loop.status().limiter.scale, 0.0);
        // With kNoCap, the cap sent with the torques is too high for the arm to reach.
        bench.loop.setSpeedCap(kNoCap);
        const MotionId next = bench.mailbox.start(stream, bench.now());
        QVERIFY(bench.mailbox.change(next, target, bench.now()));
        bench.tick();
        QVERIFY(bench.command.choice > 100'000);
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

    void aJogBrakesHardWhenFasterThanRequested() {
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

    void theStopIsMeasuredFromItsRequest() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.1);
        bench.tick();
        bench.data.tcpSpeed.linear.x() = 0.1;
        bench.tick(20);
        bench.clock.advanceNs(kNsPerMs);
        QVERIFY(bench.mailbox.end(jog, StopCause::Released, bench.now()));
        bench.clock.advanceNs(-kNsPerMs);
        for (int i = 0; i < 25; ++i) {  // expected: 50 ms, 2 mm
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

    // An upload may fail before or after the next package, and the robot may nevertheless start the program.
    void aProgramThatStartsAfterItsUploadFailedEnds_data() {
        QTest::addColumn<int>("ticks");
        QTest::newRow("failed at once") << 0;
        QTest::newRow("failed later") << 5;
    }
    void aProgramThatStartsAfterItsUploadFailedEnds() {
        QFETCH(const int, ticks);
        LoopBench bench;
        bench.takeControl();
        bench.loop.requestEnd(ControlLoss::Taking);
        bench.tick();
        bench.answering = false;
        bench.data.runtimeState = RuntimeState::Stopped;
        bench.tick(2);
        QVERIFY(!bench.loop.isInControl());
        bench.loop.expectSession(kSession + 1);
        bench.tick(ticks);
        bench.loop.requestEnd(ControlLoss::ScriptStopped);
        bench.loop.abandonTaking();
        bench.tick();
        QCOMPARE(bench.loop.status().loss, ControlLoss::ScriptStopped);
        bench.data.runtimeState = RuntimeState::Playing;
        bench.answering = true;
        bench.tick(3);
        QCOMPARE(bench.command.session, kSession + 1);
        QCOMPARE(bench.command.kind, ScriptCommand::End);
        bench.data.runtimeState = RuntimeState::Stopped;
        bench.tick();
        QVERIFY(!bench.loop.isInControl());
        QCOMPARE(bench.loop.status().loss, ControlLoss::ScriptStopped);
    }

    void endRequestIsSentToTheProgram() {
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

    // Random presses, refreshes, hangs, stalls and stops. Two conditions must always be true. A package that
    // moves the arm has the epoch of a motion that was active when the package was created. No motion moves
    // the arm again after it was reported as stopped.
    void randomSequencesNeverResumeAStoppedMotion() {
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

    // Eight threads continuously start, hold, change and stop motions while the loop ticks.
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

    // A round trip of more than 100 ms would also delay a stop too much.
    void aLateLinkEndsTheMotionAndPreventsNewOnes() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.1);
        bench.tick(2);
        // From here on, the delay of the robot's replies increases by one package in every fourth period.
        std::vector<Command> sent{bench.command};
        bench.answering = false;
        MotionState state = bench.mailbox.epoch().state(jog);
        for (int i = 0; i < 300 && state.phase == MotionPhase::Active; ++i) {
            bench.mailbox.refresh(jog, bench.now());
            bench.tick();
            sent.push_back(bench.command);
            const std::size_t behind =
                std::min<std::size_t>(sent.size() - 1, static_cast<std::size_t>(i) / 4);
            const Command& old = sent[sent.size() - 1 - behind];
            bench.data.echo.sequence = old.sequence;
            bench.data.echo.epoch = old.epoch;
            bench.data.echo.session = old.session;
            bench.data.echo.state = ScriptState::Executing;
            state = bench.mailbox.epoch().state(jog);
        }
        QCOMPARE(state.phase, MotionPhase::Ended);
        QCOMPARE(state.cause, StopCause::LinkLost);
        QVERIFY(bench.loop.status().roundTripMs > kMaxRoundTripMs);
        QVERIFY(bench.loop.isInControl());
    }

    void aStopMeasurementIsCancelledByTheNextMotion() {
        Bench bench;
        bench.takeControl();
        const MotionId jog = bench.startJog(0.1);
        bench.tick();
        bench.data.tcpSpeed.linear.x() = 0.1;
        bench.tick(20);
        QVERIFY(bench.mailbox.end(jog, StopCause::Released, bench.now()));
        bench.tick(3);  // the arm still moves, so the stop is being measured
        const MotionId next = bench.startJog(0.05);
        bench.tick(3);
        bench.data.tcpSpeed.linear.x() = 0;
        bench.tick(10);  // standstill by chance, not the end of the requested stop
        QCOMPARE(bench.loop.status().lastStop.count, 0U);
        bench.mailbox.end(next, StopCause::Released, bench.now());
        bench.tick(10);
        QCOMPARE(bench.loop.status().lastStop.count, 1U);
    }

    // The motion of another client's program is not the stop of the jog that it replaced.
    void theMotionOfAnotherProgramIsNotMeasuredAsAStop_data() {
        QTest::addColumn<bool>("seenStopped");
        QTest::addRow("the program state shows the change") << true;
        QTest::addRow("control.script does not answer") << false;
    }
    void theMotionOfAnotherProgramIsNotMeasuredAsAStop() {
        QFETCH(const bool, seenStopped);
        Bench bench;
        bench.takeControl();
        bench.startJog(0.1);
        bench.data.tcpSpeed.linear.x() = 0.1;
        bench.tick(20);
        bench.answering = false;
        if (seenStopped) {
            bench.data.runtimeState = RuntimeState::Stopped;
            bench.tick(5);
            bench.data.runtimeState = RuntimeState::Playing;
        }
        bench.tick(500);
        QVERIFY(!bench.loop.isInControl());
        bench.data.tcpSpeed.linear.x() = 0;
        bench.tick(10);  // the other program pauses
        QCOMPARE(bench.loop.status().lastStop.count, 0U);
        QCOMPARE(bench.loop.status().lastUnmeasured.count, 1U);
        // Without answers, the hold ends before control is lost, because the bench does not refresh it.
        QCOMPARE(bench.loop.status().lastUnmeasured.cause,
                 seenStopped ? StopCause::ControlLost : StopCause::EventLoopStalled);
        QCOMPARE(bench.loop.status().lastUnmeasured.reason, UnmeasuredStop::Reason::OtherProgram);
    }

    // The arm reaches standstill before the other program moves it.
    void aStopBeforeAnotherProgramIsMeasured() {
        Bench bench;
        bench.takeControl();
        bench.startJog(0.1);
        bench.data.tcpSpeed.linear.x() = 0.1;
        bench.tick(20);
        bench.data.runtimeState = RuntimeState::Stopped;
        bench.tick(30);
        bench.data.tcpSpeed.linear.x() = 0;
        bench.tick(5);
        bench.data.runtimeState = RuntimeState::Playing;
        bench.data.tcpSpeed.linear.x() = 0.2;
        bench.tick(50);
        QCOMPARE(bench.loop.status().lastStop.count, 1U);
        QCOMPARE(bench.loop.status().lastUnmeasured.count, 0U);
    }

    void requestsAreRepeatedUntilTheNextOne() {
        Bench bench;
        bench.takeControl();
        Request request;
        request.kind = RequestKind::SetTcp;
        request.numbers = {1, 2, 3, 4, 5, 6};
        const std::int32_t number = bench.loop.ask(request);
        for (int i = 0; i < 5; ++i) {
            QCOMPARE(bench.tick().request.number, number);
            QCOMPARE(bench.command.request.numbers[5], 6.0);
        }
        bench.startJog(0.1);
        bench.tick();
        bench.clock.advanceNs(200 * kNsPerMs);
        Command out;
        QVERIFY(bench.loop.fallback(bench.now(), out));
        QCOMPARE(out.request.number,
                 number);  // another number would make the robot execute the request again
        bench.data.echo.answer.number = number;
        bench.data.echo.answer.whole = 7;
        bench.tick();
        QCOMPARE(bench.loop.answer().number, number);
        QCOMPARE(bench.loop.answer().whole, 7);
    }

    void theDecelerationOfAStopIsNotInherited() {
        Bench bench;
        bench.takeControl();
        bench.startStream();
        QCOMPARE(bench.tick().kind, ScriptCommand::SpeedL);
        bench.mailbox.stop({0, Brake::Along::Line, 0.3, 0.4}, StopCause::ApiCall, bench.now());
        bench.tick();
        QCOMPARE(bench.command.kind, ScriptCommand::Idle);
        QCOMPARE(bench.command.choice, static_cast<std::int32_t>(Brake::Along::Line));
        QCOMPARE(bench.command.acceleration, 0.3);
        QCOMPARE(bench.command.rotationAcceleration, 0.4);
        bench.mailbox.stop(StopCause::StopButton, bench.now());
        bench.tick();
        QCOMPARE(bench.command.choice, 0);
    }

    void forceModeIsPermittedOnlyInNormalOperation() {
        Bench bench;
        bench.takeControl();
        QVERIFY(!bench.tick().forcePermitted);
        bench.loop.permitForce(true);
        QVERIFY(bench.tick().forcePermitted);
        bench.data.safetyMode = SafetyMode::ProtectiveStop;
        bench.tick();
        bench.data.safetyMode = SafetyMode::Normal;
        QVERIFY(!bench.tick().forcePermitted);
    }

    void forceModeEndsWithoutRefreshOfItsHolder() {
        Bench bench;
        bench.takeControl();
        bench.startMove(true);
        bench.loop.permitForce(true);
        QVERIFY(bench.tick(2).forcePermitted);
        bench.tick(static_cast<int>(kHoldTimeNs / kPeriodNs) + 3);
        QVERIFY(!bench.command.forcePermitted);
    }

    void abandonedRequestIsNotSent() {
        Bench bench;
        bench.takeControl();
        const auto number = bench.loop.ask({0, RequestKind::SetPayload, 0, {3, 0, 0, 0, 0, 0}});
        QCOMPARE(bench.tick().request.number, number);
        bench.loop.withdraw();
        QCOMPARE(bench.tick().request.kind, RequestKind::None);
        bench.loop.ask({0, RequestKind::SetPayload, 0, {3, 0, 0, 0, 0, 0}});
        bench.loop.begin(kSession, kPeriod, ArmLimits::of(robotModel(RobotModelId::UR5e)), bench.now());
        QCOMPARE(bench.tick().request.kind, RequestKind::None);
    }

    // Eight threads continuously send targets, with 10 000 stops in between. No package after the first idle
    // package moves the robot.
    void stopIsFinalUnderEightThreadsOfSetpoints() {
        Bench bench;
        bench.takeControl();
        std::atomic<bool> quit{false};
        std::atomic<MotionId> stream{kNoMotion};
        std::vector<std::thread> threads;
        for (int t = 0; t < 8; ++t) {
            threads.emplace_back([&] {
                MotionCommand target;
                while (!quit) {
                    target.target[0] += 0.001;
                    bench.mailbox.change(stream.load(), target, bench.clock.nowNs());
                    std::this_thread::yield();
                }
            });
        }
        constexpr int kRounds = 10'000;
        int final = 0;
        for (int round = 0; round < kRounds; ++round) {
            stream = bench.startStream();
            const bool moved = bench.tick(2).kind == ScriptCommand::SpeedL;
            bench.mailbox.stop(StopCause::StopButton, bench.now());
            bool idle = true;
            for (int i = 0; i < 3; ++i) {
                idle = idle && bench.tick().kind == ScriptCommand::Idle;
            }
            final += moved && idle ? 1 : 0;
        }
        quit = true;
        for (auto& thread : threads) {
            thread.join();
        }
        QCOMPARE(final, kRounds);
    }
};

QTEST_GUILESS_MAIN(TestControlLoopMotions)
#include "tst_control_loop_motions.moc"
