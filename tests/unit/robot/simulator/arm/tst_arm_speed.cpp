// SPDX-License-Identifier: MIT
// Speed commands, stops, and a series of random commands.
#include <QTest>
#include <cmath>
#include <random>

#include "tests/unit/robot/simulator/arm/arm_fixture.h"

using namespace tiller;
using namespace tiller::simulator::arm;

namespace {
constexpr double kTick = 0.002;

Twist twist(double x, double y, double z, double rx = 0, double ry = 0, double rz = 0) {
    return {{x, y, z}, {rx, ry, rz}};
}
}  // namespace

class TestArmSpeed : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void speedJAcceleratesAtTheLeadingAxis();
    void speedJWithoutTimeReturnsAtSpeed();
    void speedCommandsReturnAfterAtLeastOnePeriod();
    void repeatedSpeedIsMaintained();
    void speedThatIsNotRepeatedEnds();
    void slowSliderStretchesTheBlockingTime();
    void speedLMovesStraight();
    void rotationAboutTheTcpDoesNotDrift();
    void stopDistanceIsSpeedSquaredOverTwiceTheDeceleration();
    void stopIsNotSlowedByTheSlider();
    void stopLKeepsTheDirection();
    void stopEndsAMove();
    void jointRangeEndsAJog();
    void jogIntoASingularitySlowsAndStops();
    void jogOutOfASingularityIsNotLimited();
    void randomCommandsStayWithinTheLimits();
};

void TestArmSpeed::speedJAcceleratesAtTheLeadingAxis() {
    WatchedArm arm;
    const MotionStart speed = arm->motion().speedJ(JointVelocities(0.4, -0.2, 0, 0, 0.1, 0), 2.0, 0.5);
    arm.run(0.1);
    QVERIFY(std::abs(arm.state().targetQd[0] - 0.2) < 1e-9);
    QVERIFY(std::abs(arm.state().targetQd[1] + 0.1) < 1e-9);
    QVERIFY(std::abs(arm.state().targetQdd[0] - 2.0) < 1e-6);
    const double t = 0.1 + arm.finish(speed);
    QVERIFY2(std::abs(t - 0.5) <= kTick, qPrintable(QString::number(t)));
    QVERIFY(std::abs(arm.state().targetQd[0] - 0.4) < 1e-9);
}

void TestArmSpeed::speedJWithoutTimeReturnsAtSpeed() {
    WatchedArm arm;
    const double t = arm.finish(arm->motion().speedJ(JointVelocities(0.4, 0, 0, 0, 0, 0), 2.0));
    QVERIFY2(std::abs(t - 0.2) <= kTick, qPrintable(QString::number(t)));
    const double again = arm.finish(arm->motion().speedJ(JointVelocities(0.4, 0, 0, 0, 0, 0), 2.0));
    QCOMPARE(again, kTick);
}

void TestArmSpeed::speedCommandsReturnAfterAtLeastOnePeriod() {
    WatchedArm arm;
    for (const double t : {0.0, 1e-15, 0.001, 0.002}) {
        QCOMPARE(arm.finish(arm->motion().speedJ(JointVelocities(0.1, 0, 0, 0, 0, 0), 40, t)), kTick);
        QCOMPARE(arm.finish(arm->motion().speedL(twist(0.01, 0, 0), 1, t)), kTick);
    }
    // A constant speed needs no acceleration.
    QVERIFY(arm->motion().speedJ(arm.state().targetQd, 0.0, kTick).ok());
}

void TestArmSpeed::repeatedSpeedIsMaintained() {
    WatchedArm arm;
    arm.finish(arm->motion().speedJ(JointVelocities(0.3, 0, 0, 0, 0, 0), 40.0));
    for (int n = 0; n < 200; ++n) {
        // Timing as in scripts: one frame in the command, one in sync().
        arm.finish(arm->motion().speedJ(JointVelocities(0.3, 0, 0, 0, 0, 0), 40.0, kTick));
        arm.step();
        QVERIFY(std::abs(arm.state().targetQd[0] - 0.3) < 1e-9);
    }
}

