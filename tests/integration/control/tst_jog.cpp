// SPDX-License-Identifier: MIT
// The jog contract over real sockets, in virtual time.
#include "tests/integration/control/cell.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

constexpr double kMm = 0.001;

double mm(const Pose& a, const Pose& b) {
    return (a.position - b.position).norm() / kMm;
}

}  // namespace

class TestJog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void holdingXMovesTheToolAlongX() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const Pose before = cell.tcp();
        const auto jog = cell.motions().startJog(linearJog(0.05, 0, 0));
        QVERIFY(jog.ok());
        QVERIFY(cell.hold(*jog, 1050));
        QVERIFY(cell.controller->status().moving);
        QVERIFY(cell.controller->status().executing);
        QVERIFY(jog->cancel(StopCause::Released));
        QVERIFY(cell.stepMs(200));
        const Pose after = cell.tcp();
        const Eigen::Vector3d way = after.position - before.position;
        QVERIFY2(std::abs(way.x() - 0.05) < 0.003, qPrintable(QString::number(way.x())));
        QVERIFY(std::abs(way.y()) < 0.0002);
        QVERIFY(std::abs(way.z()) < 0.0002);
        QVERIFY((after.rotation - before.rotation).norm() < 0.001);
        QVERIFY(!cell.controller->status().moving);
    }

    // Real arms report frames hundreds of metres away and an upper arm of a few centimetres. Neither may
    // block the arm or make the elbow too fast.
    void calibratedArmMovesAtTheSameSpeed() {
        for (const double size : {0.0, 1.0, 3.0}) {
            Cell cell([size](auto& options) { options.calibration = size; });
            QVERIFY(cell.takeControl().ok());
            const Pose before = cell.tcp();
            const auto jog = cell.motions().startJog(linearJog(0, 0, 0.1));
            QVERIFY(jog.ok());
            QVERIFY(cell.hold(*jog, 600));
            QCOMPARE(cell.controller->status().limiter.kind, LimiterKind::None);
            QVERIFY2(cell.robot.truth().tcpSpeed.linear.norm() > 0.098, qPrintable(QString::number(size)));
            QVERIFY(jog->cancel(StopCause::Released));
            QVERIFY(cell.ticksToStandstill(1000) >= 0);
            const Eigen::Vector3d way = cell.tcp().position - before.position;
            QVERIFY(way.head<2>().norm() < 0.0002);
        }
    }

    void elbowOfACalibratedArmRespectsTheCap() {
        for (const double size : {0.0, 1.0, 3.0}) {
            // The arm is folded, so the elbow is the point with the largest distance from the shoulder axis.
            Cell cell([size](auto& options) {
                options.calibration = size;
                options.startJoints = {0.0, -1.57, 2.7, -1.0, 1.2, 0.0};
            });
            QVERIFY(cell.takeControl().ok());
            QVERIFY(cell.controller->setSpeedCap(0.1).ok());
            const auto joint = cell.motions().startJog(jointJog(1, 1.0));
            QVERIFY2(joint.ok(), joint ? "" : qPrintable(joint.error().toString()));
            QVERIFY(cell.hold(*joint, 400));
            const double upperArm = std::abs(robotModel(RobotModelId::UR5e).dh.a[1]);
            const double elbow = upperArm * std::abs(cell.robot.truth().qd[1]);
            QCOMPARE(cell.controller->status().limiter.kind, LimiterKind::ElbowSpeed);
            QVERIFY2(elbow > 0.097 && elbow < 0.102, qPrintable(QString::number(elbow)));
            QVERIFY(joint->cancel(StopCause::Released));
            QVERIFY(cell.ticksToStandstill(1000) >= 0);
        }
    }

    void motionStartsWithin20MsOfThePress() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.motions().startJog(linearJog(0, 0, 0.1));
        QVERIFY(jog.ok());
        int ticks = 0;
        while (cell.robot.truth().tcpSpeed.linear.norm() < 0.002) {
            QVERIFY(cell.step());
            QVERIFY(++ticks <= 10);
        }
        qInfo("press to motion: %d ms", 2 * ticks);
    }

    void releaseAt100MmPerSecondIsStandstillWithin100Ms() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.motions().startJog(linearJog(0, 0, 0.1));
        QVERIFY(cell.hold(*jog, 600));
        QVERIFY(cell.robot.truth().tcpSpeed.linear.norm() > 0.098);
        const Pose released = cell.tcp();
        QVERIFY(jog->cancel(StopCause::Released));
        const int ticks = cell.ticksToStandstill(1000);
        QVERIFY(ticks >= 0);
        QVERIFY2(ticks * 2 <= 100, qPrintable(QString::number(ticks * 2)));
        const double distance = mm(released, cell.tcp());
        QVERIFY(cell.stepMs(20));
        const StopMeasurement stop = cell.controller->status().lastStop;
        qInfo("release to standstill: true %d ms %.2f mm, measured %.1f ms %.2f mm", 2 * ticks, distance,
              stop.durationMs, stop.distanceMm);
        QCOMPARE(stop.count, 1U);
        QCOMPARE(stop.cause, StopCause::Released);
        QVERIFY(std::abs(stop.durationMs - 2 * ticks) <= 8);
        QVERIFY(std::abs(stop.distanceMm - distance) < 0.3);
    }

    void newCapEndsTheCurrentMotionAndAppliesToLaterOnes() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto speed = [&] { return cell.robot.truth().tcpSpeed.linear.norm(); };
        const auto jog = cell.motions().startJog(linearJog(0, 0, 0.2));
        QVERIFY(cell.hold(*jog, 600));
        QVERIFY(speed() > 0.19);
        QVERIFY(cell.controller->setSpeedCap(0.05).ok());
        QCOMPARE(cell.controller->limits().tcpSpeed, 0.05);
        QVERIFY2(!jog->refresh(), "a stopped jog can be refreshed");
        QCOMPARE(jog->state().cause, StopCause::SelectionChanged);
        QVERIFY(cell.ticksToStandstill(1000) >= 0);

        // The next jog requests a higher speed than the cap and must not exceed the cap.
        const auto next = cell.motions().startJog(linearJog(0, 0, -0.2));
        QVERIFY(next.ok());
        QVERIFY(cell.hold(*next, 400));
        QVERIFY2(std::abs(speed() - 0.05) < 0.003, qPrintable(QString::number(speed())));
        QCOMPARE(cell.controller->status().limiter.kind, LimiterKind::TcpSpeed);
        // Setting the same cap again is not a change.
        QVERIFY(cell.controller->setSpeedCap(0.05).ok());
        QVERIFY(next->refresh());
        // A higher cap must not accelerate the current motion.
        QVERIFY(cell.controller->setSpeedCap(0.25).ok());
        QVERIFY(!next->refresh());
        QVERIFY(cell.ticksToStandstill(1000) >= 0);

        const auto refused = cell.motions().moveL(cell.tcp(), {0.3, 0.5, Holding::Held});
        QCOMPARE(refused.error().code, ErrorCode::LimitExceeded);
        for (const double nonsense : {0.0, -0.1, std::numeric_limits<double>::quiet_NaN()}) {
            QCOMPARE(cell.controller->setSpeedCap(nonsense).error().code, ErrorCode::InvalidArgument);
        }
        QCOMPARE(cell.controller->limits().tcpSpeed, 0.25);
    }

    void missingRefreshEndsTheJogPermanently() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.motions().startJog(linearJog(0, 0, 0.05));
        QVERIFY(cell.hold(*jog, 300));
        const Pose silentSince = cell.tcp();
        QVERIFY(cell.stepMs(100));
        QVERIFY(!cell.isStanding());
        const int ticks = cell.ticksToStandstill(1000);
        QVERIFY(ticks >= 0 && ticks * 2 <= 100);
        QCOMPARE(jog->state().cause, StopCause::EventLoopStalled);
        QVERIFY(mm(silentSince, cell.tcp()) < 0.05 / kMm * 0.2);
        const Pose standing = cell.tcp();
        for (int i = 0; i < 100; ++i) {
            QVERIFY(!jog->refresh());
            QVERIFY(!jog->refresh(linearJog(0, 0, 0.2)));
            QVERIFY(cell.step());
        }
        QVERIFY(mm(standing, cell.tcp()) < 0.01);
        const auto next = cell.motions().startJog(linearJog(0, 0, 0.05));
        QVERIFY(next.ok());
        QVERIFY(cell.hold(*next, 200));
        QVERIFY(mm(standing, cell.tcp()) > 1);
    }

    void robotStopsTheArmOnASilentConnection() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        for (const JogTarget& target : {linearJog(0, 0, 0.25), jointJog(0, 30 * kDeg)}) {
            const auto jog = cell.motions().startJog(target);
            QVERIFY(jog.ok());
            QVERIFY(cell.hold(*jog, 900));
            QVERIFY(!cell.isStanding());
            cell.robot.silence(true);
            int ticks = 0;
            while (!cell.isStanding()) {
                cell.stepAlone();
                jog->refresh();  // the button is still held
                QVERIFY(++ticks < 500);
            }
            qInfo("loss of data to standstill at 250 mm/s or 30 deg/s: %d ms", 2 * ticks);
            QVERIFY(ticks * 2 <= 250);
            QTRY_COMPARE_WITH_TIMEOUT(jog->state().phase, MotionPhase::Ended, 60'000);
            QCOMPARE(jog->state().cause, StopCause::DataStale);
            QCOMPARE(cell.motions().startJog(target).error().code, ErrorCode::LinkLost);
            // After the connection is restored, no motion may resume.
            const Pose standing = cell.tcp();
            cell.robot.silence(false);
            for (int i = 0; i < 100; ++i) {
                cell.stepAlone();
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            QVERIFY(mm(standing, cell.tcp()) < 0.01);
            QVERIFY(!jog->refresh());
            cell.controller->release();
            QVERIFY(cell.takeControl().ok());
        }
    }

    // Neither a closed connection nor an error is reported. Only the data are missing.
    void aSilentConnectionIsClosedWithinHalfASecond_data() {
        QTest::addColumn<QString>("fault");
        QTest::newRow("forgotten by the controller") << QStringLiteral("half-open");
        QTest::newRow("power cut") << QStringLiteral("silence on");
    }
    void aSilentConnectionIsClosedWithinHalfASecond() {
        QFETCH(QString, fault);
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        QVERIFY(cell.stepMs(100));
        QVERIFY(cell.controller->status().fresh);
        QVERIFY(cell.robot.inject(fault).ok());
        cell.stepAlone(55);
        ControllerStatus status = cell.controller->status();
        QVERIFY2(!status.inControl && !status.fresh,
                 "the controller counts as in control although the data are 110 ms old");
        QCOMPARE(status.loss, ControlLoss::DataStale);
        QCOMPARE(cell.motions().startJog(linearJog(0, 0, 0.05)).error().code, ErrorCode::LinkLost);
        cell.stepAlone(185);  // 480 ms in total; the thread may be slow
        QTRY_COMPARE_WITH_TIMEOUT(cell.controller->status().loss, ControlLoss::LinkLost, 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(!cell.controller->isConnected(), 60'000);
        QVERIFY(!cell.controller->status().inControl);
        (void)cell.robot.inject(QStringLiteral("silence off"));
        QVERIFY(cell.takeControl().ok());
        QVERIFY(cell.controller->status().inControl);
    }

    void aShortOutageEndsTheMotionButKeepsControl() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        cell.robot.silence(true);
        cell.stepAlone(150);
        QVERIFY(!cell.controller->status().inControl);
        cell.robot.silence(false);
        QVERIFY(cell.stepMs(100));
        QVERIFY(cell.controller->status().inControl);
        QCOMPARE(cell.controller->status().loss, ControlLoss::None);
    }

    void aProtectiveStopEndsTheJogAndTheControl() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.motions().startJog(linearJog(0, 0, 0.05));
        QVERIFY(cell.hold(*jog, 300));
        cell.robot.protectiveStop();
        QVERIFY(cell.stepMs(300));
        QVERIFY(cell.isStanding());
        QCOMPARE(jog->state().cause, StopCause::UnsafeMode);
        QVERIFY(!cell.controller->status().inControl);
        QCOMPARE(cell.motions().startJog(linearJog(0.05, 0, 0)).error().code, ErrorCode::NotInControl);
        QCOMPARE(cell.takeControl().error().code, ErrorCode::UnsafeState);
    }

    void rotatingBy90DegreesLeavesTheTcpInPlace_data() {
        QTest::addColumn<int>("axis");
        QTest::addColumn<double>("speed");
        QTest::newRow("about base Z") << 2 << 45 * kDeg;
        QTest::newRow("about base X, slowly") << 0 << -30 * kDeg;
        QTest::newRow("about base Y") << 1 << 45 * kDeg;
    }
    void rotatingBy90DegreesLeavesTheTcpInPlace() {
        QFETCH(int, axis);
        QFETCH(double, speed);
        Cell cell([](simulator::SimulatorOptions& options) {
            options.startJoints =
                JointPositions(-90 * kDeg, -80 * kDeg, -120 * kDeg, -20 * kDeg, 60 * kDeg, 0);
        });
        QVERIFY(cell.takeControl().ok());
        const Pose before = cell.tcp();
        JogTarget target;
        target.twist.angular[axis] = speed;
        const auto jog = cell.motions().startJog(target);
        QVERIFY(jog.ok());
        double turned = 0;
        double drift = 0;
        while (turned < 90 * kDeg) {
            if (!cell.hold(*jog, 20)) {
                const auto status = cell.controller->status();
                QFAIL(qPrintable(QStringLiteral("ended by %1, limiter %2 at joint %3 after %4 deg")
                                     .arg(static_cast<int>(jog->state().cause))
                                     .arg(static_cast<int>(status.limiter.kind))
                                     .arg(status.limiter.joint)
                                     .arg(turned / kDeg)));
            }
            const Pose now = cell.tcp();
            drift = std::max(drift, mm(before, now));
            turned =
                Eigen::AngleAxisd(rotationMatrix(now.rotation) * rotationMatrix(before.rotation).transpose())
                    .angle();
        }
        jog->cancel(StopCause::Released);
        QVERIFY(cell.stepMs(400));
        drift = std::max(drift, mm(before, cell.tcp()));
        qInfo("TCP drift over 90 deg: %.4f mm", drift);
        QVERIFY(drift < 0.1);
    }

    void toolDirectionsFollowTheTool() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        for (int round = 0; round < 2; ++round) {
            const Pose before = cell.tcp();
            const auto jog = cell.motions().startJog(linearJog(0, 0, 0.04, JogFrame::Tool));
            QVERIFY(jog.ok());
            QVERIFY(cell.hold(*jog, 500));
            jog->cancel(StopCause::Released);
            QVERIFY(cell.stepMs(200));
            const Eigen::Vector3d went = (cell.tcp().position - before.position).normalized();
            const Eigen::Vector3d toolZ = rotationMatrix(before.rotation).col(2);
            QVERIFY(went.dot(toolZ) > 0.9999);
            // Rotate the tool by about 25 deg, so that the same button moves it in another direction.
            const auto turn = cell.motions().startJog(rotationJog(0.4, 0, 0));
            QVERIFY(turn.ok());
            QVERIFY(cell.hold(*turn, 1200));
            turn->cancel(StopCause::Released);
            QVERIFY(cell.stepMs(300));
            QVERIFY(rotationMatrix(cell.tcp().rotation).col(2).dot(toolZ) < 0.95);
        }
    }

    // Simultaneous translation and rotation in the tool frame is an arc, because the direction rotates with
    // the tool.
    void aToolFrameArcFollowsTheToolContinuously() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        JogTarget target = linearJog(0, 0.05, 0, JogFrame::Tool);
        target.twist.angular = {0, 0, 0.5};
        const auto jog = cell.motions().startJog(target);
        QVERIFY(cell.hold(*jog, 500));
        for (int i = 0; i < 20; ++i) {
            QVERIFY(cell.hold(*jog, 40));
            const auto truth = cell.robot.truth();
            const Eigen::Vector3d toolY = rotationMatrix(truth.tcpPose.rotation).col(1);
            QVERIFY(truth.tcpSpeed.linear.normalized().dot(toolY) > 0.9995);
        }
    }

    void aJointJogStopsBeforeTheLimitAndNamesIt() {
        Cell cell(
            [](simulator::SimulatorOptions& options) { options.startJoints[5] = kJointPositionLimit - 0.5; });
        QVERIFY(cell.takeControl().ok());
        const auto jog = cell.motions().startJog(jointJog(5, 30 * kDeg));
        QVERIFY(jog.ok());
        int ms = 0;
        while (cell.hold(*jog, 20) && ms < 10000) {
            ms += 20;
        }
        QCOMPARE(jog->state().cause, StopCause::LimitReached);
        QVERIFY(cell.stepMs(200));
        QVERIFY(cell.isStanding());
        const double left = kJointPositionLimit - cell.robot.truth().q[5];
        QVERIFY(left > 0 && left < 1.5 * kDeg);
        QCOMPARE(cell.robot.truth().safetyMode, SafetyMode::Normal);
        const Limiter limiter = cell.controller->status().limiter;
        QCOMPARE(limiter.kind, LimiterKind::JointLimit);
        QCOMPARE(limiter.joint, 5);
        const auto back = cell.motions().startJog(jointJog(5, -30 * kDeg));
        QVERIFY(cell.hold(*back, 300));
        QVERIFY(kJointPositionLimit - cell.robot.truth().q[5] > left + 3 * kDeg);
    }

    void theSpeedSliderSlowsTheJogButNotTheStop() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        cell.robot.setSpeedSlider(0.1);
        const auto jog = cell.motions().startJog(linearJog(0, 0, 0.1));
        QVERIFY(cell.hold(*jog, 2000));
        const double speed = cell.robot.truth().tcpSpeed.linear.norm();
        QVERIFY(speed > 0.005 && speed < 0.012);
        jog->cancel(StopCause::Released);
        QVERIFY(cell.standsWithinMs(100));
    }
};

QTEST_GUILESS_MAIN(TestJog)
#include "tst_jog.moc"
