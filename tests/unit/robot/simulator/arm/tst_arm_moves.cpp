// SPDX-License-Identifier: MIT
// Moves between waypoints: durations, parameters, unreachable targets, pause and resume.
#include <QTest>
#include <cmath>
#include <limits>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/unit/robot/simulator/arm/arm_fixture.h"

using namespace tiller;
using namespace tiller::simulator::arm;

namespace {
const JointPositions kFrom(-1.57, -1.57, 0, 0, 0, 0);
const JointPositions kTo(-1.57, -1.6, 1.6, -0.7, 0.7, 0.2);
constexpr double kTick = 0.002;

Pose shifted(Pose pose, double x, double y, double z) {
    pose.position += Eigen::Vector3d(x, y, z);
    return pose;
}
}  // namespace

class TestArmMoves : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void moveJTakesTheTimeOfTheTestVector();
    void moveLTakesTheTimeOfTheTestVector();
    void moveJEndsExactlyOnTarget();
    void moveLFollowsTheLineAndRotatesSynchronously();
    void pureRotationTakesTimeAndKeepsThePoint();
    void timeHasPriority();
    void infeasibleTimeIsStretched();
    void infeasibleSpeedIsCut();
    void zeroLengthMoveReturnsAtOnce();
    void moveJToPoseTakesTheNearestSolution();
    void circleKeepsItsRadius();
    void jointTargetOutOfRangeIsRefused();
    void poseWithoutSolutionIsRefusedByMoveJ();
    void unreachableLineIsAProtectiveStop();
    void lineToADistantPointIsFollowedUpToTheReachLimit();
    void lineThroughASingularityStopsBeforeIt();
    void lineNearASingularityIsSlowed();
    void badArgumentsAreRefused_data();
    void badArgumentsAreRefused();
    void nothingMovesWithoutPower();
    void slowSliderKeepsThePath();
    void pauseStaysOnThePathAndResumes();
    void holdStopsSpeedCommandsToo();
    void moveFromMotionStartsSmoothly();
    void abandonedMoveComesToAStandstill();
    void referencePosesAreReachable();
};

