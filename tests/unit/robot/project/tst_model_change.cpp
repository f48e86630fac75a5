// SPDX-License-Identifier: MIT
// Converts a UR5e project for a UR10e and a UR3e. Either the poses or the joint positions are kept.
#include <QTest>

#include "full_project.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/model_change.h"
#include "robot/project/reachability.h"
#include "robot/project/relative_move.h"

using namespace tiller;
using namespace tiller::project;

namespace {

const RobotModel& ur5e() {
    return robotModel(RobotModelId::UR5e);
}
const RobotModel& ur10e() {
    return robotModel(RobotModelId::UR10e);
}
const RobotModel& ur3e() {
    return robotModel(RobotModelId::UR3e);
}

const JointPositions kReady(-1.6, -1.7, -2.2, -0.8, 1.6, 0.2);
const JointPositions kFar(0.4, -0.6, 0.7, -0.3, 1.5, 0);

Waypoint taught(const QString& name, const JointPositions& q, TargetKind priority,
                const FrameList& frames = {}, const QUuid& frame = {}) {
    Waypoint point;
    point.id = QUuid::createUuid();
    point.name = name;
    point.priority = priority;
    point.frame = frame;
    const Pose tcp(0, 0, 0.12, 0, 0, 0.3);
    return *taughtAt(point, q, kinematics::forwardTcp(ur5e().dh, q, tcp), tcp, frames);
}

Project projectOfUr5e() {
    Project project;
    project.robot = RobotModelId::UR5e;
    const QUuid tray = QUuid::createUuid();
    project.frames.append({tray, QStringLiteral("tray"), Pose(0.2, -0.4, 0.1, 0, 0, 0.5), {}});
    project.waypoints.append(taught(QStringLiteral("joints"), kReady, TargetKind::Joints));
    project.waypoints.append(taught(QStringLiteral("pose"), kReady, TargetKind::Pose, project.frames, tray));
    project.waypoints.append(taught(QStringLiteral("far"), kFar, TargetKind::Joints));
    project.positions.list = {{QUuid::createUuid(), QStringLiteral("Home"), kReady, {}, {}},
                              {QUuid::createUuid(), QStringLiteral("Outside"), kFar, {}, {}}};
    project.positions.home = project.positions.list.at(1).id;
    RecordedPath path;
    path.id = QUuid::createUuid();
    path.name = QStringLiteral("rim");
    path.tcpOffset = Pose(0, 0, 0.1, 0, 0, 0);
    for (int i = 0; i < 20; ++i) {
        JointPositions q = kReady;
        q[0] += 0.02 * i;
        path.points.push_back({0.1 * i, q});
    }
    project.paths.append(path);
    return project;
}

Pattern trayPattern(const Project& project) {
    Pattern pattern;
    pattern.id = QUuid::createUuid();
    pattern.name = QStringLiteral("tray");
    pattern.first = project.waypoints.at(1);
    pattern.columnEnd = pattern.first.pose.position + Eigen::Vector3d(0.1, 0, 0);
    pattern.rowEnd = pattern.first.pose.position + Eigen::Vector3d(0, 0.05, 0);
    pattern.columns = 3;
    pattern.rows = 2;
    return pattern;
}

/// Distance of a waypoint's TCP from its position on the original arm [m].
double off(const Waypoint& now, const FrameList& frames, const RobotModel& arm, const Waypoint& before) {
    const Reach target = reach(arm, now, frames);
    return poseDifference(kinematics::forwardTcp(arm.dh, target.q, now.tcpOffset),
                          *placeOf(before, ur5e(), frames))
        .distance;
}

}  // namespace