void TestArmSpeed::speedThatIsNotRepeatedEnds() {
    WatchedArm arm;
    arm.finish(arm->motion().speedL(twist(0.1, 0, 0), 0.5, 1.0));
    QVERIFY(std::abs(arm.state().targetTcpSpeed.linear.x() - 0.1) < 1e-6);
    const double t = arm.rest();
    QVERIFY2(t < 0.1 / 0.5 + 0.03, qPrintable(QString::number(t)));
    arm.run(0.1);
    QVERIFY(!arm->motion().isActive());
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmSpeed::slowSliderStretchesTheBlockingTime() {
    WatchedArm arm;
    arm->setSpeedFraction(0.25);
    arm.run(0.01);
    const double t = arm.finish(arm->motion().speedJ(JointVelocities(0.1, 0, 0, 0, 0, 0), 40, kTick));
    QCOMPARE(t, 4 * kTick);
    for (int n = 0; n < 20; ++n) {
        arm.finish(arm->motion().speedJ(JointVelocities(0.1, 0, 0, 0, 0, 0), 40, kTick));
    }
    QVERIFY(std::abs(arm.state().targetQd[0] - 0.025) < 1e-9);
}

void TestArmSpeed::speedLMovesStraight() {
    WatchedArm arm;
    const Pose start = arm.state().targetTcpPose;
    arm->motion().speedL(twist(0.05, 0.02, 0.04), 0.5, 3.0);
    arm.run(3.0);
    const Eigen::Vector3d way = Eigen::Vector3d(0.05, 0.02, 0.04).normalized();
    const Eigen::Vector3d moved = arm.tcp() - start.position;
    QVERIFY((moved - way * moved.dot(way)).norm() < 1e-8);
    const double v = Eigen::Vector3d(0.05, 0.02, 0.04).norm();
    QVERIFY(std::abs(moved.norm() - (v * 3.0 - v * v / (2 * 0.5))) < v * kTick);
    QVERIFY((arm.state().targetTcpPose.rotation - start.rotation).norm() < 1e-7);
}

void TestArmSpeed::rotationAboutTheTcpDoesNotDrift() {
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0.3, 0.2, 1).normalized()}) {
        WatchedArm arm;
        arm->setTcp(Pose(0.03, -0.02, 0.12, 0.2, 0, 0));
        arm->step();
        const Pose start = arm.state().targetTcpPose;
        double drift = 0;
        double turned = 0;
        const Eigen::Vector3d w = axis * (30 * kDegree);
        while (turned < 90 * kDegree) {
            arm->motion().speedL(twist(0, 0, 0, w.x(), w.y(), w.z()), 0.5, kTick, 2.0);
            arm.step();
            drift = std::max(drift, (arm.tcp() - start.position).norm());
            turned = rotationVector(rotationMatrix(arm.state().targetTcpPose.rotation) *
                                    rotationMatrix(start.rotation).transpose())
                         .norm();
            QVERIFY(!arm->protectiveStop());
            QVERIFY(arm.steps < 5000);
        }
        QVERIFY2(drift < 1e-5, qPrintable(QString::number(drift)));
        arm.finish(arm->motion().stopL(2.0, 4.0));
        QVERIFY((arm.tcp() - start.position).norm() < 1e-5);
    }
}

void TestArmSpeed::stopDistanceIsSpeedSquaredOverTwiceTheDeceleration() {
    for (const double a : {0.5, 2.0, 10.0, 40.0}) {
        WatchedArm arm;
        const double v = 0.8;
        arm.finish(arm->motion().speedJ(JointVelocities(v, 0.2, 0, 0, 0, 0), 4.0, 0.5));
        const double from = arm.state().targetQ[0];
        const double t = arm.finish(arm->motion().stopJ(a));
        QVERIFY2(std::abs(t - v / a) <= kTick, qPrintable(QString::number(t)));
        QVERIFY(std::abs(arm.state().targetQ[0] - from - v * v / (2 * a)) < v * kTick);
        QVERIFY(arm.state().targetQd.values.isZero(0));
    }
    for (const double a : {0.5, 2.0, 10.0}) {
        WatchedArm arm;
        const double v = 0.25;
        arm.finish(arm->motion().speedL(twist(0, 0, v), 1.2, 0.5));
        const Eigen::Vector3d from = arm.tcp();
        const double t = arm.finish(arm->motion().stopL(a));
        QVERIFY2(std::abs(t - v / a) <= kTick, qPrintable(QString::number(t)));
        QVERIFY(std::abs((arm.tcp() - from).norm() - v * v / (2 * a)) < v * kTick);
    }
}

void TestArmSpeed::stopIsNotSlowedByTheSlider() {
    WatchedArm arm;
    arm->setSpeedFraction(0.1);
    for (int n = 0; n < 500; ++n) {
        arm->motion().speedJ(JointVelocities(1.0, 0, 0, 0, 0, 0), 20, kTick);
        arm.step();
    }
    QVERIFY(std::abs(arm.state().targetQd[0] - 0.1) < 1e-6);
    const double t = arm.finish(arm->motion().stopJ(2.0));
    QVERIFY2(std::abs(t - 0.05) <= kTick, qPrintable(QString::number(t)));
}

