// SPDX-License-Identifier: MIT
//
// Trajectories as sent by Universal Robots' C++ client library: moves of all types, blends, splines and their
// results, and force mode in parallel.

#include <QTest>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/integration/clients/socket_client_test.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Returns the position of one joint on a spline segment (cubic or quintic Hermite) at a normalized time s.
double hermite(double s, double q0, double q1, double v0, double v1, double T, bool quintic) {
    const double b0 = v0 * T;
    const double b1 = v1 * T;
    if (quintic) {
        const double d = q1 - q0;
        return q0 + b0 * s + (10 * d - 6 * b0 - 4 * b1) * std::pow(s, 3) +
               (-15 * d + 8 * b0 + 7 * b1) * std::pow(s, 4) + (6 * d - 3 * b0 - 3 * b1) * std::pow(s, 5);
    }
    return q0 + b0 * s + (3 * (q1 - q0) - 2 * b0 - b1) * s * s + (2 * (q0 - q1) + b0 + b1) * s * s * s;
}

}  // namespace

class TestSocketTrajectories : public SocketClientTest {
    Q_OBJECT

private Q_SLOTS:
    void trajectoriesOfEveryKindSucceed() {
        const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
        const Six q0{-1.57, -1.6, 1.6, -0.7, 0.7, 0.2};
        const Six a{-0.203, 0.263, 0.559, 0.68, -1.083, -2.076};
        const Six b{-0.203, 0.463, 0.559, 0.68, -1.083, -2.076};
        const Six c{-0.203, 0.363, 0.759, 0.68, -1.083, -2.076};
        const Six d{-0.209, 0.492, 0.5522, 0.928, -1.134, -2.168};
        const Six via{-0.209, 0.487, 0.671, 1.026, -0.891, -2.337};
        const Six e{-0.209, 0.425, 0.841, 1.16, -0.477, -2.553};
        Point arc = toolPoint(3, e);
        arc.second = via;
        Point near = toolPoint(6, b);
        near.third = {1.05, 1.4, 1, 0, 0, 0};
        std::vector<Point> points{jointPoint(plus(kStart, 0, 0.1)),
                                  jointPoint(q0, 3.4, 3.1),
                                  toolPoint(1, a),
                                  toolPoint(1, b),
                                  toolPoint(2, c),
                                  toolPoint(2, d),
                                  arc};
        const auto solution = kinematics::inverseNearest(dh, Pose::fromArray(b), Pose(), JointPositions(q0));
        QVERIFY(solution.has_value());
        for (std::size_t j = 0; j < 6; ++j) {
            near.second[j] = (*solution)[static_cast<int>(j)];
        }
        points.push_back(near);
        Point fast = jointPoint(q0, 0.5, 0.5);
        fast.type = 4;
        points.push_back(fast);
        Point straight = toolPoint(5, a);
        straight.third = {0.5, 0.5, 0, 0, 0, 0};
        points.push_back(straight);
        QVERIFY(client_->startTrajectory(points));
        QCOMPARE(client_->trajectoryResult(60).value_or(-1), 0);
        QVERIFY(largest(client_->data().actualPose, a) < 1e-3);
        QVERIFY(client_->news().exceptions.empty());
        QVERIFY(client_->news().errorCodes.empty());
    }

    void aTrajectoryOfBlendsKeepsMoving() {
        std::vector<Point> points;
        Six target = client_->data().actualPose;
        for (int n = 0; n < 6; ++n) {
            target = plus(target, n % 2 == 0 ? 2 : 0, n % 2 == 0 ? 0.08 : -0.08);
            points.push_back(toolPoint(1, target, 0.03));
        }
        QVERIFY(client_->startTrajectory(points));
        QVERIFY(client_->until([this] { return moving(); }, 1));
        int standing = 0;
        while (largest(client_->data().actualPose, target) > 0.01 && standing < 5) {
            client_->step();
            standing = moving() ? 0 : standing + 1;
        }
        QCOMPARE(standing, 0);
        QCOMPARE(client_->trajectoryResult(5).value_or(-1), 0);
        QVERIFY(largest(client_->data().actualPose, target) < 1e-3);
    }

    void trajectoryTakesTheGivenTime() {
        const double before = client_->data().timestamp;
        QVERIFY(client_->startTrajectory({jointPoint(plus(kStart, 0, 0.5), 1.4, 1.05, 3.0)}));
        QCOMPARE(client_->trajectoryResult(10).value_or(-1), 0);
        const double lasted = client_->data().timestamp - before;
        QVERIFY2(lasted >= 3.0 && lasted < 3.1, qPrintable(QString::number(lasted)));
    }

    void cancellingStopsAndDrainsTheQueue() {
        std::vector<Point> points(200, jointPoint(plus(kStart, 0, 1.0)));
        for (std::size_t i = 1; i < points.size(); i += 2) {
            points[i].target[0] = kStart[0];
        }
        QVERIFY(client_->startTrajectory(points));
        client_->step(300);
        QVERIFY(moving());
        QVERIFY(client_->writeRaw({-1, 0, 0, 0, 0, 0}, Client::kForward, 0));
        QCOMPARE(client_->trajectoryResult(5).value_or(-1), 1);
        client_->step(20);
        QVERIFY(!moving());
        QVERIFY(client_->isReverseConnected());
    }

    void anUnderrunFails() {
        QVERIFY(client_->writeRaw({1, 3, 0, 0, 0, 0}, Client::kForward, 0));
        QVERIFY(client_->writePoint(jointPoint(plus(kStart, 0, 0.1))));
        QCOMPARE(client_->trajectoryResult(5).value_or(-1), 2);
    }

