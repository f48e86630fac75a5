// SPDX-License-Identifier: MIT
// Force mode, freedrive and contact.
#include <QTest>
#include <cmath>

#include "tests/unit/robot/simulator/arm/arm_fixture.h"

using namespace tiller;
using namespace tiller::simulator::arm;

namespace {

ForceModeParameters pushDown(double force, double limit = 0.1) {
    ForceModeParameters p;
    p.compliant = {false, false, true, false, false, false};
    p.wrench.force.z() = force;
    p.limits << 0.05, 0.05, limit, 0.1, 0.1, 0.1;
    return p;
}
}  // namespace

class TestArmCompliance : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void forceModeHoldsTenNewtonOnASurface_data();
    void forceModeHoldsTenNewtonOnASurface();
    void forceModeInFreeSpaceReturnsToTheStart();
    void forceModeKeepsItsSpeedLimit();
    void programMovesTheOtherAxes();
    void movingSidewaysKeepsTheForce();
    void endOfForceModeBrakes();
    void noisyForceModeStillHolds();
    void badForceModeIsRefused();
    void handMovesTheArmInFreedrive();
    void theArmStaysInFreedriveWithoutForce();
    void freedriveKeepsTheLockedAxes();
    void freedriveIgnoresMoves();
    void wrongPayloadDriftsInFreedrive();
    void freedriveStatusReportsSingularities();
    void hardContactIsAProtectiveStop();
    void abortEndsForceModeAndFreedrive();
};

void TestArmCompliance::forceModeHoldsTenNewtonOnASurface_data() {
    QTest::addColumn<double>("damping");
    QTest::addColumn<double>("gain");
    QTest::addColumn<double>("stiffness");
    QTest::newRow("clients' setting") << 0.025 << 0.5 << 20000.0;
    QTest::newRow("default") << 0.005 << 1.0 << 20000.0;
    QTest::newRow("soft surface") << 0.005 << 1.0 << 2000.0;
    QTest::newRow("strong damping") << 1.0 << 1.0 << 20000.0;
}

