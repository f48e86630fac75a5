// SPDX-License-Identifier: MIT
//
// A client with the start-up, sockets and expectations of Universal Robots' C++ client library, and a control
// script with its features, against the simulated controller.

#include <QTest>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/integration/clients/socket_client.h"

using namespace tiller;
using namespace tiller::test;
using Client = SocketClient;
using Point = SocketClient::Point;

namespace {

constexpr double kDt = 0.002;
const Six kStart{-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310};

double largest(const Six& a, const Six& b) {
    double worst = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        worst = std::max(worst, std::abs(a[i] - b[i]));
    }
    return worst;
}

Six plus(Six six, std::size_t index, double by) {
    six[index] += by;
    return six;
}

Point jointPoint(const Six& q, double a = 1.4, double v = 1.05, double t = 0, double r = 0) {
    Point p;
    p.target = q;
    p.third = {v, a, 0, 0, 0, 0};
    p.duration = t;
    p.blend = r;
    return p;
}

Point toolPoint(int type, const Six& pose, double r = 0) {
    Point p = jointPoint(pose, 1.2, 0.25, 0, r);
    p.type = type;
    return p;
}

/// Position of a spline segment and of its end, by joint: Hermite, cubic or quintic.
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

class TestSocketClient : public QObject {
    Q_OBJECT

    std::unique_ptr<VirtualRobot> robot_;
    std::unique_ptr<Client> client_;

    Six pose() const { return client_->data().actualPose; }
    bool moving() const { return robot_->controller.truth().qd.values.norm() > 3e-3; }
    bool keepIdle(int ticks = 1) {
        for (int n = 0; n < ticks; ++n) {
            if (!client_->writeRaw({}, Client::kIdle, 1000)) {
                return false;
            }
            client_->step();
        }
        return true;
    }

private Q_SLOTS:
    void init() {
        auto options = VirtualRobot::options();
        options.software = {5, 25, 0, 1254000};  // from 5.23 on the script uses direct_torque
        robot_ = std::make_unique<VirtualRobot>(options);
        client_ = std::make_unique<Client>(*robot_);
        QVERIFY2(client_->connect("\twrite_output_integer_register(5, 77)\n\tsleep(0.1)"), client_->trouble);
        QCOMPARE(client_->data().runtime, 2U);
        QVERIFY(client_->until([this] { return !client_->news().keys.empty(); }, 1));
        QCOMPARE(client_->news().keys.back(), QByteArray("PROGRAM_XXX_STARTED socket_control"));
    }
    void cleanup() {
        QCOMPARE(client_->news().malformed, QByteArray());
        client_.reset();
        robot_.reset();
    }

    void stoppedLeavesTheLoopAndWhatFollowsRuns() {
        QVERIFY(keepIdle(20));
        QVERIFY(client_->writeRaw({}, Client::kStopped, 100));
        QVERIFY(client_->until([this] { return !client_->isReverseConnected(); }, 1));
        QCOMPARE(client_->data().runtime, 2U);  // the statements behind the loop
        QVERIFY(client_->until([this] { return client_->data().runtime == 1; }, 1));
        QVERIFY(client_->until([this] { return client_->news().keys.size() >= 2; }, 1));
        QCOMPARE(client_->news().keys.back(), QByteArray("PROGRAM_XXX_STOPPED socket_control"));
        QVERIFY(client_->news().exceptions.empty());
    }

    void aSilentClientEndsTheProgram() {
        QVERIFY(client_->write(kStart, Client::kServoJ, 200));
        client_->step(95);
        QVERIFY(client_->isReverseConnected());
        QVERIFY(client_->until([this] { return !client_->isReverseConnected(); }, 0.3));
        QVERIFY(client_->until([this] { return client_->data().runtime == 1; }, 1));
    }

