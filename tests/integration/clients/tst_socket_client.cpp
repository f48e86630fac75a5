// SPDX-License-Identifier: MIT
//
// Tests a client with the start-up, sockets and expectations of Universal Robots' C++ client library, and a
// control script with the features of the library's script. Both are run with the simulated controller:
// streams, commands, scripts and their messages.

#include <QTest>
#include <cmath>

#include "tests/integration/clients/socket_client_test.h"

using namespace tiller;
using namespace tiller::test;

class TestSocketClient : public SocketClientTest {
    Q_OBJECT

private Q_SLOTS:
    void stoppedEndsTheLoopAndTheProgramContinues() {
        QVERIFY(keepIdle(20));
        QVERIFY(client_->writeRaw({}, Client::kStopped, 100));
        QVERIFY(client_->until([this] { return !client_->isReverseConnected(); }, 1));
        QCOMPARE(client_->data().runtime, 2U);  // the statements after the loop are running
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
        // Sends poses. The solution nearest to the last setpoint is used.
        Six goal = pose();
        for (int n = 0; n < 250; ++n) {
            goal[2] += 0.0001;
            QVERIFY(client_->write(goal, Client::kPose));
            client_->step();
        }
        QVERIFY(client_->until(
            [&] { return client_->write(goal, Client::kPose) && std::abs(pose()[2] - goal[2]) < 1e-3; }, 2));
    }

    void speedModesReachTheirSpeedAndSwitch() {
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
        QVERIFY(client_->data().payload > 1.6 && client_->data().payload < 2.4);  // during the transition
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

    void toolContactStopsTheMotionAndIsReported() {
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

    void endingToolContactReportsCanceled() {
        QVERIFY(client_->writeCommand(5, {}));
        QVERIFY(keepIdle(20));
        QVERIFY(client_->writeCommand(6, {}));
        QCOMPARE(client_->commandReply(1).value_or(-1), 1);
    }

    void theScriptIsResentAfterAProtectiveStop() {
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

    void anArmAtStandstillRepeatsTheSamePosition() {
        QVERIFY(keepIdle(300));
        const Six q = client_->data().actualQ;
        const Six pose = client_->data().actualPose;
        for (int n = 0; n < 50; ++n) {
            QVERIFY(keepIdle(1));
            QCOMPARE(client_->data().actualQ, q);
            QCOMPARE(client_->data().actualPose, pose);
        }
    }

    void scriptResultsFollowFromTheirMessages() {
        const auto run = [this](const QByteArray& text) {
            client_->news() = {};
            client_->sendScript(text + '\n');
            return client_->until([this] { return client_->news().keys.size() >= 3; }, 20);
        };
        // The program replaces the control script, which results in STOPPED of the control script, then
        // STARTED and STOPPED of the program.
        QVERIFY(run("def short():\n  movej([-1.6,-1.72,-2.2,-0.8,1.59,-0.03])\nend"));
        QCOMPARE(client_->news().keys[1], QByteArray("PROGRAM_XXX_STARTED short"));
        QCOMPARE(client_->news().keys[2], QByteArray("PROGRAM_XXX_STOPPED short"));
        QVERIFY(client_->news().errorCodes.empty() && client_->news().exceptions.empty());
    }

    void unknownNamesAreReportedWithoutAStart() {
        client_->news() = {};
        client_->sendScript("def broken():\n  no_such_function(1)\nend\n");
        QVERIFY(client_->until([this] { return !client_->news().exceptions.empty(); }, 1));
        QCOMPARE(client_->news().exceptions[0], QByteArray("compile_error_name_not_found:no_such_function:"));
        QVERIFY(client_->news().keys.empty());
    }

    void unreachableTargetsAreDistinguished() {
        client_->news() = {};
        client_->sendScript("def far():\n  movej(p[10,0,0,0,0,0])\nend\n");
        QVERIFY(client_->until([this] { return !client_->news().exceptions.empty(); }, 2));
        QVERIFY(client_->until([this] { return client_->data().runtime == 1; }, 2));
        client_->news() = {};
        // A linear move to a distant point continues to the limit of the reach, where the robot stops the
        // arm.
        client_->sendScript("def far():\n  movel(p[10,0,0,0,0,0])\nend\n");
        constexpr double kHangs = 60;  // [s]
        QVERIFY(client_->until([this] { return client_->news().protectiveStopped; }, kHangs));
        const Six& pose = client_->data().actualPose;
        constexpr double kShoulder = 0.1625;  // height of the shoulder above the base [m]
        const double reach = std::hypot(pose[0], pose[1], pose[2] - kShoulder);
        QVERIFY2(reach > 0.9, qPrintable(QString::number(reach)));
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

    void protectiveStopByProgramIsReportedOnce_data() {
        QTest::addColumn<QByteArray>("program");
        QTest::newRow("def") << QByteArray("def halt_here():\n  protective_stop()\nend\n");
        QTest::newRow("sec") << QByteArray("sec halt_here():\n  protective_stop()\nend\n");
    }
    void protectiveStopByProgramIsReportedOnce() {
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
