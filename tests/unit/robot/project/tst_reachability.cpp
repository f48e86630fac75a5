// SPDX-License-Identifier: MIT
#include <QTest>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/reachability.h"

using namespace tiller;
using namespace tiller::project;

namespace {

const JointPositions kStart(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);

const RobotModel& ur5e() {
    return robotModel(RobotModelId::UR5e);
}

Waypoint poseRuled(const Pose& pose, const JointPositions& near = kStart) {
    Waypoint point;
    point.id = QUuid::createUuid();
    point.name = "p";
    point.move = MoveKind::Linear;
    point.priority = TargetKind::Pose;
    point.pose = pose;
    point.joints = near;
    return point;
}

}  // namespace

class TestReachability : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aTaughtPoseIsReachedWithItsOwnPosture() {
        const Pose offset(0, 0, 0.15, 0, 0, 0.3);
        Waypoint point = poseRuled(kinematics::forwardTcp(ur5e().dh, kStart, offset));
        point.tcpOffset = offset;
        const Reach result = reach(ur5e(), point, {});
        QVERIFY(result.ok());
        QVERIFY((result.q.values - kStart.values).norm() < 1e-8);
    }

    void aDistantPoseIsOutOfReach() {
        QVERIFY(reach(ur5e(), poseRuled(Pose(3, 0, 0.2, 0, 3.14, 0)), {}).obstacle ==
                Reach::Obstacle::OutOfReach);
    }

    void aWaypointDefinedByJointsNeedsNoPose() {
        Waypoint point = poseRuled(Pose(3, 0, 0.2, 0, 3.14, 0));
        point.priority = TargetKind::Joints;
        QVERIFY(reach(ur5e(), point, {}).ok());
        point.joints[3] = 6.5;
        QVERIFY(reach(ur5e(), point, {}).obstacle == Reach::Obstacle::JointLimit);
    }

    void aMissingFrameIsReported() {
        Waypoint point = poseRuled(Pose(0.3, 0.2, 0.2, 0, 3.14, 0));
        point.frame = QUuid::createUuid();
        QVERIFY(reach(ur5e(), point, {}).obstacle == Reach::Obstacle::FrameMissing);
    }

    void previewNamesTheLargestTurnAndTheTime() {
        Waypoint point;
        point.joints = kStart;
        point.joints[4] += 0.8;
        point.joints[1] -= 0.3;
        const MovePreview preview = previewMove(ur5e(), point, {}, kStart);
        QVERIFY(preview.reach.ok());
        QCOMPARE(preview.largestTurnJoint, 4);
        QVERIFY(std::abs(preview.largestTurn - 0.8) < 1e-12);
        const double expected = 0.8 / kDefaultJointSpeed + kDefaultJointSpeed / kDefaultJointAcceleration;
        QVERIFY(std::abs(preview.duration - expected) < 1e-12);
        const MovePreview slow = previewMove(ur5e(), point, {}, kStart, 0.1);
        QVERIFY(slow.duration > 5 * preview.duration);
    }

    void straightLineIsFollowedFromTheLivePosture() {
        Pose target = kinematics::forwardTcp(ur5e().dh, kStart);
        target.position.z() += 0.1;
        const MovePreview preview = previewMove(ur5e(), poseRuled(target), {}, kStart);
        QVERIFY(preview.reach.ok());
        const Pose reached = kinematics::forwardTcp(ur5e().dh, preview.reach.q);
        QVERIFY(poseDifference(reached, target).distance < 1e-8);
        QVERIFY(std::abs(preview.largestTurn) < 1.0);
        QVERIFY(preview.duration > 0.4);
    }

    void aLineThroughTheRobotColumnIsRefused() {
        // The start and the end are reachable. Between them is the cylinder around axis 1, which the wrist
        // cannot enter.
        Pose target = kinematics::forwardTcp(ur5e().dh, kStart);
        target.position = Eigen::Vector3d(-target.position.x(), -target.position.y(), target.position.z());
        const Waypoint point = poseRuled(target);
        QVERIFY(reach(ur5e(), point, {}).ok());
        QVERIFY(previewMove(ur5e(), point, {}, kStart).reach.obstacle == Reach::Obstacle::OnTheWay);
    }

    void anotherActiveTcpStillReachesTheFlangePose() {
        const Pose taughtTcp(0, 0, 0.1, 0, 0, 0);
        const Pose activeTcp(0.02, 0, 0.2, 0, 0.5, 0);
        Waypoint point = poseRuled(kinematics::forwardTcp(ur5e().dh, kStart, taughtTcp));
        point.tcpOffset = taughtTcp;
        QCOMPARE(*targetForTcp(point, {}, taughtTcp), point.pose);
        const auto target = targetForTcp(point, {}, activeTcp);
        QVERIFY(target.has_value());
        const PoseDifference off =
            poseDifference(*target, kinematics::forwardTcp(ur5e().dh, kStart, activeTcp));
        QVERIFY(off.distance < 1e-12);
        QVERIFY(off.angle < 1e-7);
    }
};

QTEST_GUILESS_MAIN(TestReachability)
#include "tst_reachability.moc"