class TestModelChange : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void onlyADifferentGeometryIsADifferentModel() {
        const Project project = projectOfUr5e();
        QVERIFY(isOfOtherModel(project, RobotModelId::UR10e));
        QVERIFY(!isOfOtherModel(project, RobotModelId::UR5e));
        QVERIFY2(!isOfOtherModel(project, RobotModelId::UR7e),
                 "the UR7e counts as a different arm, although its arm is that of the UR5e");
        Project unknown = project;
        unknown.robot.reset();
        QVERIFY(!isOfOtherModel(unknown, RobotModelId::UR10e));
        Project empty;
        empty.robot = RobotModelId::UR5e;
        QVERIFY(!isOfOtherModel(empty, RobotModelId::UR10e));
        empty.positions = project.positions;
        QVERIFY(isOfOtherModel(empty, RobotModelId::UR10e));
    }

    void keptPosesAreReachedWithOtherJoints() {
        const Project before = projectOfUr5e();
        const ModelChange change = changeModel(before, ur5e(), ur10e(), Keep::Poses);
        QCOMPARE(change.unreachable, QStringList());
        QCOMPARE(change.removed, QStringList());
        QCOMPARE(change.project.robot, std::optional(RobotModelId::UR10e));
        for (int row = 0; row < before.waypoints.size(); ++row) {
            const Waypoint& was = before.waypoints.at(row);
            const Waypoint& now = change.project.waypoints.at(row);
            QCOMPARE(now.priority, was.priority);
            QVERIFY((now.joints.values - was.joints.values).norm() > 0.05);
            QVERIFY2(off(now, before.frames, ur10e(), was) < 1e-6, qPrintable(was.name));
            QVERIFY2(poseDifference(now.pose, was.pose).distance < 1e-9, "the pose has changed");
        }
        for (std::size_t i = 0; i < before.positions.list.size(); ++i) {
            const Pose was = kinematics::forwardTcp(ur5e().dh, before.positions.list.at(i).joints);
            const Pose now = kinematics::forwardTcp(ur10e().dh, change.project.positions.list.at(i).joints);
            QVERIFY(poseDifference(was, now).distance < 1e-6);
        }
        const RecordedPath& was = before.paths.at(0);
        const RecordedPath& now = change.project.paths.at(0);
        for (std::size_t i = 0; i < was.points.size(); ++i) {
            QVERIFY(poseDifference(kinematics::forwardTcp(ur5e().dh, was.points[i].q, was.tcpOffset),
                                   kinematics::forwardTcp(ur10e().dh, now.points[i].q, now.tcpOffset))
                        .distance < 1e-6);
        }
        // With unchanged joint positions, the TCP is far away from its original position.
        QVERIFY(off(before.waypoints.at(0), before.frames, ur10e(), before.waypoints.at(0)) > 0.1);
    }

    void unreachableWaypointsAreReportedAndStayMarked() {
        const Project before = projectOfUr5e();
        const ModelChange change = changeModel(before, ur5e(), ur3e(), Keep::Poses);
        QCOMPARE(change.unreachable, QStringList{QStringLiteral("far")});
        const Waypoint& far = change.project.waypoints.at(2);
        QVERIFY(!reach(ur3e(), far, before.frames).ok());
        QCOMPARE(far.priority, TargetKind::Pose);
        QVERIFY(poseDifference(far.pose, before.waypoints.at(2).pose).distance < 1e-9);
        QVERIFY(off(change.project.waypoints.at(0), before.frames, ur3e(), before.waypoints.at(0)) < 1e-6);
        // A position that is defined only by joints would be at another place with the other arm, so it is
        // removed.
        QCOMPARE(change.removed, QStringList{QStringLiteral("Outside")});
        QCOMPARE(change.project.positions.list.size(), std::size_t(1));
        QVERIFY(change.project.positions.home.isNull());
    }

    void keptJointsGetTheirNewPoses() {
        const Project before = projectOfUr5e();
        const ModelChange change = changeModel(before, ur5e(), ur10e(), Keep::Joints);
        QCOMPARE(change.unreachable, QStringList());
        for (int row = 0; row < before.waypoints.size(); ++row) {
            const Waypoint& was = before.waypoints.at(row);
            const Waypoint& now = change.project.waypoints.at(row);
            QVERIFY((now.joints.values - was.joints.values).norm() < 1e-6);
            QVERIFY(poseDifference(*poseInBase(now, before.frames),
                                   kinematics::forwardTcp(ur10e().dh, was.joints, was.tcpOffset))
                        .distance < 1e-6);
            QVERIFY((reach(ur10e(), now, before.frames).q.values - was.joints.values).norm() < 1e-6);
        }
        QCOMPARE(change.project.positions, before.positions);
        QCOMPARE(change.project.paths, before.paths);
    }

    void aPatternKeepsItsShape_data() {
        QTest::addColumn<bool>("poses");
        QTest::newRow("poses") << true;
        QTest::newRow("joints") << false;
    }
    void aPatternKeepsItsShape() {
        QFETCH(bool, poses);
        Project before = projectOfUr5e();
        const Pattern pattern = trayPattern(before);
        before.patterns.append(pattern);
        for (const Waypoint& point : waypointsOf(pattern, ur5e(), before.frames)) {
            before.waypoints.append(point);
        }
        const ModelChange change = changeModel(before, ur5e(), ur10e(), poses ? Keep::Poses : Keep::Joints);
        const Pattern& after = change.project.patterns.at(0);
        if (poses) {
            QCOMPARE(after.first.pose, pattern.first.pose);
        }
        const auto lengths = [](const Pattern& p) {
            return Eigen::Vector2d((p.columnEnd - p.first.pose.position).norm(),
                                   (p.rowEnd - p.first.pose.position).norm());
        };
        QVERIFY((lengths(after) - lengths(pattern)).norm() < 1e-9);
        int laid = 0;
        for (const Waypoint& point : change.project.waypoints) {
            if (point.place.pattern == pattern.id) {
                ++laid;
                QVERIFY2(isWhereLaid(point, after), qPrintable(point.name));
                QVERIFY(reach(ur10e(), point, before.frames).ok());
            }
        }
        QCOMPARE(laid, 6);
    }

    // All other content of the project is unchanged, and the result can be saved.
    void otherContentIsUnchanged() {
        const Project before = fullProject();
        for (const Keep keep : {Keep::Poses, Keep::Joints}) {
            const ModelChange change = changeModel(before, ur10e(), ur5e(), keep);
            QCOMPARE(change.project.frames, before.frames);
            QCOMPARE(change.project.tooling, before.tooling);
            QCOMPARE(change.project.cell, before.cell);
            QCOMPARE(change.project.waypoints.size(), before.waypoints.size());
            const auto bytes = serializeProject(change.project);
            QVERIFY2(bytes.ok(), bytes ? "" : qPrintable(bytes.error().toString()));
            const auto read = parseProject(*bytes);
            QVERIFY(read.ok());
            QCOMPARE(read->robot, std::optional(RobotModelId::UR5e));
        }
    }
};

QTEST_GUILESS_MAIN(TestModelChange)
#include "tst_model_change.moc"
