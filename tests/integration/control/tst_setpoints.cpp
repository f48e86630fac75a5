// SPDX-License-Identifier: MIT
// Servo and speed streams, stops with a deceleration of their own, and the loop locked to the packets.
#include <cmath>

#include "robot/control/motions.h"
#include "robot/control/packet_loop.h"
#include "tests/integration/control/cell.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

class TestSetpoints : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void servoJFollowsItsTargets() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        const JointPositions start = cell.robot.truth().q;
        auto servo = motions.startServoJ();
        QVERIFY2(servo.ok(), qPrintable(servo.error().toString()));
        JointPositions target = start;
        for (int i = 0; i < 500; ++i) {
            target[5] = start[5] + 0.1 * (1 - std::cos(3.14159265 * i / 500));
            QVERIFY(servo->send(target).ok());
            QVERIFY(cell.step());
        }
        for (int i = 0; i < 200; ++i) {
            QVERIFY(servo->send(target).ok());
            QVERIFY(cell.step());
        }
        QVERIFY(std::abs(cell.robot.truth().q[5] - target[5]) < 2e-3);
        QVERIFY(servo->motion().cancel());
        QCOMPARE(servo->send(target).error().code, ErrorCode::Stopped);
        QVERIFY(cell.ticksToStandstill(500) >= 0);
    }

    void aServoHoldsItsPlaceUntilThereIsATarget() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        auto servo = Motions(*cell.controller).startServoL({}, Holding::Free);
        QVERIFY(servo.ok());
        QVERIFY(cell.stepMs(300));
        QVERIFY((cell.robot.truth().q.values - start.values).norm() < 1e-3);
    }

    void servoLFollowsPosesAndSaysWhenThereIsNone() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        auto servo = Motions(*cell.controller).startServoL({}, Holding::Free);
        QVERIFY(servo.ok());
        Pose target = cell.tcp();
        for (int i = 0; i < 200; ++i) {
            target.position.z() += 0.0001;
            QVERIFY(servo->send(target).ok());
            QVERIFY(cell.step());
        }
        QVERIFY(cell.stepMs(400));
        QVERIFY((cell.tcp().position - target.position).norm() < 1e-3);

        // Stretched out, a few millimetres are out of reach.
        JointPositions stretched = cell.robot.truth().q;
        stretched[1] = -90 * kDeg;
        stretched[2] = -3 * kDeg;
        const auto move = Motions(*cell.controller).moveJ(stretched, {0.8, 1.4, Holding::Free});
        QVERIFY(move.ok());
        QVERIFY(cell.during([&] { return move->wait(patience()); }).ok());
        servo = Motions(*cell.controller).startServoL({}, Holding::Free);
        QVERIFY(servo.ok());
        target = cell.tcp();
        target.position.z() += 0.009;
        QVERIFY(servo->send(target).ok());
        QVERIFY(cell.stepMs(100));
        QCOMPARE(servo->motion().state().cause, StopCause::Unreachable);
        QCOMPARE(servo->motion().wait(patience()).error().code, ErrorCode::NoSolution);
        QVERIFY(cell.controller->status().inControl);
    }

    // Neither the first target nor a later one may be further off than the arm can get; what is refused is
    // named, has not been sent, and the stream goes on.
    void aServoRefusesToJump() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        const JointPositions start = cell.robot.truth().q;
        auto servo = motions.startServoJ({}, Holding::Free);
        QVERIFY(servo.ok());
        QVERIFY(cell.stepMs(20));
        JointPositions target = start;
        target[4] += 10 * kDeg;
        const auto far = servo->send(target);
        QCOMPARE(far.error().code, ErrorCode::LimitExceeded);
        QVERIFY2(far.error().controllerMessage.contains(QStringLiteral("Wrist 2")), why(far));
        QVERIFY(cell.stepMs(100));
        QVERIFY((cell.robot.truth().q.values - start.values).norm() < 1e-3);
        QVERIFY(servo->isActive());
        target = start;
        for (int i = 0; i < 100; ++i) {
            target[4] += 0.1 * kDeg;
            QVERIFY(servo->send(target).ok());
            QVERIFY(cell.step());
        }
        target[4] += 10 * kDeg;
        QCOMPARE(servo->send(target).error().code, ErrorCode::LimitExceeded);
        QVERIFY(cell.stepMs(300));
        QVERIFY(std::abs(cell.robot.truth().q[4] - (start[4] + 10 * kDeg)) < 2e-3);

        auto line = motions.startServoL({}, Holding::Free);
        QVERIFY(line.ok());
        QVERIFY(cell.stepMs(300));
        Pose pose = cell.tcp();
        pose.position.x() += 0.03;
        const auto farPose = line->send(pose);
        QCOMPARE(farPose.error().code, ErrorCode::LimitExceeded);
        QVERIFY2(farPose.error().controllerMessage.contains(QStringLiteral("TCP")), why(farPose));
        pose = cell.tcp();
        pose.rotation = rotationVector(rotationMatrix(pose.rotation) * rotationMatrix({0, 0, 0.1}));
        QCOMPARE(line->send(pose).error().code, ErrorCode::LimitExceeded);
    }

    // The arm was moving when the stream began and has gone on meanwhile: where the program can see that and
    // the PC cannot, the program refuses.
    void theProgramRefusesAJumpToo() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        JointPositions end = cell.robot.truth().q;
        end[5] += 90 * kDeg;
        QVERIFY(motions.moveJ(end, {1.5, 1.4, Holding::Free}).ok());
        QVERIFY(cell.stepMs(900));
        QVERIFY(std::abs(cell.robot.truth().qd[5]) > 1.0);
        auto servo = motions.startServoJ({}, Holding::Free);
        QVERIFY(servo.ok());
        QVERIFY(servo->send(cell.robot.truth().q).ok());
        for (int i = 0; i < 1000 && servo->isActive(); ++i) {
            QVERIFY(cell.step());
        }
        QCOMPARE(servo->motion().state().cause, StopCause::TargetTooFar);
        QCOMPARE(servo->motion().wait(patience()).error().code, ErrorCode::LimitExceeded);
        QVERIFY(cell.standsWithinMs(500));
        QVERIFY(cell.controller->status().inControl);
    }

    void thePacketLoopRefusesAJump() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        const auto jump = [&](const CycleState& state) -> std::optional<JointPositions> {
            JointPositions target = start;
            target[0] += state.cycle < 50 ? 0.0 : 10 * kDeg;
            return target;
        };
        const auto ended =
            cell.during([&] { return PacketLoop(*cell.controller).servoJ(jump, {}, patience()); });
        QCOMPARE(ended.error().code, ErrorCode::LimitExceeded);
        QVERIFY2(ended.error().controllerMessage.contains(QStringLiteral("Base")), why(ended));
        const auto atOnce = [&](const CycleState& state) -> std::optional<Pose> {
            Pose target = state.tcpPose;
            target.position.x() += 0.05;
            return target;
        };
        const auto first =
            cell.during([&] { return PacketLoop(*cell.controller).servoL(atOnce, {}, patience()); });
        QCOMPARE(first.error().code, ErrorCode::LimitExceeded);
        QVERIFY(cell.stepMs(300));
        QVERIFY((cell.robot.truth().q.values - start.values).norm() < 1e-3);
    }

    void speedStreamsMoveUntilTheyAreStopped() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        auto speed = motions.startSpeedL({0.5, 0}, Holding::Free);
        QVERIFY(speed.ok());
        Twist up;
        up.linear.z() = 0.05;
        QVERIFY(speed->send(up).ok());
        QVERIFY(cell.stepMs(500));
        QVERIFY(std::abs(cell.robot.truth().tcpSpeed.linear.z() - 0.05) < 0.005);
        // A softer brake than the usual one takes its time.
        const auto soft = motions.stopL(0.1);
        QVERIFY(soft.ok());
        const int ticks = cell.ticksToStandstill(2000);
        QVERIFY2(ticks * 2 > 400 && ticks * 2 < 620, qPrintable(QString::number(ticks * 2)));
        // The controller says so once the arm has settled.
        QVERIFY(cell.during([&] { return soft->wait(patience()); }).ok());

        auto joints = motions.startSpeedJ({2.0, 0}, Holding::Free);
        QVERIFY(joints.ok());
        JointVelocities qd;
        qd[5] = 0.5;
        QVERIFY(joints->send(qd).ok());
        QVERIFY(cell.stepMs(500));
        QVERIFY(std::abs(cell.robot.truth().qd[5] - 0.5) < 0.02);
        const auto stop = motions.stopJ(10);
        QVERIFY(stop.ok());
        QVERIFY(stop->isActive());
        QVERIFY(cell.during([&] { return stop->wait(patience()); }).ok());
        // The script's word comes at the end of its stopj; the joint's last creep takes a few ticks more.
        QVERIFY(cell.standsWithinMs(20));
    }

    // STOP during a soft stop of a program brakes as hard as ever.
    void theStopKeyOverrulesASoftStop() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        auto speed = motions.startSpeedL({1.0, 0}, Holding::Free);
        Twist up;
        up.linear.z() = 0.1;
        QVERIFY(speed->send(up).ok());
        QVERIFY(cell.stepMs(500));
        QVERIFY(motions.stopL(0.1).ok());
        QVERIFY(cell.stepMs(40));
        QVERIFY(!cell.isStanding());
        cell.controller->stop(StopCause::StopButton);
        QVERIFY(cell.standsWithinMs(100));
    }

    void aHeldStreamWithoutTargetsEnds() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        auto speed = Motions(*cell.controller).startSpeedL();
        Twist up;
        up.linear.z() = 0.05;
        QVERIFY(speed->send(up).ok());
        QVERIFY(cell.stepMs(104));
        QCOMPARE(speed->motion().state().cause, StopCause::EventLoopStalled);
        QVERIFY(cell.ticksToStandstill(500) >= 0);
    }

    void aMoveStraightAfterServoingNeedsNoExtraCall() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        const JointPositions start = cell.robot.truth().q;
        auto servo = motions.startServoJ();
        JointPositions target = start;
        for (int i = 0; i < 150; ++i) {
            target[5] += 0.001;
            QVERIFY(servo->send(target).ok());
            QVERIFY(cell.step());
        }
        const auto move = motions.moveJ(start, {0.5, 1.4, Holding::Free});
        QVERIFY(move.ok());
        QVERIFY(cell.during([&] { return move->wait(patience()); }).ok());
        QVERIFY((cell.robot.truth().q.values - start.values).norm() < 1e-3);
        QCOMPARE(servo->motion().state().cause, StopCause::Superseded);
    }

    void servoCRunsToItsPose() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        auto servo = Motions(*cell.controller).startServoC({0.1, 1.0, 0}, Holding::Free);
        QVERIFY(servo.ok());
        Pose target = cell.tcp();
        target.position.z() += 0.03;
        QVERIFY(servo->send(target).ok());
        // However far the target is: no faster than it was told.
        double fastest = 0;
        cell.everyTick = [&] { fastest = std::max(fastest, cell.robot.truth().tcpSpeed.linear.norm()); };
        QVERIFY(cell.stepMs(1500));
        QVERIFY((cell.tcp().position - target.position).norm() < 2e-3);
        QVERIFY2(fastest < 0.105, qPrintable(QString::number(fastest)));
    }

    void thePacketLoopAnswersEveryPacket() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        CycleReport report;
        const auto circle = [&](const CycleState& state) -> std::optional<JointPositions> {
            if (state.cycle == 500) {
                return std::nullopt;
            }
            JointPositions target = start;
            target[5] += 0.05 * std::sin(6.2831853 * state.time);
            return target;
        };
        const auto ended =
            cell.during([&] { return PacketLoop(*cell.controller).servoJ(circle, {}, patience(), &report); });
        QVERIFY2(ended.ok(), qPrintable(ended.error().toString()));
        QCOMPARE(report.cycles, 501U);
        QCOMPARE(report.missed, 0U);
        QCOMPARE(report.motion.state().cause, StopCause::Completed);
        QCOMPARE(report.calls.count(), 501U);
    }

    void aWrongTargetEndsThePacketLoopAndIsTold() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto wrong = [](const CycleState&) -> std::optional<JointPositions> {
            return JointPositions(90, 0, 0, 0, 0, 0);
        };
        const Error error =
            cell.during([&] { return PacketLoop(*cell.controller).servoJ(wrong, {}, patience()); }).error();
        QCOMPARE(error.code, ErrorCode::InvalidArgument);
        QVERIFY(error.controllerMessage.contains(QStringLiteral("degrees")));
        QVERIFY(cell.ticksToStandstill(200) >= 0);
    }

    // Stop is final: eight threads send targets as fast as they can, and the arm stands all the same.
    void stopIsFinalUnderEightThreadsOfSetpoints() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        std::atomic<bool> over{false};
        std::mutex mutex;
        ToolSpeed stream;
        std::vector<std::thread> hammers;
        for (int i = 0; i < 8; ++i) {
            hammers.emplace_back([&] {
                Twist up;
                up.linear.z() = 0.02;
                while (!over) {
                    ToolSpeed mine;
                    {
                        const std::lock_guard lock(mutex);
                        mine = stream;
                    }
                    mine.send(up).ok();
                    std::this_thread::yield();
                }
            });
        }
        const int rounds = qEnvironmentVariableIntValue("TILLER_STOP_ROUNDS") > 0
                               ? qEnvironmentVariableIntValue("TILLER_STOP_ROUNDS")
                               : 100;
        bool final = true;
        for (int round = 0; round < rounds && final; ++round) {
            {
                auto started = motions.startSpeedL({1.0, 0}, Holding::Free);
                QVERIFY(started.ok());
                const std::lock_guard lock(mutex);
                stream = *started;
            }
            cell.step(4);
            cell.controller->stop(StopCause::StopButton);
            const MotionId stopped = stream.motion().id();
            final = cell.step(3) && cell.controller->motionState(stopped).phase == MotionPhase::Ended;
            const int ticks = cell.ticksToStandstill(200);
            const Pose stands = cell.tcp();
            cell.step(10);  // going on at 20 mm/s would be 0.4 mm
            final = final && ticks >= 0 && (cell.tcp().position - stands.position).norm() < 1e-4;
        }
        over = true;
        for (std::thread& hammer : hammers) {
            hammer.join();
        }
        QVERIFY(final);
    }
};

QTEST_GUILESS_MAIN(TestSetpoints)
#include "tst_setpoints.moc"
