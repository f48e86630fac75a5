// SPDX-License-Identifier: MIT
#include <QSet>
#include <QTest>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/pattern.h"
#include "robot/project/waypoint_revision.h"

using namespace tiller;
using namespace tiller::project;

namespace {

/// 3 x 2 positions in the base frame, with the tool pointing down, reachable by a UR5e.
Pattern tray() {
    Pattern pattern;
    pattern.id = QUuid::createUuid();
    pattern.name = QStringLiteral("tray");
    pattern.first.name = QStringLiteral("corner");
    pattern.first.id = QUuid::createUuid();
    pattern.first.move = MoveKind::Linear;
    pattern.first.toolSpeed = 0.1;
    pattern.first.joints = JointPositions(0, -1.57, 1.57, -1.57, -1.57, 0);
    pattern.first.pose = Pose(-0.4, -0.1, 0.2, M_PI, 0, 0);
    pattern.columnEnd = {-0.4, 0.1, 0.2};
    pattern.rowEnd = {-0.5, -0.1, 0.2};
    pattern.columns = 3;
    pattern.rows = 2;
    return pattern;
}

QStringList namesOf(const Pattern& pattern) {
    QStringList names;
    for (const PatternPlace& place : placesOf(pattern)) {
        names << nameAt(pattern, place);
    }
    return names;
}

}  // namespace

class TestPattern : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cellsAreOrderedByRows() {
        QCOMPARE(namesOf(tray()),
                 QStringList({"tray 1.1", "tray 1.2", "tray 1.3", "tray 2.1", "tray 2.2", "tray 2.3"}));
    }

    void meanderReversesEverySecondRow() {
        Pattern pattern = tray();
        pattern.order = PatternOrder::Meander;
        QCOMPARE(namesOf(pattern),
                 QStringList({"tray 1.1", "tray 1.2", "tray 1.3", "tray 2.3", "tray 2.2", "tray 2.1"}));
    }

    void excludedCellsAreSkippedInEveryLayer() {
        Pattern pattern = tray();
        pattern.excluded = {{1, 0}, {9, 9}};
        pattern.layers = 2;
        const QStringList names = namesOf(pattern);
        QCOMPARE(names.size(), 10);
        QCOMPARE(names.first(), QString("tray 1.1.1"));
        QCOMPARE(names.last(), QString("tray 2.2.3"));
        QVERIFY(!names.contains("tray 1.1.2") && !names.contains("tray 2.1.2"));
    }

    void cellsAreEvenlySpacedBetweenTheCorners() {
        const Pattern pattern = tray();
        const auto at = [&](int column, int row) { return poseAt(pattern, {pattern.id, column, row, 0}); };
        QCOMPARE(at(0, 0), pattern.first.pose);
        QVERIFY(at(2, 0).position.isApprox(pattern.columnEnd, 1e-15));
        QVERIFY(at(0, 1).position.isApprox(pattern.rowEnd, 1e-15));
        QVERIFY(at(1, 1).position.isApprox(Eigen::Vector3d(-0.5, 0, 0.2), 1e-12));
        QCOMPARE(at(2, 1).rotation, pattern.first.pose.rotation);
    }

    void layersStackAgainstTheTool() {
        Pattern pattern = tray();
        pattern.layers = 3;
        pattern.layerStep = 0.03;
        // The tool points down, so layers are stacked upwards for any orientation of the corners.
        QVERIFY(std::abs(poseAt(pattern, {pattern.id, 0, 0, 2}).position.z() - 0.26) < 1e-12);
        std::swap(pattern.columnEnd, pattern.rowEnd);
        QVERIFY(std::abs(poseAt(pattern, {pattern.id, 0, 0, 2}).position.z() - 0.26) < 1e-12);
    }

    void aSingleRowOrCellDoesNotDivideByZero() {
        Pattern pattern = tray();
        pattern.rows = 1;
        pattern.columns = 1;
        QCOMPARE(namesOf(pattern), QStringList({"tray 1.1"}));
        QCOMPARE(poseAt(pattern, {pattern.id, 0, 0, 0}), pattern.first.pose);
    }

    void patternWaypointsAreOrdinaryAndReachTheirCells() {
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        const Pattern pattern = tray();
        const std::vector<Waypoint> points = waypointsOf(pattern, model, {});
        QCOMPARE(points.size(), std::size_t(6));
        QSet<QUuid> ids;
        for (const Waypoint& point : points) {
            ids.insert(point.id);
            QVERIFY(point.priority == TargetKind::Pose && point.move == MoveKind::Linear);
            QCOMPARE(point.toolSpeed, 0.1);
            QVERIFY(isWhereLaid(point, pattern));
            const Pose there = kinematics::forwardTcp(model.dh, point.joints, point.tcpOffset);
            QVERIFY((there.position - point.pose.position).norm() < 1e-6);
        }
        QCOMPARE(ids.size(), 6);
        Waypoint moved = points[2];
        moved.pose.position.z() += 1e-4;
        QVERIFY(!isWhereLaid(moved, pattern));
    }

    void unreachableCellIsKept() {
        Pattern pattern = tray();
        pattern.columnEnd = {-3, 0, 0.2};
        const auto points = waypointsOf(pattern, robotModel(RobotModelId::UR5e), {});
        QCOMPARE(points.size(), std::size_t(6));
        QVERIFY(points[2].pose.position.isApprox(pattern.columnEnd));
    }

    void historyKeepsTheLatestEntriesAndSharesCopies() {
        Waypoint point = tray().first;
        const QDateTime start = QDateTime::fromString(QStringLiteral("2026-01-01T08:00:00Z"), Qt::ISODate);
        for (int n = 0; n < WaypointHistory::kMaxRevisions + 5; ++n) {
            Waypoint after = point;
            after.blend = 0.001 * (n + 1);
            point = withRevision(after, point, start.addMSecs(n * 60'000 + 123), "Ann", "Set the blend");
        }
        QCOMPARE(point.history.size(), WaypointHistory::kMaxRevisions);
        const WaypointRevision& newest = point.history.at(WaypointHistory::kMaxRevisions - 1);
        QVERIFY(std::abs(newest.before.blend - 0.024) < 1e-12);
        QVERIFY(newest.before.history.isEmpty());
        QCOMPARE(newest.at.time().msec(), 0);
        const Waypoint copy = point;
        QVERIFY(copy == point);
        QCOMPARE(&copy.history.at(0), &point.history.at(0));
        QVERIFY(!(copy.history == WaypointHistory()));
    }
};

QTEST_GUILESS_MAIN(TestPattern)
#include "tst_pattern.moc"