    void servoFollowsAndRefusesJumps() {
        Six q = kStart;
        for (int n = 0; n < 500; ++n) {
            q[0] = kStart[0] + 0.1 * (1 - std::cos(M_PI * n * kDt));
            QVERIFY(client_->write(q, Client::kServoJ));
            client_->step();
        }
        QVERIFY(client_->until(
            [&] { return client_->write(q, Client::kServoJ) && largest(client_->data().actualQ, q) < 1e-3; },
            2));
        const Six before = client_->data().actualQ;
        for (int n = 0; n < 50; ++n) {
            QVERIFY(client_->write(plus(q, 5, 2.5), Client::kServoJ));
            client_->step();
        }
        QVERIFY(largest(client_->data().actualQ, before) < 1e-3);
        // Poses, solved near the last setpoint.
        Six goal = pose();
        for (int n = 0; n < 250; ++n) {
            goal[2] += 0.0001;
            QVERIFY(client_->write(goal, Client::kPose));
            client_->step();
        }
        QVERIFY(client_->until(
            [&] { return client_->write(goal, Client::kPose) && std::abs(pose()[2] - goal[2]) < 1e-3; }, 2));
    }

    void speedModesReachTheirSpeedAndChangeOver() {
        const auto stream = [this](const Six& values, Client::Mode mode, int ticks) {
            for (int n = 0; n < ticks; ++n) {
                if (!client_->write(values, mode)) {
                    return false;
                }
                client_->step();
            }
            return true;
        };
        QVERIFY(stream({0.2, 0, 0, 0, 0, 0.3}, Client::kSpeedJ, 100));
        QVERIFY(std::abs(robot_->controller.truth().qd[0] - 0.2) < 2e-3);
        QVERIFY(std::abs(robot_->controller.truth().qd[5] - 0.3) < 2e-3);
        QVERIFY(stream({0, 0, 0.05, 0, 0, 0}, Client::kSpeedL, 200));
        QVERIFY(std::abs(robot_->controller.truth().tcpSpeed.linear.z() - 0.05) < 2e-3);
        QVERIFY(keepIdle(200));
        QVERIFY(!moving());
    }

    void torqueModeTurnsAJointAndHoldsTheOthers() {
        for (int n = 0; n < 200; ++n) {
            QVERIFY(client_->write({0, 0, 0, 0, 0, 0.6}, Client::kTorque));
            client_->step();
        }
        QVERIFY(robot_->controller.truth().q[5] > kStart[5] + 0.01);
        QVERIFY(std::abs(robot_->controller.truth().q[1] - kStart[1]) < 5e-3);
        QVERIFY(keepIdle(300));
        QVERIFY(!moving());
    }

    void freedriveIsStartedRepeatedAndEnded() {
        for (int n = 0; n < 5; ++n) {
            QVERIFY(client_->writeRaw({1, 0, 0, 0, 0, 0}, Client::kFreedrive));
            client_->step();
        }
        robot_->controller.pressHand({{0, 0, 25}, {0, 0, 0}});
        const double z = pose()[2];
        QVERIFY(client_->until(
            [&] {
                return client_->writeRaw({0, 0, 0, 0, 0, 0}, Client::kFreedrive) && pose()[2] > z + 0.03;
            },
            5));
        robot_->controller.pressHand({});
        QVERIFY(client_->writeRaw({-1, 0, 0, 0, 0, 0}, Client::kFreedrive));
        QVERIFY(keepIdle(500));
        QVERIFY(!moving());
    }

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

    void aTrajectoryLastsAsLongAsItIsTold() {
        const double before = client_->data().timestamp;
        QVERIFY(client_->startTrajectory({jointPoint(plus(kStart, 0, 0.5), 1.4, 1.05, 3.0)}));
        QCOMPARE(client_->trajectoryResult(10).value_or(-1), 0);
        const double lasted = client_->data().timestamp - before;
        QVERIFY2(lasted >= 3.0 && lasted < 3.1, qPrintable(QString::number(lasted)));
    }