void TestArmSpeed::stopLKeepsTheDirection() {
    WatchedArm arm;
    arm.finish(arm->motion().speedL(twist(0.2, 0, 0.1), 1.2, 0.6));
    const Pose from = arm.state().targetTcpPose;
    arm.finish(arm->motion().stopL(1.0));
    const Eigen::Vector3d way = Eigen::Vector3d(2, 0, 1).normalized();
    const Eigen::Vector3d moved = arm.tcp() - from.position;
    QVERIFY(moved.norm() > 0.02);
    QVERIFY((moved - way * moved.dot(way)).norm() < 1e-6);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmSpeed::stopEndsAMove() {
    WatchedArm arm;
    const MotionStart move = arm->motion().moveJ(JointPositions(0, -1.2, -1.5, -1, 1.5, 0), {.a = 2, .v = 1});
    arm.run(0.8);
    const MotionStart stop = arm->motion().stopJ(4.0);
    QCOMPARE(arm->motion().progress(move.id), MotionProgress::Superseded);
    const double t = arm.finish(stop);
    QVERIFY2(std::abs(t - 0.25) <= kTick, qPrintable(QString::number(t)));
    QCOMPARE(arm->motion().progress(stop.id), MotionProgress::Returned);
}

void TestArmSpeed::jointRangeEndsAJog() {
    WatchedArm arm(true, RobotModelId::UR5e, JointPositions(0, -1.5, -1.5, -1, 1.5, 5.5));
    arm->motion().speedJ(JointVelocities(0, 0, 0, 0, 0, 2.0), 10, 10.0);
    arm.run(3);
    QVERIFY(arm->protectiveStop());
    QCOMPARE(arm->protectiveStop()->reason, StopReason::JointPositionLimit);
    QCOMPARE(arm->protectiveStop()->joint, 5);
    QVERIFY(arm.worstPosition > kJointPositionLimit - 0.01);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
    arm->clearProtectiveStop();
    // The opposite direction is not limited.
    arm->motion().speedJ(JointVelocities(0, 0, 0, 0, 0, -1.0), 10, 1.0);
    arm.run(1);
    QVERIFY(!arm->protectiveStop());
    QVERIFY(arm.state().targetQ[5] < kJointPositionLimit - 0.5);
}

void TestArmSpeed::jogIntoASingularitySlowsAndStops() {
    // Moves outwards until the arm is fully extended.
    WatchedArm arm;
    for (int n = 0; n < 20000 && !arm->protectiveStop(); ++n) {
        arm->motion().speedL(twist(0, -0.1, 0), 0.5, kTick);
        arm.step();
    }
    QVERIFY(arm->protectiveStop());
    QCOMPARE(arm->protectiveStop()->reason, StopReason::Singularity);
    arm.rest();
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
    QVERIFY2(arm.worstAcceleration < 20, arm.worst().c_str());
    arm->clearProtectiveStop();
    const Eigen::Vector3d there = arm.tcp();
    for (int n = 0; n < 500; ++n) {
        arm->motion().speedL(twist(0, 0.1, 0), 0.5, kTick);
        arm.step();
    }
    QVERIFY2(!arm->protectiveStop(), "the arm cannot be jogged back");
    QVERIFY(arm.tcp().y() > there.y() + 0.05);
}

void TestArmSpeed::jogOutOfASingularityIsNotLimited() {
    // Wrist 2 is close to zero. Moving it away from zero must not be slowed down.
    WatchedArm arm(true, RobotModelId::UR5e, JointPositions(0, -1.5, -1.5, -1, 0.08, 0));
    for (int n = 0; n < 500; ++n) {
        arm->motion().speedJ(JointVelocities(0, 0, 0, 0, 0.3, 0), 1, kTick);
        arm.step();
    }
    QVERIFY(!arm->protectiveStop());
    QVERIFY(arm.state().targetQ[4] > 0.2);
}

void TestArmSpeed::randomCommandsStayWithinTheLimits() {
    std::mt19937 random(20260401);
    const auto number = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    int stops = 0;
    int moves = 0;
    for (int round = 0; round < 12; ++round) {
        WatchedArm arm(true, round % 3 == 2 ? RobotModelId::UR10e : RobotModelId::UR5e);
        for (int n = 0; n < 150; ++n) {
            if (arm->protectiveStop()) {
                ++stops;
                arm.rest(5);
                arm->clearProtectiveStop();
                if (stops % 4 == 0) {
                    arm.finish(
                        arm->motion().moveJ(JointPositions(-1.6, -1.7, -2.2, -0.8, 1.6, 0), {.a = 3, .v = 2}),
                        10);
                }
            }
            Motion& motion = arm->motion();
            JointPositions q = arm.state().targetQ;
            JointVelocities qd;
            for (int j = 0; j < kJointCount; ++j) {
                q[j] = std::clamp(q[j] + number(-1.5, 1.5), -6.3, 6.3);
                qd[j] = number(-3, 3);
            }
            Pose pose = arm.state().targetTcpPose;
            pose.position += Eigen::Vector3d(number(-0.3, 0.3), number(-0.3, 0.3), number(-0.3, 0.3));
            pose.rotation += Eigen::Vector3d(number(-0.5, 0.5), number(-0.5, 0.5), number(-0.5, 0.5));
            Pose via = pose;
            via.position += Eigen::Vector3d(number(-0.1, 0.1), number(-0.1, 0.1), number(-0.1, 0.1));
            const double r = number(0, 1) < 0.5 ? 0.0 : number(0.001, 0.2);
            const double a = std::pow(10.0, number(-0.5, 1.6));
            MotionStart start;
            switch (random() % 19) {
                case 0:
                case 1:
                    start = motion.moveJ(q, {.a = a, .v = number(0.1, 4), .r = r});
                    break;
                case 2:
                    start = motion.moveJ(pose, {.a = a, .v = number(0.1, 4), .r = r});
                    break;
                case 3:
                case 4:
                    start = motion.moveL(pose, {.a = a, .v = number(0.01, 2), .r = r});
                    break;
                case 5:
                    start = motion.moveP(pose, {.a = a, .v = number(0.01, 1), .r = r});
                    break;
                case 6:
                    start = motion.moveC(
                        via, pose, {.a = a, .v = number(0.01, 1), .r = r},
                        random() % 2 == 0 ? ArcOrientation::Interpolated : ArcOrientation::FixedToArc);
                    break;
                case 7:
                    start = motion.speedJ(qd, a, number(0, 0.5));
                    break;
                case 8:
                    start = motion.speedL(twist(number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1),
                                                number(-1, 1), number(-1, 1)),
                                          a, number(0, 0.5));
                    break;
                case 9:
                    start = motion.servoJ(q, number(0, 0.1), number(0.03, 0.2), number(100, 2000));
                    break;
                case 10:
                    start = motion.stopJ(a);
                    break;
                case 11:
                    start = motion.stopL(a);
                    break;
                case 12:
                    start = motion.servoC(pose, a, number(0.01, 1), 0);
                    break;
                case 13: {
                    ForceModeParameters force;
                    for (bool& axis : force.compliant) {
                        axis = random() % 2 == 0;
                    }
                    force.wrench.force = {number(-30, 30), number(-30, 30), number(-30, 30)};
                    force.type = 1 + static_cast<int>(random() % 3);
                    force.limits.setConstant(number(0.01, 1));
                    arm->compliance().startForceMode(force);
                    break;
                }
                case 14:
                    arm->compliance().endForceMode();
                    break;
                case 15:
                    arm->environment().setHandWrench({{number(-50, 50), number(-50, 50), number(-50, 50)},
                                                      {number(-5, 5), number(-5, 5), number(-5, 5)}});
                    arm->compliance().startFreedrive();
                    arm.run(number(0, 0.3));
                    arm->compliance().endFreedrive();
                    arm->environment().setHandWrench({});
                    break;
                case 16:
                    start =
                        motion.directTorque(JointTorques(number(-50, 50), number(-50, 50), number(-30, 30),
                                                         number(-5, 5), number(-5, 5), number(-5, 5)),
                                            Vector6::Ones(), Vector6::Ones());
                    break;
                case 17:
                    // Changes the TCP, even during a motion.
                    arm->setTcp(Pose(number(-0.1, 0.1), number(-0.1, 0.1), number(0, 0.2), 0.1, 0.2, 0));
                    break;
                default:
                    arm->hold();
                    arm.run(number(0, 0.2));
                    arm->resume();
                    arm->setSpeedFraction(number(0, 1) < 0.5 ? 1.0 : number(0.02, 1));
                    break;
            }
            moves += start.id != 0 ? 1 : 0;
            // Some moves are completed, some are interrupted, and some are blended.
            if (random() % 2 == 0) {
                arm.finish(start, 4);
            } else {
                arm.run(number(0, 0.4));
            }
            if (random() % 10 == 0) {
                motion.abandon();
            }
            QVERIFY2(arm.withinBounds(),
                     qPrintable(QString("round %1, command %2: ").arg(round).arg(n) + arm.worst().c_str()));
        }
    }
    // The commands must have moved the arm, not just been refused.
    QVERIFY2(moves > 900, qPrintable(QString::number(moves)));
    qInfo("%d motions, %d protective stops", moves, stops);
}

QTEST_GUILESS_MAIN(TestArmSpeed)
#include "tst_arm_speed.moc"
