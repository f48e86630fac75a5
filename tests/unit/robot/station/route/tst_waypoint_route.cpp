// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "robot/station/route/waypoint_route.h"

using namespace tiller;

namespace {

QVector<QUuid> someIds(int count) {
    QVector<QUuid> ids;
    for (int i = 0; i < count; ++i) {
        ids << QUuid::createUuid();
    }
    return ids;
}

using Place = std::optional<int>;

}  // namespace

class TestWaypointRoute : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void startsBeforeTheFirstWaypoint() {
        WaypointRoute route;
        QCOMPARE(route.coming(), Place());
        route.setWaypoints(someIds(3));
        QCOMPARE(route.coming(), Place(0));
        QCOMPARE(route.before(), Place());
        QVERIFY(!route.isUnderWay());
    }

    void continuesToTheLastWaypoint() {
        WaypointRoute route;
        route.setWaypoints(someIds(3));
        for (int place = 0; place < 3; ++place) {
            QCOMPARE(route.coming(), Place(place));
            QVERIFY(!route.isDone());
            route.headOnTo(place);
            QCOMPARE(route.coming(), Place(place));
            route.reach(place);
        }
        QVERIFY(route.isDone());
        QCOMPARE(route.coming(), Place());
        QCOMPARE(route.before(), Place(1));
        route.restartRoute();
        QCOMPARE(route.coming(), Place(0));
        QVERIFY(!route.isDone());
    }

    // Between two waypoints, a step back returns to the last waypoint; at a waypoint, to the previous
    // waypoint.
    void aStepBackReturnsToTheLastWaypoint() {
        WaypointRoute route;
        route.setWaypoints(someIds(4));
        route.reach(1);
        route.headOnTo(2);
        QCOMPARE(route.before(), Place(1));
        route.headBackTo(1);
        QCOMPARE(route.coming(), Place(2));
        QCOMPARE(route.before(), Place(1));
        route.reach(1);
        QCOMPARE(route.coming(), Place(2));
        QCOMPARE(route.before(), Place(0));
        route.headBackTo(0);
        route.reach(0);
        QCOMPARE(route.before(), Place());
        QCOMPARE(route.coming(), Place(1));
    }

    void inALoopTheFirstWaypointFollowsTheLast() {
        WaypointRoute route;
        route.setLoop(true);
        route.setWaypoints(someIds(2));
        route.headOnTo(0);
        QVERIFY2(!route.before(), "there is a previous waypoint before the first one was reached");
        route.reach(0);
        route.headOnTo(1);
        route.reach(1);
        QVERIFY(!route.isDone());
        QCOMPARE(route.coming(), Place(0));
        route.headOnTo(0);
        QCOMPARE(route.before(), Place(1));
    }

    void enablingTheLoopAtTheEndContinues() {
        WaypointRoute route;
        route.setWaypoints(someIds(2));
        route.reach(0);
        route.reach(1);
        QVERIFY(route.isDone());
        route.setLoop(true);
        QCOMPARE(route.coming(), Place(0));
        QVERIFY(!route.isDone());
    }

    void anEditKeepsTheNextWaypoint() {
        WaypointRoute route;
        QVector<QUuid> ids = someIds(4);
        route.setWaypoints(ids);
        route.reach(1);
        route.headOnTo(2);
        const QUuid coming = ids.at(2);
        ids.insert(0, QUuid::createUuid());
        ids.removeLast();
        route.follow(ids);
        QCOMPARE(route.at(*route.coming()), coming);
        QCOMPARE(route.before(), Place(2));
        ids.removeOne(coming);
        route.follow(ids);
        QVERIFY2(!route.isUnderWay(), "the route is still running without its next waypoint");
        QCOMPARE(route.coming(), Place(0));
    }
};

QTEST_APPLESS_MAIN(TestWaypointRoute)
#include "tst_waypoint_route.moc"
