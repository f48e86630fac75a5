// SPDX-License-Identifier: MIT
// Servo and speed streams, stops with a specific deceleration, and the packet-locked loop.
#include <cmath>

#include "robot/control/motions.h"
#include "robot/control/packet_loop.h"
#include "tests/integration/control/cell.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

void hasTorque(simulator::SimulatorOptions& options) {
    options.software = {5, 25, 1, 0};
}

/// Returns a torque that rotates the base, slightly above friction [Nm].
JointTorques turning(double torque) {
    return JointTorques(torque, 0, 0, 0, 0, 0);
}

}  // namespace

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

    void aServoHoldsPositionUntilItHasATarget() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        auto servo = Motions(*cell.controller).startServoL({}, Holding::Free);
        QVERIFY(servo.ok());
        QVERIFY(cell.stepMs(300));
        QVERIFY((cell.robot.truth().q.values - start.values).norm() < 1e-3);
    }

    void servoLFollowsPosesAndReportsMissingSolutions() {
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

        // The arm is stretched, so targets a few millimetres farther away are out of reach.
        JointPositions stretched = cell.robot.truth().q;
        stretched[1] = -90 * kDeg;
        stretched[2] = -3 * kDeg;
        const auto move = Motions(*cell.controller).moveJ(stretched, {0.8, 1.4, Holding::Free});
        QVERIFY(move.ok());
        QVERIFY(cell.during([&] { return move->wait(testTimeout()); }).ok());
        servo = Motions(*cell.controller).startServoL({}, Holding::Free);
        QVERIFY(servo.ok());
        target = cell.tcp();
        target.position.z() += 0.009;
        QVERIFY(servo->send(target).ok());
        QVERIFY(cell.stepMs(100));
        QCOMPARE(servo->motion().state().cause, StopCause::Unreachable);
        QCOMPARE(servo->motion().wait(testTimeout()).error().code, ErrorCode::NoSolution);
        QVERIFY(cell.controller->status().inControl);
    }

    // A target too far from the previous target, or a first target too far from the arm, is refused and not
    // sent. The error names the joint or the TCP, and the stream continues.
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

    // The arm was moving when the stream started and has continued to move. The program detects this, but the
    // PC cannot.
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
        QCOMPARE(servo->motion().wait(testTimeout()).error().code, ErrorCode::LimitExceeded);
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
            cell.during([&] { return PacketLoop(*cell.controller).servoJ(jump, {}, testTimeout()); });
        QCOMPARE(ended.error().code, ErrorCode::LimitExceeded);
        QVERIFY2(ended.error().controllerMessage.contains(QStringLiteral("Base")), why(ended));
        const auto atOnce = [&](const CycleState& state) -> std::optional<Pose> {
            Pose target = state.tcpPose;
            target.position.x() += 0.05;
            return target;
        };
        const auto first =
            cell.during([&] { return PacketLoop(*cell.controller).servoL(atOnce, {}, testTimeout()); });
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
        // A softer deceleration takes longer.
        const auto soft = motions.stopL(0.1);
        QVERIFY(soft.ok());
        const int ticks = cell.ticksToStandstill(2000);
        QVERIFY2(ticks * 2 > 400 && ticks * 2 < 620, qPrintable(QString::number(ticks * 2)));
        // The controller confirms the stop after the arm has settled.
        QVERIFY(cell.during([&] { return soft->wait(testTimeout()); }).ok());

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
        QVERIFY(cell.during([&] { return stop->wait(testTimeout()); }).ok());
        // The script confirms the stop at the end of its stopj. The joint comes to rest within 20 ms after
        // that.
        QVERIFY(cell.standsWithinMs(20));
    }

    void stoppingAMotionWaitsForStandstill() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        const Twist up{{0, 0, 0.2}, {0, 0, 0}};
        const auto speed = motions.startSpeedL({0.5, 0}, Holding::Free);
        QVERIFY(speed.ok());
        QVERIFY(ToolSpeed(*speed).send(up).ok());
        QVERIFY(cell.stepMs(400));
        QVERIFY(!cell.isStanding());
        QVERIFY(cell.during([&] { return speed->motion().stop(testTimeout()); }).ok());
        QVERIFY(cell.isStanding());
        QCOMPARE(speed->motion().state().cause, StopCause::ApiCall);
        // A repeated stop, or a stop after other motions, returns immediately.
        QVERIFY(speed->motion().stop(testTimeout()).ok());
        cell.controller->stop();
        QVERIFY(cell.during([&] { return speed->motion().stop(testTimeout()); }).ok());

        // The call does not wait for another motion, which continues.
        const auto jogged = motions.startSpeedL({0.5, 0}, Holding::Free);
        QVERIFY(jogged.ok());
        QVERIFY(speed->motion().stop(testTimeout()).ok());
        QVERIFY(jogged->isActive());
        // The call also waits for a stop that another call has requested.
        QVERIFY(ToolSpeed(*jogged).send(up).ok());
        QVERIFY(cell.stepMs(400));
        cell.controller->stop();
        QCOMPARE(jogged->motion().stop(Deadline::after(std::chrono::milliseconds(0))).error().code,
                 ErrorCode::Timeout);
        QVERIFY(cell.during([&] { return jogged->motion().stop(testTimeout()); }).ok());
        QVERIFY(cell.isStanding());
        QVERIFY(Motion().stop(testTimeout()).ok());
    }

    // Late data alone do not end control. The stop is confirmed when data arrive again.
    void aShortOutageIsNotReportedAsAFailedStop() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto speed = Motions(*cell.controller).startSpeedL({0.5, 0}, Holding::Free);
        QVERIFY(speed.ok());
        QVERIFY(ToolSpeed(*speed).send(Twist{{0, 0, 0.2}, {0, 0, 0}}).ok());
        QVERIFY(cell.stepMs(400));
        cell.robot.silence(true);
        cell.stepAlone(75);
        QVERIFY(!cell.controller->status().inControl);
        QCOMPARE(speed->motion().stop(Deadline::after(std::chrono::milliseconds(0))).error().code,
                 ErrorCode::Timeout);
        cell.robot.silence(false);
        const Result<void> stopped = cell.during([&] { return speed->motion().stop(testTimeout()); });
        QVERIFY2(stopped.ok(), qPrintable(stopped.error().toString()));
        QVERIFY(cell.isStanding());
    }

    // STOP during a soft stop of a program uses full deceleration.
    void theStopKeyOverridesASoftStop() {
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
        QVERIFY(cell.during([&] { return move->wait(testTimeout()); }).ok());
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
        // The speed does not exceed the speed parameter, regardless of the distance.
        double fastest = 0;
        cell.everyTick = [&] { fastest = std::max(fastest, cell.robot.truth().tcpSpeed.linear.norm()); };
        QVERIFY(cell.stepMs(1500));
        QVERIFY((cell.tcp().position - target.position).norm() < 2e-3);
        QVERIFY2(fastest < 0.105, qPrintable(QString::number(fastest)));
    }

    void torquesMoveTheArmAndTheirEndIsDamped() {
        Cell cell(hasTorque);
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        const JointPositions start = cell.robot.truth().q;
        auto stream = motions.startTorque({}, Holding::Free);
        QVERIFY2(stream.ok(), why(stream));
        // Without torques, the arm holds its position.
        QVERIFY(cell.stepMs(300));
        QVERIFY((cell.robot.truth().q.values - start.values).norm() < 1e-3);
        // Zero torques also hold the arm, because the controller compensates gravity.
        for (int i = 0; i < 100; ++i) {
            QVERIFY(stream->send(JointTorques()).ok());
            QVERIFY(cell.step());
        }
        QVERIFY((cell.robot.truth().q.values - start.values).norm() < 1e-3);
        for (int i = 0; i < 500 && cell.robot.truth().qd[0] < 0.2; ++i) {
            QVERIFY(stream->send(turning(8)).ok());
            QVERIFY(cell.step());
        }
        QVERIFY(cell.robot.truth().qd[0] >= 0.2);
        QVERIFY(stream->isActive());

        cell.controller->stop();
        QCOMPARE(stream->send(turning(8)).error().code, ErrorCode::Stopped);
        // Initially the arm decelerates by damping. Position control would decelerate uniformly from the
        // initial speed.
        double last = cell.robot.truth().qd[0];
        for (int i = 0; i < 100 && !cell.isStanding(); ++i) {
            QVERIFY(cell.step());
            const double now = cell.robot.truth().qd[0];
            QVERIFY2(now < last + 0.02, qPrintable(QString::number(now)));
            last = now;
        }
        QVERIFY(cell.isStanding());
        const JointPositions rest = cell.robot.truth().q;
        QVERIFY(cell.stepMs(300));
        QVERIFY((cell.robot.truth().q.values - rest.values).norm() < 1e-3);

        // The next motion starts from the current position.
        const auto back = motions.moveJ(start, {0.5, 1.4, Holding::Free});
        QVERIFY2(back.ok(), why(back));
        QVERIFY(cell.during([&] { return back->wait(testTimeout()); }).ok());
        QVERIFY((cell.robot.truth().q.values - start.values).norm() < 1e-3);
    }

    void heldTorquesEndWithoutRefresh() {
        Cell cell(hasTorque);
        QVERIFY(cell.takeControl().ok());
        auto stream = Motions(*cell.controller).startTorque();
        QVERIFY2(stream.ok(), why(stream));
        for (int i = 0; i < 20; ++i) {
            QVERIFY(stream->send(turning(5)).ok());
            QVERIFY(cell.step());
        }
        QVERIFY(stream->isActive());
        QVERIFY(cell.stepMs(104));
        QCOMPARE(stream->motion().state().cause, StopCause::EventLoopStalled);
        QVERIFY(cell.standsWithinMs(150));
    }

    void torquesEndAboveTheCap() {
        Cell cell(hasTorque);
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        auto stream = motions.startTorque({}, Holding::Free);
        QVERIFY2(stream.ok(), why(stream));
        double fastest = 0;
        cell.everyTick = [&] { fastest = std::max(fastest, cell.robot.truth().tcpSpeed.linear.norm()); };
        for (int i = 0; i < 1000 && stream->isActive(); ++i) {
            (void)stream->send(turning(20));
            QVERIFY(cell.step());
        }
        QCOMPARE(stream->motion().state().cause, StopCause::LimitReached);
        QCOMPARE(cell.controller->status().limiter.kind, LimiterKind::TcpSpeed);
        const auto ended = stream->motion().wait(testTimeout());
        QCOMPARE(ended.error().code, ErrorCode::LimitExceeded);
        QVERIFY2(ended.error().controllerMessage.contains(QStringLiteral("setSpeedCap")), why(ended));
        QVERIFY(cell.standsWithinMs(150));
        QVERIFY2(fastest > 0.24 && fastest < 0.35, qPrintable(QString::number(fastest)));
        QVERIFY(cell.controller->status().inControl);

        // With another speed cap, the stream ends at another speed.
        QVERIFY(cell.controller->setSpeedCap(0.1).ok());
        stream = motions.startTorque({}, Holding::Free);
        QVERIFY2(stream.ok(), why(stream));
        fastest = 0;
        for (int i = 0; i < 1000 && stream->isActive(); ++i) {
            (void)stream->send(turning(-20));
            QVERIFY(cell.step());
        }
        QCOMPARE(stream->motion().state().cause, StopCause::LimitReached);
        QVERIFY(cell.standsWithinMs(150));
        QVERIFY2(fastest < 0.2, qPrintable(QString::number(fastest)));
    }

    void torquesTheJointsCannotGiveAreRefused() {
        Cell cell(hasTorque);
        QVERIFY(cell.takeControl().ok());
        Motions motions(*cell.controller);
        const JointPositions start = cell.robot.truth().q;
        auto stream = motions.startTorque({}, Holding::Free);
        QVERIFY2(stream.ok(), why(stream));
        const auto tooMuch = stream->send(turning(151));
        QCOMPARE(tooMuch.error().code, ErrorCode::LimitExceeded);
        QVERIFY2(tooMuch.error().controllerMessage.contains(QStringLiteral("Base")), why(tooMuch));
        const auto wrist = stream->send(JointTorques(0, 0, 0, 0, 0, -29));
        QCOMPARE(wrist.error().code, ErrorCode::LimitExceeded);
        QVERIFY2(wrist.error().controllerMessage.contains(QStringLiteral("Wrist 3")), why(wrist));
        QCOMPARE(stream->send(JointTorques(0, std::nan(""), 0, 0, 0, 0)).error().code,
                 ErrorCode::InvalidArgument);
        TorqueParameters friction;
        friction.coulombScale[2] = 1.1;
        const auto scaled = stream->send(JointTorques(), friction);
        QCOMPARE(scaled.error().code, ErrorCode::LimitExceeded);
        QVERIFY2(scaled.error().controllerMessage.contains(QStringLiteral("coulombScale")), why(scaled));
        friction.coulombScale[2] = std::nan("");
        QCOMPARE(motions.startTorque(friction).error().code, ErrorCode::InvalidArgument);
        QVERIFY(stream->isActive());
        QVERIFY(cell.stepMs(100));
        QVERIFY((cell.robot.truth().q.values - start.values).norm() < 1e-3);
    }

    // The torque limits are those of the connected arm, independent of the configured model.
    void theTorqueLimitsOfTheConnectedArmApply() {
        Cell cell([](simulator::SimulatorOptions& options) {
            hasTorque(options);
            options.model = RobotModelId::UR3e;
        });
        QVERIFY(cell.takeControl().ok());
        auto stream = Motions(*cell.controller).startTorque({}, Holding::Free);
        QVERIFY2(stream.ok(), why(stream));
        QCOMPARE(stream->send(turning(55)).error().code, ErrorCode::LimitExceeded);
        QVERIFY(stream->send(turning(1)).ok());
    }

    void softwareWithoutTorqueSupportIsReported_data() {
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::addColumn<int>("bugfix");
        QTest::addColumn<QString>("said");
        QTest::newRow("e-Series") << 5 << 25 << 0
                                  << "software 5.25.0: 5.25.1 or newer is required, on PolyScope X 10.12.1";
        QTest::newRow("older e-Series") << 5 << 22 << 1 << "software 5.22.1: 5.25.1 or newer is required";
        QTest::newRow("PolyScope X") << 10 << 12 << 0 << "software 10.12.0: ";
        QTest::newRow("CB3") << 3 << 15 << 8 << "software 3.15.8: not available on this controller series";
    }
    void softwareWithoutTorqueSupportIsReported() {
        QFETCH(int, major);
        QFETCH(int, minor);
        QFETCH(int, bugfix);
        QFETCH(QString, said);
        Cell cell([&](simulator::SimulatorOptions& options) {
            options.software = {static_cast<std::uint32_t>(major), static_cast<std::uint32_t>(minor),
                                static_cast<std::uint32_t>(bugfix), 0};
            options.model = major == 3 ? RobotModelId::UR5 : RobotModelId::UR5e;
        });
        QCOMPARE(cell.motions().startTorque().error().code, ErrorCode::NotInControl);
        const auto taken = cell.takeControl();
        QVERIFY2(taken.ok(), why(taken));
        const auto refused = cell.motions().startTorque();
        QCOMPARE(refused.error().code, ErrorCode::VersionUnsupported);
        QVERIFY2(refused.error().controllerMessage.contains(said), why(refused));
        QCOMPARE(cell.controller->status().motion, kNoMotion);
        QVERIFY(cell.step(5));
        QVERIFY(cell.isStanding());
    }

    void thePacketLoopSendsTorques() {
        Cell cell(hasTorque);
        QVERIFY(cell.takeControl().ok());
        const JointPositions start = cell.robot.truth().q;
        // Keeps a constant speed. The arm continues for about 0.08 rad.
        const auto steady = [&](const CycleState& state) -> std::optional<JointTorques> {
            constexpr double kGain = 40;  // [Nm s/rad]
            return state.time < 0.5 ? std::optional(turning(kGain * (0.2 - state.qd[0]))) : std::nullopt;
        };
        CycleReport report;
        const auto ended = cell.during(
            [&] { return PacketLoop(*cell.controller).torque(steady, {}, testTimeout(), &report); });
        QVERIFY2(ended.ok(), why(ended));
        QCOMPARE(report.motion.kind(), MotionKind::Torque);
        QVERIFY(cell.standsWithinMs(200));
        const double turned = cell.robot.truth().q[0] - start[0];
        QVERIFY2(turned > 0.04 && turned < 0.12, qPrintable(QString::number(turned)));
        const auto jump = [](const CycleState&) { return std::optional(turning(200)); };
        QCOMPARE(cell.during([&] { return PacketLoop(*cell.controller).torque(jump, {}, testTimeout()); })
                     .error()
                     .code,
                 ErrorCode::LimitExceeded);
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
        // Each packet must be answered before the next packet, because a delayed packet would count as
        // missed.
        Result<void> ended;
        std::atomic<bool> over{false};
        std::thread caller([&] {
            ended = PacketLoop(*cell.controller).servoJ(circle, {}, testTimeout(), &report);
            over = true;
        });
        while (!over && cell.step()) {
        }
        caller.join();
        QVERIFY2(ended.ok(), qPrintable(ended.error().toString()));
        QCOMPARE(report.cycles, 501U);
        QCOMPARE(report.missed, 0U);
        QCOMPARE(report.motion.state().cause, StopCause::Completed);
        QCOMPARE(report.calls.count(), 501U);
    }

    void invalidTargetEndsThePacketLoopAndIsReported() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto wrong = [](const CycleState&) -> std::optional<JointPositions> {
            return JointPositions(90, 0, 0, 0, 0, 0);
        };
        const Error error =
            cell.during([&] { return PacketLoop(*cell.controller).servoJ(wrong, {}, testTimeout()); })
                .error();
        QCOMPARE(error.code, ErrorCode::InvalidArgument);
        QVERIFY(error.controllerMessage.contains(QStringLiteral("degrees")));
        QVERIFY(cell.ticksToStandstill(200) >= 0);
    }

    // A stop is final. Eight threads send targets as fast as they can, and the arm still stops.
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
            cell.step(10);  // the arm would move 0.4 mm if it continued at 20 mm/s
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
