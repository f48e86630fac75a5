// SPDX-License-Identifier: MIT
// Servo and torque commands, which set a target in every control period.
#include <Eigen/Cholesky>
#include <QTest>
#include <cmath>
#include <numbers>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/unit/robot/simulator/arm/arm_fixture.h"

using namespace tiller;
using namespace tiller::simulator::arm;

namespace {
constexpr double kTick = 0.002;
}  // namespace

class TestArmServo : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void servoTracksACircle();
    void servoWithoutUpdateHoldsPosition();
    void servoJumpStaysWithinLimits();
    void servoCReachesItsTarget();
    void directTorqueMovesAndGravityIsCompensated();
    void directTorqueAcceleratesAccordingToTheInertia();
    void aTorqueThatMakesAJointTooFastIsAProtectiveStop();
};

void TestArmServo::servoTracksACircle() {
    WatchedArm arm;
    const Pose start = arm.state().targetTcpPose;
    const DhParameters& dh = arm->model().dh;
    const double radius = 0.1;
    const double omega = 2 * std::numbers::pi * 0.25;
    JointPositions q = arm.state().targetQ;
    double worst = 0;
    for (int n = 0; n < 4000; ++n) {
        const double t = n * kTick;
        Pose goal = start;
        goal.position += radius * Eigen::Vector3d(std::cos(omega * t) - 1, 0, std::sin(omega * t));
        const auto solution = kinematics::inverseNearest(dh, goal, Pose(), q);
        QVERIFY(solution.has_value());
        q = *solution;
        QCOMPARE(arm.finish(arm->motion().servoJ(q, kTick, 0.1, 300)), kTick);
        if (t > 1) {
            worst = std::max(worst, (arm.tcp() - goal.position).norm());
        }
    }
    QVERIFY2(worst < 0.002, qPrintable(QString::number(worst)));
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmServo::servoWithoutUpdateHoldsPosition() {
    WatchedArm arm;
    JointPositions q = arm.state().targetQ;
    q[0] += 0.05;
    for (int n = 0; n < 10; ++n) {
        arm.finish(arm->motion().servoJ(q, kTick));
    }
    arm.run(3);
    QVERIFY((arm.state().targetQ.values - q.values).cwiseAbs().maxCoeff() < 1e-4);
    QVERIFY(arm.state().isStandstill());
    QVERIFY(!arm->motion().isActive());
}

void TestArmServo::servoJumpStaysWithinLimits() {
    for (const double gain : {100.0, 300.0, 2000.0}) {
        for (const double lookahead : {0.03, 0.1, 0.2}) {
            WatchedArm arm;
            JointPositions q = arm.state().targetQ;
            q[4] -= 1.2;
            q[0] += 0.8;
            double overshoot = 0;
            for (int n = 0; n < 2500; ++n) {
                arm->motion().servoJ(q, kTick, lookahead, gain);
                arm.step();
                overshoot = std::max(overshoot, arm.state().targetQ[0] - q[0]);
            }
            QVERIFY((arm.state().targetQ.values - q.values).cwiseAbs().maxCoeff() < 1e-3);
            QVERIFY2(overshoot < 0.05, qPrintable(QString::number(overshoot)));
            QVERIFY2(arm.withinBounds(), arm.worst().c_str());
        }
    }
}

void TestArmServo::servoCReachesItsTarget() {
    WatchedArm arm;
    Pose goal = arm.state().targetTcpPose;
    goal.position += Eigen::Vector3d(0.1, 0, 0.05);
    const double t = arm.finish(arm->motion().servoC(goal, 1.2, 0.25, 0));
    QVERIFY2(t < 1.5, qPrintable(QString::number(t)));
    QVERIFY((arm.tcp() - goal.position).norm() < 2e-4);
    arm.rest();
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmServo::directTorqueMovesAndGravityIsCompensated() {
    WatchedArm arm;
    const JointPositions start = arm.state().targetQ;
    const Vector6 full = Vector6::Ones();
    for (int n = 0; n < 250; ++n) {
        QCOMPARE(arm.finish(arm->motion().directTorque(JointTorques(), full, full)), kTick);
    }
    QVERIFY((arm.state().targetQ.values - start.values).cwiseAbs().maxCoeff() < 1e-9);
    for (int n = 0; n < 250; ++n) {
        arm->motion().directTorque(JointTorques(10, 0, 0, 0, 0, 0), full, full);
        arm.step();
    }
    QVERIFY(arm.state().targetQ[0] > start[0] + 0.1);
    arm.run(0.01);
    arm.rest();
    QVERIFY(arm.state().isStandstill());
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

// Once friction is compensated, the effect of a torque on a joint depends only on the inertia of the arm.
void TestArmServo::directTorqueAcceleratesAccordingToTheInertia() {
    for (int j = 0; j < kJointCount; ++j) {
        WatchedArm arm;
        JointTorques torque;
        torque[j] = j < 3 ? 5.0 : 0.2;
        const Matrix6 mass = arm->massMatrix(arm.state().targetQ, true);
        const Vector6 expected = mass.ldlt().solve(torque.values);
        for (int n = 0; n < 10; ++n) {
            arm->motion().directTorque(torque, Vector6::Ones(), Vector6::Ones());
            arm.step();
        }
        // The inertia can be treated as constant, because the pose has hardly changed.
        const Vector6 reached = arm.state().targetQd.values / (10 * kTick);
        QVERIFY2((reached - expected).norm() < 0.02 * expected.norm(), qPrintable(QString::number(j)));
    }
}

void TestArmServo::aTorqueThatMakesAJointTooFastIsAProtectiveStop() {
    WatchedArm arm;
    for (int n = 0; n < 2000 && !arm->protectiveStop(); ++n) {
        arm->motion().directTorque(JointTorques(30, 0, 0, 0, 0, 0), Vector6::Ones(), Vector6::Ones());
        arm.step();
    }
    QVERIFY(arm->protectiveStop());
    QCOMPARE(arm->protectiveStop()->reason, StopReason::JointSpeedLimit);
    QCOMPARE(arm->protectiveStop()->joint, 0);
    QVERIFY(arm.worstSpeed > 0.95);
    arm.rest();
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

QTEST_GUILESS_MAIN(TestArmServo)
#include "tst_arm_servo.moc"