    void aCancelStopsAndDrains() {
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

    void commandsTakeEffectWhileTheArmServos() {
        const auto servo = [this](int ticks) {
            for (int n = 0; n < ticks; ++n) {
                if (!client_->write(kStart, Client::kServoJ)) {
                    return false;
                }
                client_->step();
            }
            return true;
        };
        QVERIFY(servo(5));
        QVERIFY(client_->writeCommand(10, {0.01, 0.02, 0.15, 0, 0, 0.5}));
        QVERIFY(servo(10));
        QVERIFY(largest(client_->data().tcpOffset, {0.01, 0.02, 0.15, 0, 0, 0.5}) < 1e-9);
        QVERIFY(client_->writeCommand(1, {1.5, 0.01, 0, 0.05}));
        QVERIFY(servo(10));
        QCOMPARE(client_->data().payload, 1.5);
        QVERIFY(client_->writeCommand(12, {2.5, 0, 0, 0.05, 0.01, 0.01, 0.01, 0, 0, 0, 0.1}));
        QVERIFY(servo(25));
        QVERIFY(client_->data().payload > 1.6 && client_->data().payload < 2.4);  // on the way
        QVERIFY(servo(50));
        QCOMPARE(client_->data().payload, 2.5);
        QVERIFY(client_->writeCommand(2, {24}));
        QVERIFY(client_->writeCommand(9, {0, 0, 9.81}));
        QVERIFY(client_->writeCommand(7, {0}, true));
        QVERIFY(client_->writeCommand(11, std::vector<double>(12, 0.5)));
        QVERIFY(client_->writeCommand(0, {}));
        QVERIFY(servo(20));
        QCOMPARE(client_->data().toolVoltage, 24);
        QVERIFY(std::abs(client_->data().force[2]) < 2);
        QVERIFY(client_->isReverseConnected());
        QVERIFY(client_->news().exceptions.empty());
    }

    void forceModeRunsBesideATrajectory() {
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

    void aToolContactStopsTheMotionAndIsTold() {
        const double z = pose()[2];
        robot_->controller.changeWorld([z](simulator::arm::Environment& world) {
            world.addPlane({.point = {0, 0, z - 0.02}});
        });
        QVERIFY(client_->writeCommand(5, {}));
        std::optional<int> reply;
        for (int n = 0; n < 1500 && !reply; ++n) {
            QVERIFY(client_->write({0, 0, -0.04, 0, 0, 0}, Client::kSpeedL));
            reply = client_->commandReply(kDt);
        }
        QCOMPARE(reply.value_or(-1), 0);
        QVERIFY(keepIdle(20));
        QVERIFY(!moving());
        QVERIFY(std::abs(pose()[2] - (z - 0.02)) < 2e-3);
    }

    void aToolContactThatIsEndedIsCanceled() {
        QVERIFY(client_->writeCommand(5, {}));
        QVERIFY(keepIdle(20));
        QVERIFY(client_->writeCommand(6, {}));
        QCOMPARE(client_->commandReply(1).value_or(-1), 1);
    }

    void aProtectiveStopEndsTheScriptWhichIsSentAgain() {
        client_->news() = {};
        client_->sendScript("sec stop():\n  protective_stop()\nend\n");
        QVERIFY(client_->until([this] { return !client_->isReverseConnected(); }, 1));
        QVERIFY(client_->until([this] { return client_->data().runtime == 1; }, 1));
        QVERIFY(client_->until([this] { return !client_->news().keys.empty(); }, 1));
        QCOMPARE(client_->news().keys.back(), QByteArray("PROGRAM_XXX_STOPPED socket_control"));
        client_->step(2600);
        client_->sendScript("set unlock protective stop\n");
        QVERIFY(client_->until([this] { return !client_->news().protectiveStopped; }, 5));
        QCOMPARE(client_->data().runtime, 1U);
        client_ = std::make_unique<Client>(*robot_);
        QVERIFY2(client_->connect({}), client_->trouble);
        QVERIFY(client_->writeCommand(10, {0.01, 0.02, 0.15, 0, 0, 0.5}));
        QVERIFY(keepIdle(10));
        QVERIFY(largest(client_->data().tcpOffset, {0.01, 0.02, 0.15, 0, 0, 0.5}) < 1e-9);
    }

    void aStopSettlesBeforeTheResultIsTold() {
        // 1.6 rad at 3.4 rad/s2 take 1.372 s; a client of others takes a result before 1.4 s for a failure.
        QVERIFY(client_->startTrajectory({jointPoint({-1.57, -1.6, 1.6, -0.7, 0.7, 0.2}, 3.4, 3.1)}));
        QCOMPARE(client_->trajectoryResult(10).value_or(-1), 0);
        const double before = client_->data().timestamp;
        QVERIFY(client_->startTrajectory({jointPoint({-1.57, -1.57, 0, 0, 0, 0}, 3.4, 3.1)}));
        QCOMPARE(client_->trajectoryResult(10).value_or(-1), 0);
        const double lasted = client_->data().timestamp - before;
        QVERIFY2(lasted > 1.4 && lasted < 1.5, qPrintable(QString::number(lasted)));
    }

    void aStandingArmReportsTheSamePositionAgain() {
        QVERIFY(keepIdle(300));
        const Six q = client_->data().actualQ;
        const Six pose = client_->data().actualPose;
        for (int n = 0; n < 50; ++n) {
            QVERIFY(keepIdle(1));
            QCOMPARE(client_->data().actualQ, q);
            QCOMPARE(client_->data().actualPose, pose);
        }
    }

    void scriptsAreJudgedByTheirMessages() {
        const auto run = [this](const QByteArray& text) {
            client_->news() = {};
            client_->sendScript(text + '\n');
            return client_->until([this] { return client_->news().keys.size() >= 3; }, 20);
        };
        // It replaces the control script: STOPPED of that one, STARTED, STOPPED.
        QVERIFY(run("def short():\n  movej([-1.6,-1.72,-2.2,-0.8,1.59,-0.03])\nend"));
        QCOMPARE(client_->news().keys[1], QByteArray("PROGRAM_XXX_STARTED short"));
        QCOMPARE(client_->news().keys[2], QByteArray("PROGRAM_XXX_STOPPED short"));
        QVERIFY(client_->news().errorCodes.empty() && client_->news().exceptions.empty());
    }

    void unknownNamesAreToldWithoutAStart() {
        client_->news() = {};
        client_->sendScript("def broken():\n  no_such_function(1)\nend\n");
        QVERIFY(client_->until([this] { return !client_->news().exceptions.empty(); }, 1));
        QCOMPARE(client_->news().exceptions[0], QByteArray("compile_error_name_not_found:no_such_function:"));
        QVERIFY(client_->news().keys.empty());
    }

    void unreachableTargetsAreToldApart() {
        client_->news() = {};
        client_->sendScript("def far():\n  movej(p[10,0,0,0,0,0])\nend\n");
        QVERIFY(client_->until([this] { return !client_->news().exceptions.empty(); }, 2));
        QVERIFY(client_->until([this] { return client_->data().runtime == 1; }, 2));
        client_->news() = {};
        client_->sendScript("def far():\n  movel(p[10,0,0,0,0,0])\nend\n");
        QVERIFY(client_->until([this] { return client_->news().protectiveStopped; }, 2));
        QCOMPARE(client_->news().errorLevels, std::vector<int>{2});
        QCOMPARE(client_->news().safetyModes, std::vector<int>{3});
        client_->step(2600);
        client_->sendScript("set unlock protective stop\n");
        QVERIFY(client_->until([this] { return !client_->news().protectiveStopped; }, 5));
        client_->news() = {};
        client_->sendScript("def again():\n  movej([-1.6,-1.72,-2.2,-0.8,1.59,-0.03])\nend\n");
        QVERIFY(client_->until(
            [this] {
                return !client_->news().keys.empty() && client_->news().keys.back().endsWith("STOPPED again");
            },
            20));
        QVERIFY(client_->news().exceptions.empty());
    }

    void aProtectiveStopByProgramIsToldOnce_data() {
        QTest::addColumn<QByteArray>("program");
        QTest::newRow("def") << QByteArray("def halt_here():\n  protective_stop()\nend\n");
        QTest::newRow("sec") << QByteArray("sec halt_here():\n  protective_stop()\nend\n");
    }
    void aProtectiveStopByProgramIsToldOnce() {
        QFETCH(QByteArray, program);
        client_->news() = {};
        client_->sendScript(program);
        QVERIFY(client_->until([this] { return client_->news().protectiveStopped; }, 2));
        client_->step(500);
        QCOMPARE(client_->news().errorCodes, std::vector<qint32>{209});
        QCOMPARE(client_->news().errorLevels, std::vector<int>{2});
        if (program.startsWith("def")) {
            QVERIFY(client_->news().keys.back().endsWith("STOPPED halt_here"));
        }
    }
};

QTEST_GUILESS_MAIN(TestSocketClient)
#include "tst_socket_client.moc"
