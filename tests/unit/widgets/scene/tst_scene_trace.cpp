// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include "widgets/scene/scene_trace.h"

using namespace tiller;

class TestSceneTrace : public QObject {
    Q_OBJECT

private:
    double distance(const SceneTrace& trace, const Eigen::Vector3d& place) {
        double nearest = 1e9;
        const auto& points = trace.points();
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Eigen::Vector3d way = points[i].place - points[i - 1].place;
            const double at =
                std::clamp((place - points[i - 1].place).dot(way) / way.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (place - (points[i - 1].place + at * way)).norm());
        }
        return nearest;
    }

private Q_SLOTS:
    void aStraightPathNeedsTwoPoints() {
        SceneTrace trace;
        for (int i = 0; i <= 200; ++i) {
            trace.extend(i * 0.016, Eigen::Vector3d(i * 0.001, 0, 0.3));
        }
        QCOMPARE(trace.points().size(), std::size_t(2));
        QVERIFY(std::abs(trace.points().back().place.x() - 0.2) < 1e-12);
    }

    void aBendIsFollowed() {
        SceneTrace trace;
        std::vector<Eigen::Vector3d> passed;
        for (int i = 0; i <= 2000; ++i) {
            const double angle = i * 0.004;
            passed.emplace_back(0.4 * std::cos(angle), 0.4 * std::sin(angle), 0.1 * std::sin(3 * angle));
            trace.extend(i * 0.016, passed.back());
        }
        QVERIFY2(trace.points().size() < 250, qPrintable(QString::number(trace.points().size())));
        for (const Eigen::Vector3d& place : passed) {
            QVERIFY(distance(trace, place) < 2 * SceneTrace::kTolerance);
        }
    }

    // The arm moves back and forth on one line. The turning point must be kept.
    void aReversalIsACorner() {
        SceneTrace trace;
        double time = 0;
        for (int i = 0; i <= 100; ++i) {
            trace.extend(time += 0.016, Eigen::Vector3d(i * 0.001, 0, 0));
        }
        for (int i = 100; i >= 30; --i) {
            trace.extend(time += 0.016, Eigen::Vector3d(i * 0.001, 0, 0));
        }
        double farthest = 0;
        for (const auto& point : trace.points()) {
            farthest = std::max(farthest, point.place.x());
        }
        QVERIFY(std::abs(farthest - 0.1) < 0.001);
    }

    void trailDisappearsAfterMinutes() {
        SceneTrace trace;
        trace.extend(0, {0, 0, 0});
        trace.extend(1, {0.1, 0, 0});
        trace.extend(2, {0.1, 0.1, 0});
        trace.extend(120, {0.1, 0.1, 0.1});
        QCOMPARE(trace.points().size(), std::size_t(4));
        trace.extend(1.5 + SceneTrace::kSeconds, {0.1, 0.1, 0.1});
        QCOMPARE(trace.points().size(), std::size_t(3));
        trace.extend(500, {0.1, 0.1, 0.1});
        QVERIFY(trace.points().size() <= 1);
    }

    void timeRunningBackwardsRestartsTheTrail() {
        SceneTrace trace;
        trace.extend(50, {0, 0, 0});
        trace.extend(51, {0.1, 0, 0});
        trace.extend(1, {0.5, 0, 0});
        QCOMPARE(trace.points().size(), std::size_t(1));
    }
};

QTEST_GUILESS_MAIN(TestSceneTrace)
#include "tst_scene_trace.moc"
