// SPDX-License-Identifier: MIT
#include <QTest>
#include <cmath>

#include "robot/collision/move_check.h"
#include "robot/kinematics/arm_kinematics.h"

using namespace tiller;
using namespace tiller::collision;

namespace {

const JointPositions kStance(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);

const RobotModel& ur5e() {
    return robotModel(RobotModelId::UR5e);
}

/// Joint positions near `from` for which the TCP is shifted by `by` [m].
JointPositions shifted(const JointPositions& from, const Eigen::Vector3d& by) {
    Pose pose = kinematics::forwardTcp(ur5e().dh, from);
    pose.position += by;
    return kinematics::inverseNearest(ur5e().dh, pose, {}, from).value();
}

MoveReport examined(const Move& move, const Surroundings& cell = {}, double fraction = 1) {
    return examineMove(ur5e(), CollisionCheck(ur5e(), {}, cell), {}, move, fraction);
}

}  // namespace

class TestMoveCheck : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void freeMoveReportsDistanceAndDuration() {
        JointPositions to = kStance;
        to[4] += 0.7156;
        to[0] -= 0.3;
        const MoveReport report = examined({kStance, to, false, 1.0, 1.0}, {}, 0.5);
        QVERIFY(!report.limit);
        QCOMPARE(report.largestTurnJoint, 4);
        QVERIFY(std::abs(report.largestTurn - 0.7156) < 1e-12);
        QVERIFY(std::abs(report.duration - 2 * 2 * std::sqrt(0.7156)) < 1e-9);
        QVERIFY((report.places.front() - kinematics::forwardTcp(ur5e().dh, kStance).position).norm() < 1e-12);
        QVERIFY((report.places.back() - kinematics::forwardTcp(ur5e().dh, to).position).norm() < 1e-12);
    }

    void aLineIsStraight() {
        const JointPositions to = shifted(kStance, {0.1, -0.1, 0.1});
        const MoveReport report = examined({kStance, to, true, 0.25, 1.2});
        QVERIFY(!report.limit);
        const Eigen::Vector3d from = report.places.front();
        const Eigen::Vector3d along = (report.places.back() - from).normalized();
        for (const Eigen::Vector3d& place : report.places) {
            QVERIFY(((place - from) - along * along.dot(place - from)).norm() < 1e-9);
        }
        for (std::size_t i = 0; i < report.way.size(); ++i) {
            QVERIFY((kinematics::forwardTcp(ur5e().dh, report.way[i]).position - report.places[i]).norm() <
                    1e-8);
        }
    }

    // Start and end are reachable. Between them is the cylinder around axis 1, which the wrist cannot reach.
    void aLineThroughTheColumnEndsBeforeTheColumn() {
        Pose pose = kinematics::forwardTcp(ur5e().dh, kStance);
        pose.position.head<2>() *= -1;
        const auto to = kinematics::inverseNearest(ur5e().dh, pose, {}, kStance);
        QVERIFY(to);
        const MoveReport report = examined({kStance, *to, true, 0.25, 1.2});
        QVERIFY(report.limit && report.limit->ends());
        QVERIFY(report.limit->share > 0.1 && report.limit->share < 0.6);
        QVERIFY(report.places.size() < 200);
    }

    void aLineNearASingularityIsSlowedDown() {
        // Wrist 2 passes through 0.
        JointPositions from(0.2, -1.4, 1.6, -1.2, 0.25, 0.1);
        JointPositions to = from;
        to[4] = 0.02;
        const MoveReport report = examined({from, to, true, 0.25, 1.2});
        QVERIFY(report.limit);
        QVERIFY(report.limit->singular == MoveLimit::Singular::Wrist);
        QVERIFY(report.limit->share > 0.3);
        // A joint move may pass through the singularity.
        QVERIFY(!examined({from, to, false, 1, 1}).limit);
    }

    void aJointThatWouldLeaveItsRangeIsNamed() {
        JointPositions to = kStance;
        to[3] = 7.0;
        const MoveReport report = examined({kStance, to, false, 1, 1});
        QVERIFY(report.limit && report.limit->kind == MoveLimit::Kind::JointRange);
        QCOMPARE(report.limit->joint, 3);
        const double share = (kJointPositionLimit - kStance[3]) / (7.0 - kStance[3]);
        QVERIFY(std::abs(report.limit->share - share) < 1e-9);
    }

    void firstObstacleIsReported() {
        const JointPositions to = shifted(kStance, {0, 0, -0.17});
        Surroundings cell;
        cell.borders.push_back({{}, Pose(0, 0, 0.08, 0, 0, 0)});
        cell.borders.push_back({"low", Pose(0, 0, 0.04, 0, 0, 0)});
        for (const bool linear : {false, true}) {
            const MoveReport report = examined({kStance, to, linear, 0.25, 1.2}, cell);
            QVERIFY(report.limit && report.limit->kind == MoveLimit::Kind::Collision);
            QVERIFY(report.limit->contact.with == Contact::With::Border);
            QCOMPARE(report.limit->contact.other, 0);
            QVERIFY(report.limit->share > 0.05 && report.limit->share < 0.95);
            const Pose at = kinematics::forwardTcp(ur5e().dh, report.limit->contact.q);
            QVERIFY((at.position - report.limit->tcp.position).norm() < 1e-12);
        }
    }

    // A slow-down does not hide a later collision.
    void aCollisionHasPriorityOverAWarning() {
        const JointPositions from(0.2, -1.4, 1.6, -1.2, 0.25, 0.1);
        JointPositions to = from;
        to[4] = 0.02;
        Surroundings cell;
        const Eigen::Vector3d end = kinematics::forwardTcp(ur5e().dh, to).position;
        cell.obstacles.push_back({"post", Pose(end.x(), end.y(), end.z(), 0, 0, 0), {0.02, 0.02, 0.02}});
        const MoveReport report = examined({from, to, true, 0.25, 1.2}, cell);
        QVERIFY(report.limit && report.limit->kind == MoveLimit::Kind::Collision);
    }
};

QTEST_GUILESS_MAIN(TestMoveCheck)
#include "tst_move_check.moc"