void TestArmMoves::moveJTakesTheTimeOfTheTestVector() {
    WatchedArm arm(true, RobotModelId::UR5e, kFrom);
    const double t = arm.finish(arm->motion().moveJ(kTo, {.a = 3.4, .v = 3.1}));
    QVERIFY2(std::abs(t - 1.372) <= kTick, qPrintable(QString::number(t)));
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::moveLTakesTheTimeOfTheTestVector() {
    WatchedArm arm(true, RobotModelId::UR5e, kTo);
    arm.finish(arm->motion().moveL(Pose(-0.203, 0.263, 0.559, 0.68, -1.083, -2.076), {.a = 2.5, .v = 2.5}));
    const double t = arm.finish(
        arm->motion().moveL(Pose(-0.203, 0.463, 0.559, 0.68, -1.083, -2.076), {.a = 2.5, .v = 2.5}));
    QVERIFY(!arm->protectiveStop());
    QVERIFY2(std::abs(t - 0.566) <= kTick, qPrintable(QString::number(t)));
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::moveJEndsExactlyOnTarget() {
    WatchedArm arm;
    arm.finish(arm->motion().moveJ(kTo, {.a = 1.4, .v = 1.05}));
    QVERIFY((arm.state().targetQ.values - kTo.values).cwiseAbs().maxCoeff() < 1e-12);
    QVERIFY(arm.state().targetQd.values.isZero(0));
    QVERIFY(!arm->motion().isActive());
}

void TestArmMoves::moveLFollowsTheLineAndRotatesSynchronously() {
    WatchedArm arm;
    const Pose start = arm.state().targetTcpPose;
    Pose goal = shifted(start, 0.2, 0.05, 0.1);
    const Eigen::Vector3d turn(0, 0, 0.6);
    goal.rotation = rotationVector(rotationMatrix(turn) * rotationMatrix(start.rotation));
    const MotionStart move = arm->motion().moveL(goal, {.a = 1.2, .v = 0.25});
    const Eigen::Vector3d way = goal.position - start.position;
    double worst = 0;
    while (arm->motion().progress(move.id) == MotionProgress::Running) {
        arm.step();
        const double done = (arm.tcp() - start.position).dot(way) / way.squaredNorm();
        worst = std::max(worst, (arm.tcp() - start.position - done * way).norm());
        const Eigen::Vector3d turned = rotationVector(rotationMatrix(arm.state().targetTcpPose.rotation) *
                                                      rotationMatrix(start.rotation).transpose());
        worst = std::max(worst, (turned - done * turn).norm());
    }
    QVERIFY2(worst < 1e-8, qPrintable(QString::number(worst)));
    QVERIFY((arm.tcp() - goal.position).norm() < 1e-9);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::pureRotationTakesTimeAndKeepsThePoint() {
    WatchedArm arm;
    const Pose start = arm.state().targetTcpPose;
    Pose goal = start;
    goal.rotation =
        rotationVector(rotationMatrix(start.rotation) * rotationMatrix(Eigen::Vector3d(0, 0, 0.8)));
    const MotionStart move = arm->motion().moveL(goal, {.a = 1.2, .v = 0.25});
    double drift = 0;
    double t = 0;
    while (arm->motion().progress(move.id) == MotionProgress::Running) {
        arm.step();
        t += kTick;
        drift = std::max(drift, (arm.tcp() - start.position).norm());
    }
    // 0.8 rad at the equivalent radius of 0.25 m correspond to 0.2 m of tool path.
    QVERIFY2(std::abs(t - (0.2 / 0.25 + 0.25 / 1.2)) <= 2 * kTick, qPrintable(QString::number(t)));
    QVERIFY(drift < 1e-8);
}

void TestArmMoves::timeHasPriority() {
    WatchedArm arm(true, RobotModelId::UR5e, kFrom);
    const double j = arm.finish(arm->motion().moveJ(kTo, {.a = 3.4, .v = 3.1, .t = 3.0}));
    QVERIFY2(std::abs(j - 3.0) <= kTick, qPrintable(QString::number(j)));
    const Pose here = arm.state().targetTcpPose;
    const double l =
        arm.finish(arm->motion().moveL(shifted(here, 0, 0.05, 0.05), {.a = 1.2, .v = 0.25, .t = 2.2}));
    QVERIFY2(std::abs(l - 2.2) <= kTick, qPrintable(QString::number(l)));
    const Pose there = arm.state().targetTcpPose;
    const double quick =
        arm.finish(arm->motion().moveL(shifted(there, 0, -0.01, 0), {.a = 0.1, .v = 0.01, .t = 0.5}));
    QVERIFY2(std::abs(quick - 0.5) <= kTick, qPrintable(QString::number(quick)));
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::infeasibleTimeIsStretched() {
    WatchedArm arm(true, RobotModelId::UR5e, kFrom);
    JointPositions far = kFrom;
    far[0] += 3.14;
    const double j = arm.finish(arm->motion().moveJ(far, {.a = 1.4, .v = 1.05, .t = 0.1}));
    QVERIFY(j > 1.0 && j < 3.0);
    arm.finish(arm->motion().moveJ(kTo, {.a = 1.4, .v = 1.05}));
    const Pose here = arm.state().targetTcpPose;
    const double l =
        arm.finish(arm->motion().moveL(shifted(here, 0, 0.3, 0), {.a = 1.2, .v = 0.25, .t = 0.1}));
    QVERIFY(!arm->protectiveStop());
    QVERIFY2(l > 0.1 && l < 2.0, qPrintable(QString::number(l)));
    QVERIFY((arm.tcp() - here.position - Eigen::Vector3d(0, 0.3, 0)).norm() < 1e-8);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::infeasibleSpeedIsCut() {
    WatchedArm arm(true, RobotModelId::UR5e, kFrom);
    arm.finish(arm->motion().moveJ(kTo, {.a = 500, .v = 100}));
    arm.finish(arm->motion().moveL(shifted(arm.state().targetTcpPose, 0, 0.2, 0), {.a = 150, .v = 50}));
    QVERIFY(!arm->protectiveStop());
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::zeroLengthMoveReturnsAtOnce() {
    WatchedArm arm;
    const MotionStart j = arm->motion().moveJ(arm.state().targetQ, {.a = 1.4, .v = 1.05});
    QCOMPARE(arm->motion().progress(j.id), MotionProgress::Returned);
    const MotionStart l = arm->motion().moveL(arm.state().targetTcpPose, {});
    QCOMPARE(arm->motion().progress(l.id), MotionProgress::Returned);
    const MotionStart stop = arm->motion().stopJ(2);
    QCOMPARE(arm->motion().progress(stop.id), MotionProgress::Returned);
    const MotionStart stopL = arm->motion().stopL(2);
    QCOMPARE(arm->motion().progress(stopL.id), MotionProgress::Returned);
    arm.run(0.1);
    QCOMPARE(arm.worstSpeed, 0.0);
}

void TestArmMoves::moveJToPoseTakesTheNearestSolution() {
    WatchedArm arm;
    const JointPositions start = arm.state().targetQ;
    JointPositions near = start;
    near[0] += 0.3;
    near[2] += 0.2;
    const Pose pose = kinematics::forwardTcp(arm->model().dh, near, arm->tcp());
    arm.finish(arm->motion().moveJ(pose, {.a = 1.4, .v = 1.05}));
    QVERIFY((arm.state().targetQ.values - near.values).cwiseAbs().maxCoeff() < 1e-7);
}

void TestArmMoves::circleKeepsItsRadius() {
    WatchedArm arm;
    const Pose start = arm.state().targetTcpPose;
    const Eigen::Vector3d centre = start.position + Eigen::Vector3d(0.1, 0, 0);
    const Pose via = shifted(start, 0.1, 0, 0.1);
    const Pose goal = shifted(start, 0.2, 0, 0);
    const MotionStart move = arm->motion().moveC(via, goal, {.a = 1.2, .v = 0.25});
    double worst = 0;
    double highest = 0;
    while (arm->motion().progress(move.id) == MotionProgress::Running) {
        arm.step();
        worst = std::max(worst, std::abs((arm.tcp() - centre).norm() - 0.1));
        highest = std::max(highest, arm.tcp().z() - start.position.z());
    }
    QVERIFY(!arm->protectiveStop());
    QVERIFY2(worst < 1e-8, qPrintable(QString::number(worst)));
    QVERIFY(highest > 0.0999);
    QVERIFY((arm.tcp() - goal.position).norm() < 1e-9);
    // The orientation is fixed to the arc: half a turn about the axis of the circle.
    arm.finish(arm->motion().moveC(shifted(start, 0.1, 0, 0.1), start, {.a = 1.2, .v = 0.25},
                                   ArcOrientation::FixedToArc));
    if (!arm->protectiveStop()) {
        const Eigen::AngleAxisd turned(rotationMatrix(arm.state().targetTcpPose.rotation) *
                                       rotationMatrix(start.rotation).transpose());
        QVERIFY(std::abs(turned.angle() - 180 * kDegree) < 1e-6);
    }
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::jointTargetOutOfRangeIsRefused() {
    WatchedArm arm;
    const MotionStart move = arm->motion().moveJ(JointPositions(0, 0, -123, 0, 0, 0), {});
    QCOMPARE(move.error, MotionError::JointTargetOutOfRange);
    QCOMPARE(move.joint, 2);
    QVERIFY(!arm->protectiveStop());
    QVERIFY(!arm->motion().isActive());
}

void TestArmMoves::poseWithoutSolutionIsRefusedByMoveJ() {
    WatchedArm arm;
    QCOMPARE(arm->motion().moveJ(Pose(3, 0, 0, 0, 0, 0), {}).error, MotionError::NoInverseKinematics);
}

void TestArmMoves::unreachableLineIsAProtectiveStop() {
    WatchedArm arm;
    const MotionStart move = arm->motion().moveL(Pose(3, 0, 0, 0, 0, 0), {});
    arm.run(30);
    QVERIFY(arm->protectiveStop());
    QCOMPARE(arm->protectiveStop()->reason, StopReason::PoseUnreachable);
    QCOMPARE(arm->motion().progress(move.id), MotionProgress::Failed);
    QCOMPARE(arm->motion().moveJ(kTo, {}).error, MotionError::NotOperational);
    arm->clearProtectiveStop();
    QVERIFY(arm->motion().moveJ(kTo, {}).ok());
}

// Programs that probe a surface move towards a distant point and stop before reaching it.
void TestArmMoves::lineToADistantPointIsFollowedUpToTheReachLimit() {
    for (const double distance : {1.0, 2.0, 1000.0}) {
        WatchedArm arm;
        arm.finish(arm->motion().moveJ(JointPositions(0, -1.5, 1.6, -1.7, -1.57, 0), {.a = 1.4, .v = 1.05}));
        const Pose begin = arm->state().targetTcpPose;
        Pose target = begin;
        target.position.z() -= distance;
        QVERIFY(arm->motion().moveL(target, {.a = 1.2, .v = 0.02}).ok());
        arm.run(1.0);
        QVERIFY2(!arm->protectiveStop(), qPrintable(QString::number(distance)));
        const double moved = begin.position.z() - arm->state().targetTcpPose.position.z();
        QVERIFY2(std::abs(moved - 0.02) < 0.001, qPrintable(QString::number(moved)));
        if (distance < 1.5) {
            continue;  // within reach
        }
        arm.run(100);
        QVERIFY(arm->protectiveStop());
        QCOMPARE(arm->protectiveStop()->reason, StopReason::PoseUnreachable);
        const double all = begin.position.z() - arm->state().targetTcpPose.position.z();
        QVERIFY2(all > 0.3 && all < 1.5, qPrintable(QString::number(all)));
    }
}

void TestArmMoves::lineThroughASingularityStopsBeforeIt() {
    // On a straight path across the base, the wrist centre reaches the cylinder around axis 1.
    WatchedArm arm;
    arm.finish(arm->motion().moveJ(Pose(-0.14, -0.436, 0.35, 0, 3.1416, 0), {.a = 1.4, .v = 1.05}));
    const MotionStart move =
        arm->motion().moveL(Pose(0.14, 0.436, 0.35, 0, 3.1416, 0), {.a = 1.2, .v = 0.25});
    arm.finish(move);
    arm.run(1.0);
    QVERIFY(arm->protectiveStop());
    QCOMPARE(arm->protectiveStop()->reason, StopReason::Singularity);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
    QVERIFY(arm.state().isStandstill());
}

void TestArmMoves::lineNearASingularityIsSlowed() {
    // Near the axis of the base joint, this joint must rotate fast, so the tool must slow down.
    WatchedArm arm;
    arm.finish(arm->motion().moveJ(Pose(-0.3, -0.18, 0.4, 0, 3.1416, 0), {.a = 1.4, .v = 1.05}));
    QVERIFY(!arm->protectiveStop());
    const double t = arm.finish(arm->motion().moveL(Pose(0.3, -0.18, 0.4, 0, 3.1416, 0), {.a = 3, .v = 1.5}));
    QVERIFY(!arm->protectiveStop());
    QVERIFY2(t > 0.6 / 1.5 + 1.5 / 3 + 0.02, qPrintable(QString::number(t)));
    QVERIFY(arm.worstSpeed > 0.5);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::badArgumentsAreRefused_data() {
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("v");
    QTest::addColumn<double>("t");
    QTest::addColumn<double>("r");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("a 0") << 0.0 << 1.0 << 0.0 << 0.0;
    QTest::newRow("a negative") << -1.0 << 1.0 << 0.0 << 0.0;
    QTest::newRow("v 0") << 1.0 << 0.0 << 0.0 << 0.0;
    QTest::newRow("v nan") << 1.0 << nan << 0.0 << 0.0;
    QTest::newRow("t negative") << 1.0 << 1.0 << -1.0 << 0.0;
    QTest::newRow("r nan") << 1.0 << 1.0 << 0.0 << nan;
}

void TestArmMoves::badArgumentsAreRefused() {
    QFETCH(double, a);
    QFETCH(double, v);
    QFETCH(double, t);
    QFETCH(double, r);
    WatchedArm arm;
    QCOMPARE(arm->motion().moveJ(kTo, {a, v, t, r}).error, MotionError::InvalidArgument);
    QCOMPARE(arm->motion().moveL(kTo, {a, v, t, r}).error, MotionError::InvalidArgument);
}

void TestArmMoves::nothingMovesWithoutPower() {
    WatchedArm arm;
    arm->setDriveState(DriveState::Braked);
    QCOMPARE(arm->motion().moveJ(kTo, {}).error, MotionError::NotOperational);
    QCOMPARE(arm->motion().speedJ(JointVelocities(1, 0, 0, 0, 0, 0), 1, 1.0).error,
             MotionError::NotOperational);
    arm->setDriveState(DriveState::Running);
    QVERIFY(arm->motion().moveJ(kTo, {}).ok());
    arm.run(0.5);
    const JointPositions there = arm.state().targetQ;
    arm->setDriveState(DriveState::Off);
    arm->step();
    QVERIFY(arm.state().targetQd.values.isZero(0));
    QCOMPARE(arm.state().targetQ, there);
    QVERIFY(arm.state().actualCurrent.isZero(0));
    QVERIFY(arm.state().jointVoltage.isZero(0));
}

void TestArmMoves::slowSliderKeepsThePath() {
    WatchedArm arm(true, RobotModelId::UR5e, kFrom);
    arm->setSpeedFraction(0.25);
    arm.run(0.01);
    const MotionStart move = arm->motion().moveJ(kTo, {.a = 3.4, .v = 3.1});
    const Vector6 way = kTo.values - kFrom.values;
    double t = 0;
    double worst = 0;
    while (arm->motion().progress(move.id) == MotionProgress::Running) {
        arm.step();
        t += kTick;
        const Vector6 moved = arm.state().targetQ.values - kFrom.values;
        worst = std::max(worst, (moved - way * (moved[2] / way[2])).cwiseAbs().maxCoeff());
    }
    QVERIFY2(std::abs(t - 4 * 1.372) <= 4 * kTick, qPrintable(QString::number(t)));
    QVERIFY(worst < 1e-9);
    QCOMPARE(arm.state().speedFraction, 0.25);
}

void TestArmMoves::pauseStaysOnThePathAndResumes() {
    WatchedArm arm;
    const Pose start = arm.state().targetTcpPose;
    const Pose goal = shifted(start, 0.25, 0, 0.1);
    const MotionStart move = arm->motion().moveL(goal, {.a = 1.2, .v = 0.25});
    const Eigen::Vector3d way = (goal.position - start.position).normalized();
    const auto offPath = [&] {
        const Eigen::Vector3d moved = arm.tcp() - start.position;
        return (moved - way * moved.dot(way)).norm();
    };
    arm.run(0.5);
    arm->hold();
    double stopTime = 0;
    while (!arm.state().isStandstill() && stopTime < 2) {
        arm.step();
        stopTime += kTick;
        QVERIFY(offPath() < 1e-8);
    }
    QVERIFY2(stopTime > 0.01 && stopTime < 0.5, qPrintable(QString::number(stopTime)));
    QCOMPARE(arm.state().speedScaling, 0.0);
    const Eigen::Vector3d paused = arm.tcp();
    arm.run(1.0);
    QCOMPARE(arm.tcp(), paused);
    QCOMPARE(arm->motion().progress(move.id), MotionProgress::Running);
    arm->resume();
    arm.finish(move);
    QCOMPARE(arm->motion().progress(move.id), MotionProgress::Returned);
    QVERIFY((arm.tcp() - goal.position).norm() < 1e-9);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::holdStopsSpeedCommandsToo() {
    WatchedArm arm;
    const MotionStart speed = arm->motion().speedJ(JointVelocities(0.5, 0, 0, 0, 0, 0), 2, 2.0);
    arm.run(0.5);
    arm->hold();
    arm.run(1.0);
    QVERIFY(arm.state().targetQd.values.cwiseAbs().maxCoeff() < 1e-9);
    QCOMPARE(arm->motion().progress(speed.id), MotionProgress::Running);
    arm->resume();
    arm.run(0.5);
    QVERIFY(std::abs(arm.state().targetQd[0] - 0.5) < 1e-9);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::moveFromMotionStartsSmoothly() {
    WatchedArm arm;
    arm->motion().moveJ(kTo, {.a = 3, .v = 1.5});
    arm.run(0.6);
    QVERIFY(arm.worstSpeed > 0.2);
    // The next move starts while the arm is still moving, as after a thread was killed.
    const JointPositions goal(-1.2, -1.4, -2.0, -1.0, 1.4, 0.3);
    const MotionStart move = arm->motion().moveJ(goal, {.a = 3, .v = 1.5});
    QVERIFY(move.ok());
    arm.finish(move);
    QVERIFY((arm.state().targetQ.values - goal.values).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
    QVERIFY2(arm.worstAcceleration < 10, arm.worst().c_str());
}

void TestArmMoves::abandonedMoveComesToAStandstill() {
    WatchedArm arm;
    const MotionStart move = arm->motion().moveJ(kTo, {.a = 1.4, .v = 1.05});
    arm.run(0.8);
    arm->motion().abandon();
    QCOMPARE(arm->motion().progress(move.id), MotionProgress::Superseded);
    const double t = arm.rest();
    QVERIFY2(t < 0.4, qPrintable(QString::number(t)));
    QVERIFY((arm.state().targetQ.values - kTo.values).norm() > 0.1);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

void TestArmMoves::referencePosesAreReachable() {
    WatchedArm arm(true, RobotModelId::UR5e, kTo);
    const Pose a(-0.203, 0.263, 0.559, 0.68, -1.083, -2.076);
    const Pose b(-0.203, 0.463, 0.559, 0.68, -1.083, -2.076);
    const Pose c(-0.203, 0.363, 0.759, 0.68, -1.083, -2.076);
    const Pose d(-0.209, 0.492, 0.5522, 0.928, -1.134, -2.168);
    const Pose via(-0.209, 0.487, 0.671, 1.026, -0.891, -2.337);
    const Pose e(-0.209, 0.425, 0.841, 1.16, -0.477, -2.553);
    arm.finish(arm->motion().moveL(a, {.a = 1.2, .v = 0.25}));
    arm.finish(arm->motion().moveL(b, {.a = 1.2, .v = 0.25}));
    arm.finish(arm->motion().moveP(c, {.a = 1.2, .v = 0.25}));
    arm.finish(arm->motion().moveP(d, {.a = 1.2, .v = 0.25}));
    arm.finish(arm->motion().moveC(via, e, {.a = 1.2, .v = 0.25}));
    QVERIFY(!arm->protectiveStop());
    QVERIFY((arm.tcp() - e.position).norm() < 1e-8);
    QVERIFY2(arm.withinBounds(), arm.worst().c_str());
}

QTEST_GUILESS_MAIN(TestArmMoves)
#include "tst_arm_moves.moc"
