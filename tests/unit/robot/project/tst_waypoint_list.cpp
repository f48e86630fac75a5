// SPDX-License-Identifier: MIT
#include <QTest>
#include <numbers>

#include "robot/project/waypoint_list.h"

using namespace tiller;
using namespace tiller::project;

namespace {

Waypoint named(const QString& name) {
    Waypoint point;
    point.id = QUuid::createUuid();
    point.name = name;
    return point;
}

QString names(const WaypointList& list) {
    QStringList result;
    for (const Waypoint& point : list) {
        result << point.name;
    }
    return result.join(',');
}

}  // namespace

class TestWaypointList : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void insertPutsTheWaypointAtItsIndex() {
        WaypointList list;
        list.append(named("a"));
        list.append(named("c"));
        list.insert(1, named("b"));
        list.insert(99, named("d"));
        QCOMPARE(names(list), QString("a,b,c,d"));
    }

    void moveWorksInBothDirections() {
        WaypointList list;
        for (const char* name : {"a", "b", "c", "d"}) {
            list.append(named(name));
        }
        list.move(0, 2);
        QCOMPARE(names(list), QString("b,c,a,d"));
        list.move(2, 0);
        QCOMPARE(names(list), QString("a,b,c,d"));
        list.move(3, 1);
        QCOMPARE(names(list), QString("a,d,b,c"));
    }

    void idsAndNamesAreFound() {
        WaypointList list;
        list.append(named("a"));
        list.append(named("b"));
        QCOMPARE(list.indexOf(list.at(1).id), 1);
        QCOMPARE(list.indexOf(QUuid::createUuid()), -1);
        QCOMPARE(list.indexOfName("b"), 1);
        QCOMPARE(list.indexOfName("B"), -1);
        QCOMPARE(list.take(0).name, QString("a"));
        QCOMPARE(list.size(), 1);
    }

    void newNamesAreUnique() {
        WaypointList list;
        QCOMPARE(list.uniqueName("pick"), QString("pick"));
        list.append(named("pick"));
        QCOMPARE(list.uniqueName("pick"), QString("pick 2"));
        list.append(named("pick 2"));
        QCOMPARE(list.uniqueName("pick"), QString("pick 3"));
        QCOMPARE(list.uniqueName("pick 2"), QString("pick 3"));
        QCOMPARE(list.nextName("waypoint"), QString("waypoint 3"));
        list.append(named("waypoint 4"));
        QCOMPARE(list.nextName("waypoint"), QString("waypoint 5"));
    }

    void poseMovesWithItsFrame() {
        FrameList frames;
        const QUuid tray = QUuid::createUuid();
        frames.append({tray, "Tray A", Pose(0.5, 0.1, 0, 0, 0, std::numbers::pi / 2), {}});
        Waypoint point = named("pick");
        point.frame = tray;
        point.pose = Pose(0.1, 0, 0.05, 0, 0, 0);
        const auto pose = poseInBase(point, frames);
        QVERIFY(pose.has_value());
        QVERIFY((pose->position - Eigen::Vector3d(0.5, 0.2, 0.05)).norm() < 1e-12);
        frames.clear();
        QVERIFY(!poseInBase(point, frames).has_value());
        point.frame = QUuid();
        QCOMPARE(*poseInBase(point, frames), point.pose);
    }

    void teachingInAFrameKeepsThePosition() {
        FrameList frames;
        const QUuid tray = QUuid::createUuid();
        frames.append({tray, "Tray A", Pose(0.5, 0.1, 0, 0.2, -0.3, 1.0), {}});
        Waypoint point = named("pick");
        point.frame = tray;
        const Pose live(0.2, -0.4, 0.3, 1.0, 2.0, -0.5);
        const JointPositions q(1, 2, 3, 4, 5, 6);
        const auto taught = taughtAt(point, q, live, Pose(0, 0, 0.1, 0, 0, 0), frames);
        QVERIFY(taught.has_value());
        QCOMPARE(taught->joints, q);
        QCOMPARE(taught->name, QString("pick"));
        const PoseDifference off = poseDifference(*poseInBase(*taught, frames), live);
        QVERIFY(off.distance < 1e-12);
        QVERIFY(off.angle < 1e-12);
        point.frame = QUuid::createUuid();
        QVERIFY(!taughtAt(point, q, live, {}, frames).has_value());
    }

    void differenceIsDistanceAndAngle() {
        const PoseDifference off = poseDifference(Pose(0, 0, 0, 0, 0, 0.1), Pose(0.03, 0.04, 0, 0, 0, -0.2));
        QVERIFY(std::abs(off.distance - 0.05) < 1e-15);
        QVERIFY(std::abs(off.angle - 0.3) < 1e-14);
    }
};

QTEST_GUILESS_MAIN(TestWaypointList)
#include "tst_waypoint_list.moc"
