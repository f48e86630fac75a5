// SPDX-License-Identifier: MIT
//
// Checks a complete project without a robot: the findings.

#include <QTest>
#include <cmath>

#include "robot/core/angles.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/document/cell_surroundings.h"
#include "robot/station/document/project_check.h"

using namespace tiller;

namespace {

using Kind = ProjectFinding::Kind;

const RobotModel& arm() {
    return robotModel(RobotModelId::UR5e);
}

/// The tool points down, and the base joint is at this angle.
JointPositions turned(double degrees) {
    JointPositions q;
    q.values << toRadians(degrees), -M_PI / 2, M_PI / 2, -M_PI / 2, -M_PI / 2, 0;
    return q;
}

project::Waypoint waypoint(const QString& name, const JointPositions& q) {
    project::Waypoint point;
    point.id = QUuid::createUuid();
    point.name = name;
    point.joints = q;
    point.pose = kinematics::forwardTcp(arm().dh, q);
    return point;
}

project::CellBox boxAt(const Eigen::Vector3d& place) {
    project::CellBox box;
    box.id = QUuid::createUuid();
    box.name = QStringLiteral("crate");
    box.pose.position = place;
    box.size = Eigen::Vector3d::Constant(0.05);
    return box;
}

QVector<Kind> kindsOf(const std::vector<ProjectFinding>& findings) {
    QVector<Kind> kinds;
    for (const ProjectFinding& finding : findings) {
        kinds << finding.kind;
    }
    return kinds;
}

/// A box whose top face is this far below the position.
project::CellBox boxBelow(const Eigen::Vector3d& place, double gap) {
    project::CellBox box = boxAt(place);
    box.pose.position.z() -= gap + box.size.z() / 2;
    return box;
}

}  // namespace

