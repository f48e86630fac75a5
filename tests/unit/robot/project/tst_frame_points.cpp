// SPDX-License-Identifier: MIT
//
// Three points and the resulting frame; also points that do not define a frame.

#include <QTest>
#include <limits>
#include <random>

#include "robot/project/frame_points.h"
#include "robot/project/waypoint_list.h"

using namespace tiller;
using namespace tiller::project;
using Problem = FramePointsCheck::Problem;
using Eigen::Vector3d;

Q_DECLARE_METATYPE(Eigen::Vector3d)

class TestFramePoints : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void threePointsDefineAFrame() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> any(-1, 1);
        for (int n = 0; n < 200; ++n) {
            const Pose pose(any(random), any(random), any(random), 1.7 * any(random), 1.7 * any(random),
                            1.7 * any(random));
            const Eigen::Isometry3d T = pose.transform();
            const double along = 0.03 + std::abs(any(random));
            const double side = 0.015 + std::abs(any(random));
            // The third point may be anywhere on the +Y side.
            const FramePoints points{T * Vector3d::Zero(), T * Vector3d(along, 0, 0),
                                     T * Vector3d(any(random) > 0 ? 0.05 : -0.05, side, 0)};
            const std::optional<Pose> made = frameThrough(points);
            QVERIFY(made.has_value());
            const PoseDifference off = poseDifference(*made, pose);
            QVERIFY2(off.distance < 1e-12 && off.angle < 1e-7, qPrintable(QString::number(off.angle)));
            const Eigen::Matrix3d R = rotationMatrix(made->rotation);
            QVERIFY(std::abs(R.determinant() - 1) < 1e-12);
            QVERIFY(R.col(0).dot(*points.onX - *points.origin) > 0);
            QVERIFY(R.col(1).dot(*points.towardsY - *points.origin) > 0);
        }
    }

    void degeneratePointsAreRefused_data() {
        QTest::addColumn<Vector3d>("onX");
        QTest::addColumn<Vector3d>("towardsY");
        QTest::addColumn<int>("problem");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("good") << Vector3d(0.1, 0, 0) << Vector3d(0, 0.1, 0) << int(Problem::None);
        QTest::newRow("X on the origin")
            << Vector3d(0, 0, 0) << Vector3d(0, 0.1, 0) << int(Problem::XTooClose);
        QTest::newRow("X too close") << Vector3d(0.0199, 0, 0) << Vector3d(0, 0.1, 0)
                                     << int(Problem::XTooClose);
        QTest::newRow("X just far enough")
            << Vector3d(0.0201, 0, 0) << Vector3d(0, 0.1, 0) << int(Problem::None);
        QTest::newRow("Y on the origin")
            << Vector3d(0.1, 0, 0) << Vector3d(0, 0, 0) << int(Problem::YTooClose);
        QTest::newRow("Y on X") << Vector3d(0.1, 0, 0) << Vector3d(0.1, 0, 0) << int(Problem::InLine);
        QTest::newRow("in a line") << Vector3d(0.1, 0, 0) << Vector3d(0.3, 0.0099, 0) << int(Problem::InLine);
        QTest::newRow("in a line behind")
            << Vector3d(0.1, 0, 0) << Vector3d(-0.3, 0, 0.0099) << int(Problem::InLine);
        QTest::newRow("beside the line")
            << Vector3d(0.1, 0, 0) << Vector3d(0.3, 0.0101, 0) << int(Problem::None);
        QTest::newRow("no number") << Vector3d(nan, 0, 0) << Vector3d(0, 0.1, 0) << int(Problem::NotFinite);
    }
    void degeneratePointsAreRefused() {
        QFETCH(Vector3d, onX);
        QFETCH(Vector3d, towardsY);
        QFETCH(int, problem);
        const Vector3d origin(0.3, -0.2, 0.4);
        const FramePoints points{origin, origin + onX, origin + towardsY};
        QCOMPARE(int(check(points).problem), problem);
        QCOMPARE(frameThrough(points).has_value(), problem == int(Problem::None));
    }

    void incompletePointsAreReported() {
        FramePoints points;
        QVERIFY(check(points).problem == Problem::Incomplete);
        points.origin = Vector3d(0.1, 0.2, 0.3);
        points.onX = Vector3d(0.2, 0.2, 0.3);
        QVERIFY(check(points).problem == Problem::Incomplete);
        QVERIFY(!frameThrough(points).has_value());
        QVERIFY(std::abs(check(points).alongX - 0.1) < 1e-12);
        points.onX = Vector3d(0.11, 0.2, 0.3);  // reported even without the third point
        QVERIFY(check(points).problem == Problem::XTooClose);
    }

    void aWaypointKeepsItsPositionInAnotherFrame() {
        FrameList frames;
        Frame tray{QUuid::createUuid(), "tray", Pose(0.4, -0.1, 0.2, 0.1, -0.3, 1.2), {}};
        frames.append(tray);
        Waypoint point;
        point.priority = TargetKind::Pose;
        point.pose = Pose(0.5, 0.2, 0.3, 0, 3.1, 0);
        const Waypoint inTray = *givenIn(point, tray.id, frames);
        QVERIFY(movesWith(inTray, tray.id) && !movesWith(point, tray.id));
        const PoseDifference off = poseDifference(*poseInBase(inTray, frames), point.pose);
        QVERIFY(off.distance < 1e-12 && off.angle < 1e-7);
        QVERIFY(!givenIn(point, QUuid::createUuid(), frames).has_value());
    }

    void framesAreNamedAndOrdered() {
        FrameList frames;
        QCOMPARE(frames.nextName("frame"), QString("frame 1"));
        for (const char* name : {"frame 1", "tray", "table"}) {
            frames.append({QUuid::createUuid(), name, {}, {}});
        }
        QCOMPARE(frames.nextName("frame"), QString("frame 4"));
        QCOMPARE(frames.uniqueName("tray"), QString("tray 2"));
        frames.insert(1, {QUuid::createUuid(), "rack", {}, {}});
        QCOMPARE(frames.at(1).name, QString("rack"));
        frames.remove(0);
        QCOMPARE(frames.size(), std::size_t(3));
        QCOMPARE(frames.at(0).name, QString("rack"));
        frames.remove(17);
        QCOMPARE(frames.size(), std::size_t(3));
    }
};

QTEST_GUILESS_MAIN(TestFramePoints)
#include "tst_frame_points.moc"