void TestArmCompliance::forceModeHoldsTenNewtonOnASurface() {
    QFETCH(double, damping);
    QFETCH(double, gain);
    QFETCH(double, stiffness);
    WatchedArm arm(false);
    arm.run(0.1);
    arm->zeroForceSensor();
    const double z = arm.state().targetTcpPose.position.z();
    arm->environment().addPlane({.point = {0, 0, z - 0.01}, .material = {.stiffness = stiffness}});
    arm->compliance().setDamping(damping);
    arm->compliance().setGainScaling(gain);
    QCOMPARE(arm->compliance().startForceMode(pushDown(-10)), MotionError::None);
    arm.run(6);
    double lowest = 100;
    double highest = 0;
    double mean = 0;
    for (int n = 0; n < 1000; ++n) {
        arm.step();
        const double force = arm.state().tcpForce.force.z();
        lowest = std::min(lowest, force);
        highest = std::max(highest, force);
        mean += force / 1000;
    }
    QVERIFY(!arm->protectiveStop());
    QVERIFY2(lowest > 9 && highest < 11, qPrintable(QString("%1 .. %2").arg(lowest).arg(highest)));
    QVERIFY(std::abs(mean - 10) < 0.2);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmCompliance::forceModeInFreeSpaceReturnsToTheStart() {
    // Published experiment: a streamed motion, 2 s down and 2 s up, that ends near its start position.
    WatchedArm arm(false, RobotModelId::UR5e, JointPositions(-1.54, -1.83, -2.28, -0.59, 1.60, 0.023));
    arm.run(0.1);
    arm->zeroForceSensor();
    arm->compliance().setDamping(0.025);
    arm->compliance().setGainScaling(0.5);
    const Pose start = arm.state().targetTcpPose;
    double deepest = 0;
    for (int n = 0; n < 2000; ++n) {
        ForceModeParameters p = pushDown(n < 1000 ? -10 : 10);
        p.limits << 2, 2, 1.5, 1, 1, 1;
        arm->compliance().startForceMode(p);
        arm.step();
        deepest = std::max(deepest, start.position.z() - arm.tcp().z());
    }
    arm->compliance().endForceMode();
    arm.finish(arm->motion().stopL(10));
    arm.rest();
    QVERIFY2(deepest > 0.01 && deepest < 0.14, qPrintable(QString::number(deepest)));
    QVERIFY2((arm.tcp() - start.position).norm() < 0.02,
             qPrintable(QString::number((arm.tcp() - start.position).norm())));
    QVERIFY((arm.state().targetTcpPose.rotation - start.rotation).norm() < 1e-3);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmCompliance::forceModeKeepsItsSpeedLimit() {
    WatchedArm arm;
    arm->compliance().startForceMode(pushDown(40, 0.03));
    double fastest = 0;
    for (int n = 0; n < 1000; ++n) {
        arm.step();
        fastest = std::max(fastest, arm.state().targetTcpSpeed.linear.norm());
    }
    QVERIFY2(std::abs(fastest - 0.03) < 1e-4, qPrintable(QString::number(fastest)));
}

void TestArmCompliance::programMovesTheOtherAxes() {
    WatchedArm arm;
    const Pose start = arm.state().targetTcpPose;
    arm->compliance().startForceMode(pushDown(0));
    Pose goal = start;
    goal.position += Eigen::Vector3d(0.1, 0, 0.05);
    arm.finish(arm->motion().moveL(goal, {.a = 1.2, .v = 0.1}));
    arm.run(1);
    const Eigen::Vector3d off = arm.tcp() - start.position - Eigen::Vector3d(0.1, 0, 0);
    QVERIFY2(off.norm() < 1e-4, qPrintable(QString("%1 %2 %3").arg(off.x()).arg(off.y()).arg(off.z())));
    arm->compliance().endForceMode();
    arm.run(0.1);
    // From this point on, the program controls the height again.
    arm.finish(arm->motion().moveL(goal, {.a = 1.2, .v = 0.1}));
    QVERIFY((arm.tcp() - goal.position).norm() < 1e-8);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmCompliance::movingSidewaysKeepsTheForce() {
    WatchedArm arm;
    const Pose start = arm.state().targetTcpPose;
    // The surface descends by 1 mm in 100 mm.
    arm->environment().addPlane({.point = start.position - Eigen::Vector3d(0, 0, 0.005),
                                 .normal = {0.01, 0, 1},
                                 .material = {.friction = 0}});
    arm->compliance().startForceMode(pushDown(-10));
    arm.run(3);
    QVERIFY(std::abs(arm.state().tcpForce.force.z() - 10) < 1);
    Pose goal = start;
    goal.position.x() += 0.1;
    const MotionStart move = arm->motion().moveL(goal, {.a = 0.5, .v = 0.05});
    double worst = 0;
    while (arm->motion().progress(move.id) == MotionProgress::Running) {
        arm.step();
        worst = std::max(worst, std::abs(arm.state().tcpForce.force.z() - 10));
    }
    QVERIFY2(worst < 2, qPrintable(QString::number(worst)));
    QVERIFY(std::abs(arm.tcp().x() - goal.position.x()) < 1e-4);
}

void TestArmCompliance::endOfForceModeBrakes() {
    WatchedArm arm;
    arm->compliance().startForceMode(pushDown(20, 0.1));
    arm.run(1);
    QVERIFY(arm.state().targetTcpSpeed.linear.norm() > 0.05);
    arm->compliance().endForceMode();
    const double t = arm.rest();
    QVERIFY2(t < 0.2, qPrintable(QString::number(t)));
    arm->compliance().endForceMode();
    QVERIFY(!arm->compliance().isForceMode());
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmCompliance::noisyForceModeStillHolds() {
    WatchedArm arm(false);
    const double z = arm.state().targetTcpPose.position.z();
    arm->compliance().startForceMode(pushDown(0));
    arm.run(5);
    // Sensor noise alone does not make the arm drift.
    QVERIFY2(std::abs(arm.tcp().z() - z) < 0.01, qPrintable(QString::number(arm.tcp().z() - z)));
}

void TestArmCompliance::badForceModeIsRefused() {
    WatchedArm arm;
    ForceModeParameters p = pushDown(1);
    p.type = 4;
    QCOMPARE(arm->compliance().startForceMode(p), MotionError::InvalidArgument);
    p = pushDown(std::nan(""));
    QCOMPARE(arm->compliance().startForceMode(p), MotionError::InvalidArgument);
    p = pushDown(1, -1);
    QCOMPARE(arm->compliance().startForceMode(p), MotionError::InvalidArgument);
    QVERIFY(!arm->compliance().isForceMode());
}

void TestArmCompliance::handMovesTheArmInFreedrive() {
    WatchedArm arm(false);
    arm.run(0.1);
    const Eigen::Vector3d start = arm.tcp();
    QCOMPARE(arm->compliance().startFreedrive(), MotionError::None);
    QCOMPARE(arm->compliance().startFreedrive(), MotionError::None);
    arm->environment().setHandWrench({{20, 0, 0}, {0, 0, 0}});
    arm.run(1);
    QVERIFY2(arm.tcp().x() - start.x() > 0.05, qPrintable(QString::number(arm.tcp().x() - start.x())));
    arm->environment().setHandWrench({});
    arm->compliance().endFreedrive();
    arm.rest();
    const JointPositions there = arm.state().targetQ;
    arm.run(0.5);
    QCOMPARE(arm.state().targetQ, there);
    QVERIFY(arm->motion().moveJ(JointPositions(-1.6, -1.7, -2.2, -0.8, 1.6, 0), {}).ok());
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmCompliance::theArmStaysInFreedriveWithoutForce() {
    WatchedArm arm(false);
    const JointPositions q = arm.state().targetQ;
    arm->compliance().startFreedrive();
    arm.run(3);
    QCOMPARE(arm.state().targetQ, q);
    QVERIFY(arm.state().isStandstill());
}

void TestArmCompliance::freedriveKeepsTheLockedAxes() {
    WatchedArm arm;
    const Pose start = arm.state().targetTcpPose;
    FreedriveParameters p;
    p.freeAxes = {true, false, false, false, false, false};
    arm->compliance().startFreedrive(p);
    arm->environment().setHandWrench({{15, 15, 15}, {1, 1, 1}});
    arm.run(0.5);
    const Eigen::Vector3d moved = arm.tcp() - start.position;
    QVERIFY(moved.x() > 0.02);
    QVERIFY2(std::abs(moved.y()) < 1e-6 && std::abs(moved.z()) < 1e-6,
             qPrintable(QString("%1 %2").arg(moved.y()).arg(moved.z())));
    QVERIFY((arm.state().targetTcpPose.rotation - start.rotation).norm() < 1e-6);
}

void TestArmCompliance::freedriveIgnoresMoves() {
    WatchedArm arm;
    const JointPositions q = arm.state().targetQ;
    arm->compliance().startFreedrive();
    const MotionStart move = arm->motion().moveJ(JointPositions(0, -1, -1, -1, 1, 0), {});
    QVERIFY(move.ok());
    arm.run(0.2);
    QVERIFY(arm->motion().progress(move.id) != MotionProgress::Running);
    QCOMPARE(arm.state().targetQ, q);
}

void TestArmCompliance::wrongPayloadDriftsInFreedrive() {
    WatchedArm arm;
    const double z = arm.state().targetTcpPose.position.z();
    arm->environment().setLoad(Payload{.mass = 2});
    arm->compliance().startFreedrive();
    arm.run(1);
    QVERIFY(arm.tcp().z() < z - 0.02);
}

void TestArmCompliance::freedriveStatusReportsSingularities() {
    WatchedArm arm;
    QCOMPARE(arm->compliance().freedriveStatus(), 0);
    arm->compliance().startFreedrive();
    QCOMPARE(arm->compliance().freedriveStatus(), 0);
    WatchedArm stretched(true, RobotModelId::UR5e, JointPositions(0, -1.5, 0.1, -1.5, 1.5, 0));
    stretched->compliance().startFreedrive();
    QCOMPARE(stretched->compliance().freedriveStatus(), 1);
    WatchedArm singular(true, RobotModelId::UR5e, JointPositions(0, -1.5, 0.01, -1.5, 1.5, 0));
    singular->compliance().startFreedrive();
    QCOMPARE(singular->compliance().freedriveStatus(), 2);
}

void TestArmCompliance::hardContactIsAProtectiveStop() {
    WatchedArm arm;
    const double z = arm.state().targetTcpPose.position.z();
    arm->environment().addPlane({.point = {0, 0, z - 0.05}});
    Pose below = arm.state().targetTcpPose;
    below.position.z() -= 0.15;
    arm->motion().moveL(below, {.a = 1.2, .v = 0.25});
    double ratio = 0;  // ratio of the contact force to the force that stops the arm
    for (int n = 0; n < 5000 && !arm->protectiveStop(); ++n) {
        QVERIFY(ratio <= 1);
        arm.step();
        ratio = arm.state().collisionRatio;
    }
    arm.rest();
    QVERIFY(arm->protectiveStop());
    QCOMPARE(arm->protectiveStop()->reason, StopReason::TcpForceLimit);
    QVERIFY(ratio > 1);
    QVERIFY(arm.tcp().z() > z - 0.08);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmCompliance::abortEndsForceModeAndFreedrive() {
    WatchedArm arm;
    arm->compliance().startForceMode(pushDown(20));
    arm.run(0.5);
    arm->abort();
    QVERIFY(!arm->compliance().isForceMode());
    QVERIFY(arm.rest() < 0.3);
    arm->compliance().startFreedrive();
    arm->environment().setHandWrench({{0, 20, 0}, {0, 0, 0}});
    arm.run(0.5);
    arm->abort();
    QVERIFY(!arm->compliance().isFreedrive());
    QVERIFY(arm.rest() < 0.5);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

QTEST_GUILESS_MAIN(TestArmCompliance)
#include "tst_arm_compliance.moc"