class TestProjectCheck : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        project_ = {};
        project_.robot = RobotModelId::UR5e;
        project_.waypoints.append(waypoint("left", turned(0)));
        project_.waypoints.append(waypoint("right", turned(90)));
    }

    void collisionFreePathsHaveNoFinding() { QVERIFY(checkProject(project_, arm()).empty()); }

    void anUnreachableWaypointIsReportedAndItsPathsSkipped() {
        project::Waypoint far = waypoint("far", turned(45));
        far.priority = project::TargetKind::Pose;
        far.pose.position.x() = 3;
        project_.waypoints.insert(1, far);
        const auto findings = checkProject(project_, arm());
        QCOMPARE(kindsOf(findings), QVector{Kind::Unreachable});
        QCOMPARE(findings[0].row, 1);
        QCOMPARE(findings[0].reach.obstacle, project::Reach::Obstacle::OutOfReach);
        QVERIFY(findings[0].isError());
    }

    void boxOnThePathBlocksIt() {
        project_.cell.boxes.append(boxAt(kinematics::forwardTcp(arm().dh, turned(45)).position));
        const auto findings = checkProject(project_, arm());
        QCOMPARE(kindsOf(findings), QVector{Kind::Blocked});
        QCOMPARE(findings[0].row, 1);
        QCOMPARE(findings[0].limit.kind, collision::MoveLimit::Kind::Collision);
        QVERIFY(findings[0].limit.share > 0.2 && findings[0].limit.share < 0.5);
    }

    void disabledBoxIsIgnored() {
        project::CellBox box = boxAt(kinematics::forwardTcp(arm().dh, turned(45)).position);
        box.enabled = false;
        project_.cell.boxes.append(box);
        QVERIFY(checkProject(project_, arm()).empty());
    }

    void objectsWithAMissingFrameAreFound() {
        project::CellBox box = boxAt(kinematics::forwardTcp(arm().dh, turned(45)).position);
        box.frame = QUuid::createUuid();
        project_.cell.boxes.append(box);
        project::CellPlane plane;
        plane.name = QStringLiteral("wall");
        plane.frame = QUuid::createUuid();
        project_.cell.planes.append(plane);
        const auto findings = checkProject(project_, arm());
        QCOMPARE(kindsOf(findings), (QVector{Kind::Unplaced, Kind::Unplaced}));
        QCOMPARE(findings[0].object.name, plane.name);
        QCOMPARE(findings[1].object.name, box.name);
        QCOMPARE(findings[1].object.frame, box.frame.toString(QUuid::WithoutBraces));
        QVERIFY(findings[1].isError());
        // The user has excluded the box and the plane from the check.
        box.enabled = plane.enabled = false;
        project_.cell.boxes.replace(0, box);
        project_.cell.planes.replace(0, plane);
        QVERIFY(checkProject(project_, arm()).empty());
    }

    void safetyDistanceIsKeptAtAWaypoint() {
        project_.waypoints.take(1);
        project_.cell.boxes.append(boxBelow(project_.waypoints.at(0).pose.position, 0.03));
        QVERIFY(checkProject(project_, arm()).empty());
        project_.cell.safetyDistance = 0.04;
        const auto findings = checkProject(project_, arm());
        QCOMPARE(kindsOf(findings), QVector{Kind::TooClose});
        QCOMPARE(findings[0].contact.with, collision::Contact::With::Obstacle);
        QVERIFY(findings[0].contact.distance > 0.01 && findings[0].contact.distance < 0.04);
    }

    void flangeInsideABoxIsFound() {
        project_.waypoints.take(1);
        project_.cell.boxes.append(boxAt(project_.waypoints.at(0).pose.position));
        const auto findings = checkProject(project_, arm());
        QCOMPARE(kindsOf(findings), QVector{Kind::TooClose});
        QCOMPARE(findings[0].contact.with, collision::Contact::With::Obstacle);
        QVERIFY(findings[0].contact.distance < 0);
    }

    void armBelowTheFloorIsFound() {
        project_.waypoints.take(1);
        project_.cell.floor = project_.waypoints.at(0).pose.position.z();
        const auto findings = checkProject(project_, arm());
        QCOMPARE(kindsOf(findings), QVector{Kind::TooClose});
        QCOMPARE(findings[0].contact.with, collision::Contact::With::Border);
    }

    void recordedPathThroughABoxIsFound() {
        project_.waypoints = {};
        project::RecordedPath path;
        path.id = QUuid::createUuid();
        path.name = QStringLiteral("sweep");
        path.points = {{0, turned(0)}, {1, turned(90)}};
        project_.paths.append(path);
        QVERIFY(checkProject(project_, arm()).empty());
        project_.cell.boxes.append(boxAt(kinematics::forwardTcp(arm().dh, turned(45)).position));
        const auto findings = checkProject(project_, arm());
        QCOMPARE(kindsOf(findings), QVector{Kind::RecordedPath});
        QVERIFY(findings[0].isError());
    }

    void toolRadiusOfTheActiveToolCounts() {
        project_.waypoints = {};
        project::Waypoint point = waypoint("tool", turned(0));
        point.tcpOffset = Pose(0, 0, 0.2, 0, 0, 0);
        point.pose = kinematics::forwardTcp(arm().dh, turned(0), point.tcpOffset);
        project_.waypoints.append(point);
        // The side of the box is 50 mm from the tool axis.
        project_.cell.boxes.append(boxAt(point.pose.position + Eigen::Vector3d(0.075, 0, 0.1)));
        QVERIFY(checkProject(project_, arm()).empty());
        project::Tool tool;
        tool.id = QUuid::createUuid();
        tool.name = QStringLiteral("gripper");
        tool.radius = 0.06;
        project_.tooling.tools.append(tool);
        project_.tooling.activeTool = tool.id;
        QCOMPARE(surroundingsOf(project_).toolRadius, 0.06);
        const auto findings = checkProject(project_, arm());
        QCOMPARE(kindsOf(findings), QVector{Kind::TooClose});
        QCOMPARE(findings[0].contact.link, collision::kToolLink);
    }

private:
    project::Project project_;
};

QTEST_GUILESS_MAIN(TestProjectCheck)
#include "tst_project_check.moc"
