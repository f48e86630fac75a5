// SPDX-License-Identifier: MIT
#include <QTest>

#include "full_project.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/relative_move.h"
#include "robot/project/waypoint_uses.h"

using namespace tiller;
using namespace tiller::project;

namespace {

const RobotModel& model() {
    return robotModel(RobotModelId::UR5e);
}

const JointPositions kReady(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);

Waypoint ready(TargetKind priority) {
    Waypoint point;
    point.id = QUuid::createUuid();
    point.name = QStringLiteral("ready");
    point.priority = priority;
    point.joints = kReady;
    point.pose = kinematics::forwardTcp(model().dh, kReady);
    return point;
}

bool same(const Pose& a, const Pose& b, double within = 1e-9) {
    const PoseDifference by = poseDifference(a, b);
    return by.distance < within && by.angle < within * 10;
}

}  // namespace

class TestRelativeMove : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void offsetsApplyInBaseFrameAndTool() {
        const Pose tcp(0.3, 0.2, 0.1, M_PI, 0, 0);
        RelativeMove move;
        move.offset = {0.01, 0.02, 0.03};
        QVERIFY(same(movedPose(tcp, move, {}), Pose(0.31, 0.22, 0.13, M_PI, 0, 0)));
        QVERIFY(
            same(movedPose(tcp, move, Pose(1, 1, 1, 0, 0, M_PI / 2)), Pose(0.28, 0.21, 0.13, M_PI, 0, 0)));
        move.axes = RelativeMove::Axes::Tool;
        QVERIFY(same(movedPose(tcp, move, {}), Pose(0.31, 0.18, 0.07, M_PI, 0, 0)));
    }

    void rotationsApplyAboutAFrameAndTheTool() {
        const Pose tcp(0.3, 0.2, 0.1, M_PI, 0, 0);
        RelativeMove move;
        move.kind = RelativeMove::Kind::Turn;
        move.angle = M_PI / 2;
        const Pose turned = movedPose(tcp, move, Pose(0.3, 0.1, 0, 0, 0, 0));
        QVERIFY(turned.position.isApprox(Eigen::Vector3d(0.2, 0.1, 0.1), 1e-12));
        QVERIFY(rotationMatrix(turned.rotation)
                    .isApprox(rotationMatrix({0, 0, M_PI / 2}) * rotationMatrix(tcp.rotation), 1e-12));
        move.axes = RelativeMove::Axes::Tool;
        const Pose spun = movedPose(tcp, move, {});
        QVERIFY(spun.position.isApprox(tcp.position));
        QVERIFY(rotationMatrix(spun.rotation)
                    .isApprox(rotationMatrix(tcp.rotation) * rotationMatrix({0, 0, M_PI / 2}), 1e-12));
    }

    void mirroringKeepsTheApproachAndIsReversible() {
        const Pose tcp(0.3, 0.2, 0.1, 2.8, 0.4, -0.3);
        RelativeMove move;
        move.kind = RelativeMove::Kind::Mirror;
        move.axis = 1;
        const Pose image = movedPose(tcp, move, {});
        QVERIFY(image.position.isApprox(Eigen::Vector3d(0.3, -0.2, 0.1), 1e-12));
        const Eigen::Matrix3d R = rotationMatrix(image.rotation);
        QVERIFY(std::abs(R.determinant() - 1) < 1e-12);
        const Eigen::Vector3d z = rotationMatrix(tcp.rotation).col(2);
        QVERIFY(R.col(2).isApprox(Eigen::Vector3d(z.x(), -z.y(), z.z()), 1e-12));
        QVERIFY(same(movedPose(image, move, {}), tcp));
    }

    void jointsAndPoseFollowTheMove() {
        RelativeMove move;
        move.offset = {0, 0, 0.05};
        for (const TargetKind priority : {TargetKind::Joints, TargetKind::Pose}) {
            const auto moved = movedBy({ready(priority)}, move, model(), {});
            QVERIFY(moved.ok());
            const Waypoint& point = moved->front();
            QVERIFY(point.priority == priority);
            const Pose there = kinematics::forwardTcp(model().dh, point.joints);
            Pose wanted = kinematics::forwardTcp(model().dh, kReady);
            wanted.position.z() += 0.05;
            QVERIFY(same(there, wanted, 1e-6));
            QVERIFY(same(point.pose, wanted, 1e-9));
            QVERIFY((point.joints.values - kReady.values).cwiseAbs().maxCoeff() < 0.5);
        }
    }

    void unreachableWaypointsAreRefusedUnlessDefinedByPose() {
        RelativeMove move;
        move.offset = {3, 0, 0};
        const auto refused = movedBy({ready(TargetKind::Joints)}, move, model(), {});
        QVERIFY(refused.error().code == ErrorCode::NoSolution);
        QCOMPARE(refused.error().context, QString("ready"));
        const auto kept = movedBy({ready(TargetKind::Pose)}, move, model(), {});
        QVERIFY(kept.ok());
        QCOMPARE(kept->front().joints, kReady);
        move.frame = QUuid::createUuid();
        QVERIFY(movedBy({ready(TargetKind::Pose)}, move, model(), {}).error().code ==
                ErrorCode::InvalidArgument);
    }

    void usesAreFound() {
        Project document = fullProject();
        using Kind = WaypointUse::Kind;
        QCOMPARE(usesOf(document, document.waypoints.at(0)),
                 QVector<WaypointUse>({{Kind::PatternCorner, "tray"}}));
        QCOMPARE(usesOf(document, document.waypoints.at(1)),
                 QVector<WaypointUse>({{Kind::PatternPlace, "tray"}}));
        Waypoint home = document.waypoints.at(0);
        home.id = QUuid::createUuid();
        home.joints = document.positions.homePosition()->joints;
        QCOMPARE(usesOf(document, home), QVector<WaypointUse>({{Kind::Home, "Home"}}));
    }
};

QTEST_GUILESS_MAIN(TestRelativeMove)
#include "tst_relative_move.moc"