    void anInfeasibleTargetEndsTheProgram() {
        QVERIFY(client_->startTrajectory({jointPoint(plus(kStart, 2, -123))}));
        QVERIFY(client_->until([this] { return client_->data().runtime == 1; }, 5));
        QVERIFY(client_->until([this] { return !client_->news().exceptions.empty(); }, 1));
        QVERIFY(!client_->trajectoryResult(0.5).has_value());
    }

    void splinesFollowTheirCurve_data() {
        QTest::addColumn<bool>("quintic");
        QTest::addColumn<double>("slider");
        QTest::newRow("cubic") << false << 1.0;
        QTest::newRow("quintic") << true << 1.0;
        QTest::newRow("cubic, slowly") << false << 0.25;
        QTest::newRow("quintic, slowly") << true << 0.4;
    }
    void splinesFollowTheirCurve() {
        QFETCH(bool, quintic);
        QFETCH(double, slider);
        robot_->controller.setSpeedSlider(slider);
        client_->step(2);
        constexpr double kSegment = 0.5;
        const std::array<double, 4> positions{0.0, 0.2, -0.1, 0.15};
        const std::array<double, 4> speeds{0.0, 0.1, -0.2, 0.0};
        std::vector<Point> points;
        const Six from = client_->data().targetQ;
        for (std::size_t i = 1; i < positions.size(); ++i) {
            Point p;
            p.target = plus(plus(from, 0, positions[i]), 4, 0.5 * positions[i]);
            p.second = {speeds[i], 0, 0, 0, 0.5 * speeds[i], 0};
            p.duration = kSegment;
            p.blend = quintic ? 2 : 1;
            p.type = 51;
            points.push_back(p);
        }
        QVERIFY(client_->startTrajectory(points));
        QVERIFY(client_->until([&] { return largest(client_->data().targetQ, from) > 0; }, 1));
        const double begin = client_->data().timestamp - kDt;
        double worst = 0;
        for (double t = 0; t < 3 * kSegment;) {
            const auto i = std::min<std::size_t>(2, static_cast<std::size_t>(t / kSegment));
            const double s = t / kSegment - static_cast<double>(i);
            const double wanted =
                hermite(s, positions[i], positions[i + 1], speeds[i], speeds[i + 1], kSegment, quintic);
            worst = std::max({worst, std::abs(client_->data().targetQ[0] - from[0] - wanted),
                              std::abs(client_->data().targetQ[4] - from[4] - 0.5 * wanted)});
            client_->step();
            t = (client_->data().timestamp - begin) * slider;
        }
        QVERIFY2(worst < 0.02, qPrintable(QString::number(worst)));
        QCOMPARE(client_->trajectoryResult(5).value_or(-1), 0);
        QVERIFY(largest(client_->data().targetQ, points.back().target) < 5e-3);
    }

    void hundredsOfPointsAreQueued() {
        std::vector<Point> points;
        for (int n = 1; n <= 600; ++n) {
            Point p;
            p.target = plus(kStart, 0, 0.2 * (1 - std::cos(n * M_PI / 300)));
            p.second = {0.2 * M_PI / 300 / 0.01 * std::sin(n * M_PI / 300), 0, 0, 0, 0, 0};
            p.duration = 0.01;
            p.blend = 1;
            p.type = 51;
            points.push_back(p);
        }
        QVERIFY(client_->startTrajectory(points));
        QCOMPARE(client_->trajectoryResult(20).value_or(-1), 0);
        QVERIFY(largest(client_->data().targetQ, kStart) < 5e-3);
    }

    void forceModeRunsDuringATrajectory() {
        const double z = pose()[2];
        robot_->controller.changeWorld([z](simulator::arm::Environment& world) {
            world.addPlane({.point = {0, 0, z - 0.005}});
        });
        QVERIFY(client_->writeCommand(0, {}));
        QVERIFY(client_->writeCommand(3, {0,   0, 0, 0, 0, 0,   0,   0,   1,   0,   0,   0,     0,  0,
                                          -10, 0, 0, 0, 2, 0.1, 0.1, 0.1, 0.2, 0.2, 0.2, 0.025, 0.5}));
        QVERIFY(keepIdle(1500));
        QVERIFY2(std::abs(client_->data().force[2] - 10) < 1,
                 qPrintable(QString::number(client_->data().force[2])));
        Six goal = pose();
        goal[0] -= 0.05;
        QVERIFY(client_->startTrajectory({toolPoint(1, goal)}));
        QCOMPARE(client_->trajectoryResult(10).value_or(-1), 0);
        QVERIFY(std::abs(client_->data().force[2] - 10) < 1);
        QVERIFY(std::abs(pose()[0] - goal[0]) < 2e-3);
        QVERIFY(client_->writeCommand(4, {}));
        QVERIFY(keepIdle(50));
        QVERIFY(!moving());
    }

    void standstillIsReachedBeforeTheResultIsReported() {
        // 1.6 rad at 3.4 rad/s2 takes 1.372 s. Another client treats a result before 1.4 s as a failure.
        QVERIFY(client_->startTrajectory({jointPoint({-1.57, -1.6, 1.6, -0.7, 0.7, 0.2}, 3.4, 3.1)}));
        QCOMPARE(client_->trajectoryResult(10).value_or(-1), 0);
        const double before = client_->data().timestamp;
        QVERIFY(client_->startTrajectory({jointPoint({-1.57, -1.57, 0, 0, 0, 0}, 3.4, 3.1)}));
        QCOMPARE(client_->trajectoryResult(10).value_or(-1), 0);
        const double lasted = client_->data().timestamp - before;
        QVERIFY2(lasted > 1.4 && lasted < 1.5, qPrintable(QString::number(lasted)));
    }
};

QTEST_GUILESS_MAIN(TestSocketTrajectories)
#include "tst_socket_trajectories.moc"
