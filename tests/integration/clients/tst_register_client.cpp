// SPDX-License-Identifier: MIT
//
// A client with ur_rtde's start-up and register protocol, and a control script with the features of ur_rtde's
// script, with the simulated controller.

#include <QTest>
#include <numbers>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/integration/clients/register_client.h"

using namespace tiller;
using namespace tiller::test;
using Client = RegisterClient;

namespace {

constexpr double kDt = 0.002;

Eigen::Vector3d positionOf(const Six& pose) {
    return {pose[0], pose[1], pose[2]};
}

double largest(const JointPositions& q, const Six& other) {
    double worst = 0;
    for (int j = 0; j < 6; ++j) {
        worst = std::max(worst, std::abs(q[j] - other[static_cast<std::size_t>(j)]));
    }
    return worst;
}

}  // namespace

class TestRegisterClient : public QObject {
    Q_OBJECT

    VirtualRobot robot_;
    std::unique_ptr<Client> client_;

    Six poseNow() const { return robot_.controller.truth().tcpPose.array(); }
    Six jointsNow() const {
        Six q{};
        for (int j = 0; j < 6; ++j) {
            q[static_cast<std::size_t>(j)] = robot_.controller.truth().q[j];
        }
        return q;
    }
    bool six(Client::Recipe recipe, int id, const Six& s, std::initializer_list<double> more = {},
             std::initializer_list<int> ints = {}) {
        std::vector<double> all(s.begin(), s.end());
        all.insert(all.end(), more);
        while (all.size() < 14) {
            all.push_back(0);
        }
        switch (recipe) {
            case Client::kMove:
                return client_->command(
                    recipe, id, {all[0], all[1], all[2], all[3], all[4], all[5], all[6], all[7]}, ints);
            case Client::kTwelve:
                return client_->command(recipe, id,
                                        {all[0], all[1], all[2], all[3], all[4], all[5], all[6], all[7],
                                         all[8], all[9], all[10], all[11]});
            case Client::kFourteen:
            case Client::kJog:
                return client_->command(recipe, id,
                                        {all[0], all[1], all[2], all[3], all[4], all[5], all[6], all[7],
                                         all[8], all[9], all[10], all[11], all[12], all[13]});
            default:
                return client_->command(recipe, id, {all[0], all[1], all[2], all[3], all[4], all[5]});
        }
    }
    const Six& results() const { return client_->state().doubles; }

private Q_SLOTS:
    void init() {
        client_ = std::make_unique<Client>(robot_);
        QVERIFY2(client_->connect(), client_->trouble);
        QCOMPARE(client_->state().robotBits, 3U);
        QVERIFY(client_->until([this] { return client_->state().ints[0] == 1; }, 1));
    }
    void cleanup() {
        client_->disconnect();
        client_.reset();
        // Move the arm to its initial position for the next client.
        RawPrimary script = robot_.primary();
        script.send(
            "def home():\n  end_freedrive_mode()\n  set_tcp(p[0,0,0,0,0,0])\n  set_payload(0,[0,0,0])\n"
            "  set_gravity([0,0,9.82])\n  set_pos([-1.6007,-1.7271,-2.2030,-0.8080,1.5951,-0.0310])\n"
            "end\n");
        robot_.controller.drainSockets();
        robot_.controller.pressHand({});
        robot_.controller.changeWorld([](simulator::arm::Environment& world) { world.clearSurfaces(); });
        QVERIFY(robot_.stepUntil([this] { return robot_.programState() == RuntimeState::Playing; }, 1));
        QVERIFY(robot_.stepUntil([this] { return robot_.programState() == RuntimeState::Stopped; }, 5));
        QTRY_COMPARE_WITH_TIMEOUT(robot_.controller.rtdeClients(), 0, 60'000);
    }

    void theScriptEndsAndStartsAgainAtOnce() {
        QVERIFY(client_->stopScript());
        QCOMPARE(client_->state().runtime, 1U);
        // Send the script in the same way as for a path: without a pause and without the dashboard.
        client_->scriptSocket().send(registerScript(0));
        robot_.controller.drainSockets();
        QVERIFY(client_->until([this] { return client_->state().runtime == 2; }, 5));
        // Performs the upload of `reuploadScript` while the script is running.
        QVERIFY2(client_->upload(), client_->trouble);
        QVERIFY(six(Client::kSix, 43, {}));
    }

    void aReconnectedClientFindsItsRegistersFree() {
        client_->disconnect();
        QTRY_COMPARE_WITH_TIMEOUT(robot_.controller.rtdeClients(), 0, 60'000);
        client_ = std::make_unique<Client>(robot_);
        QVERIFY2(client_->connect(), client_->trouble);
        QVERIFY(client_->command(Client::kNothing, 43));
    }

    void theUpperRangeWorksTheSameWay() {
        QVERIFY(client_->stopScript());
        client_->disconnect();
        QTRY_COMPARE_WITH_TIMEOUT(robot_.controller.rtdeClients(), 0, 60'000);
        client_ = std::make_unique<Client>(robot_, 24);
        QVERIFY2(client_->connect(), client_->trouble);
        QVERIFY(client_->command(Client::kNothing, 43));
        QVERIFY((positionOf(results()) - robot_.controller.truth().tcpPose.position).norm() < 1e-4);
    }

    void movesReachTheirTargets() {
        // A move to the current pose is complete immediately.
        QVERIFY2(six(Client::kMove, 3, poseNow(), {0.25, 1.2}, {0}), client_->trouble);
        Six q = jointsNow();
        q[0] += 0.3;
        q[4] -= 0.4;
        QVERIFY(six(Client::kMove, 1, q, {1.05, 1.4}, {0}));
        QVERIFY(largest(robot_.controller.truth().q, q) < 1e-4);
        Six pose = poseNow();
        pose[2] += 0.1;
        QVERIFY(six(Client::kMove, 3, pose, {0.25, 1.2}, {0}));
        QVERIFY((robot_.controller.truth().tcpPose.position - positionOf(pose)).norm() < 1e-4);
        pose[1] -= 0.1;
        QVERIFY(six(Client::kMove, 2, pose, {1.05, 1.4}, {0}));
        QVERIFY((robot_.controller.truth().tcpPose.position - positionOf(pose)).norm() < 1e-4);
        q = jointsNow();
        q[5] += 0.5;
        QVERIFY(six(Client::kMove, 4, q, {0.25, 1.2}, {0}));
        QVERIFY(largest(robot_.controller.truth().q, q) < 1e-4);
    }

    void asynchronousMoveReportsProgressAndCanBeStopped() {
        Six q = jointsNow();
        q[0] += 1.5;
        const auto running = [this] { return (client_->state().ints[2] & 0x8000) != 0; };
        QVERIFY(six(Client::kMove, 1, q, {0.5, 1.4}, {1}));
        QVERIFY(client_->until(running, 1));
        const int operation = client_->state().ints[2] >> 24;
        client_->step(200);
        QVERIFY(running());
        QVERIFY(robot_.controller.truth().qd.values.norm() > 0.2);
        QVERIFY(client_->command(Client::kStop, 34, {2.0}, {0}));
        client_->step(10);
        QVERIFY(robot_.controller.truth().qd.values.norm() < 2e-3);
        QVERIFY(largest(robot_.controller.truth().q, q) > 0.5);
        // A second move runs to its end.
        QVERIFY(six(Client::kMove, 1, q, {1.0, 1.4}, {1}));
        QVERIFY(client_->until(running, 1));
        QVERIFY(client_->state().ints[2] >> 24 != operation);
        QVERIFY(client_->until([&] { return !running(); }, 10));
        QVERIFY(largest(robot_.controller.truth().q, q) < 1e-4);
    }

    void servoFollowsAStream() {
        const Six start = jointsNow();
        Six q = start;
        for (int n = 0; n < 500; ++n) {
            q[0] = start[0] + 0.1 * (1 - std::cos(std::numbers::pi * n * kDt));
            QVERIFY(client_->realtime(Client::kServo, 11,
                                      {q[0], q[1], q[2], q[3], q[4], q[5], 0, 0, kDt, 0.1, 300}));
            client_->step();
        }
        QVERIFY(client_->until([&] { return largest(robot_.controller.truth().q, q) < 1e-3; }, 2));
        Six pose = poseNow();
        for (int n = 0; n < 250; ++n) {
            pose[2] += 0.0001;
            QVERIFY(client_->realtime(
                Client::kServo, 24,
                {pose[0], pose[1], pose[2], pose[3], pose[4], pose[5], 0, 0, kDt, 0.1, 300}));
            client_->step();
        }
        QVERIFY(client_->until(
            [&] { return std::abs(robot_.controller.truth().tcpPose.position.z() - pose[2]) < 1e-3; }, 2));
        QVERIFY(client_->clear());
        client_->step(2);
        QVERIFY(client_->command(Client::kOne, 16, {10}));
        client_->step(10);
        QVERIFY(robot_.controller.truth().qd.values.norm() < 2e-3);
    }

    // The client sends servoC without waiting for its reply. The next command times out after three seconds
    // because the script does not report "ready". After the client has cleared its registers, commands
    // succeed again.
    void servoCircularBehavesAsWithTheRealClient() {
        Six pose = poseNow();
        pose[2] += 0.05;
        QVERIFY(client_->realtime(Client::kServoCircular, 12,
                                  {pose[0], pose[1], pose[2], pose[3], pose[4], pose[5], 0.25, 1.2, 0}));
        client_->step(2);
        QVERIFY(!client_->realtime(Client::kOne, 16, {10}));
        QVERIFY(client_->until(
            [&] { return std::abs(robot_.controller.truth().tcpPose.position.z() - pose[2]) < 1e-3; }, 3));
        QVERIFY(client_->clear());
        client_->step(2);
        QVERIFY(client_->command(Client::kOne, 16, {10}));
    }

    void speedCommandsMoveUntilTheyAreStopped() {
        QVERIFY(client_->realtime(Client::kSpeed, 10, {0, 0, 0.05, 0, 0, 0, 0.5, 0}));
        QVERIFY(client_->until([this] { return robot_.controller.truth().tcpSpeed.linear.z() > 0.049; }, 1));
        QVERIFY(client_->realtime(Client::kSpeed, 9, {0.2, 0, 0, 0, 0, 0, 1.0, 0.1}));
        QVERIFY(client_->until([this] { return robot_.controller.truth().qd[0] > 0.198; }, 2));
        QVERIFY(std::abs(robot_.controller.truth().tcpSpeed.linear.z()) < 1e-3);
        QVERIFY(client_->clear());
        client_->step(2);
        QVERIFY(client_->command(Client::kOne, 15, {10}));
        client_->step(5);
        QVERIFY(robot_.controller.truth().qd.values.norm() < 2e-3);
    }

    void jogInTheToolFrameAndStop() {
        const Six start = poseNow();
        // The Z axis of the tool points down.
        QVERIFY(six(Client::kJog, 41, {0, 0, -0.05, 0, 0, 0}, {1, 0.5}));
        QVERIFY(client_->until(
            [&] { return robot_.controller.truth().tcpPose.position.z() > start[2] + 0.02; }, 2));
        QVERIFY(client_->command(Client::kNothing, 42));
        client_->step(5);
        QVERIFY(robot_.controller.truth().qd.values.norm() < 2e-3);
        QVERIFY(std::abs(robot_.controller.truth().tcpPose.position.x() - start[0]) < 4e-3);
    }

    void forceModePressesAndEnds() {
        const double z = poseNow()[2];
        robot_.controller.changeWorld([z](simulator::arm::Environment& world) {
            world.addPlane({.point = {0, 0, z - 0.01}});
        });
        QVERIFY(client_->command(Client::kNothing, 8));
        QVERIFY(client_->command(Client::kOne, 20, {0.025}));
        QVERIFY(client_->command(Client::kOne, 21, {0.5}));
        for (int n = 0; n < 1500; ++n) {
            QVERIFY(client_->realtime(Client::kForce, 6,
                                      {0, 0, 0, 0, 0, 0, 0, 0, -10, 0, 0, 0, 2, 2, 1.5, 1, 1, 1},
                                      {2, 0, 0, 1, 0, 0, 0}));
            client_->step();
        }
        QVERIFY(std::abs(poseNow()[2] - (z - 0.01)) < 2e-3);
        QVERIFY(client_->clear());
        client_->step(2);
        QVERIFY(client_->command(Client::kNothing, 7));
    }

    void queriesAgreeWithTheRobot() {
        const auto close = [this](const Six& wanted, double tolerance) {
            for (std::size_t i = 0; i < 6; ++i) {
                if (!(std::abs(results()[i] - wanted[i]) < tolerance)) {
                    return false;
                }
            }
            return true;
        };
        const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
        QVERIFY(client_->command(Client::kNothing, 43));
        QVERIFY(close(poseNow(), 1e-4));
        const Six other{0.5, -1.2, 1.4, -1.7, -1.5, 0.3};
        const Six tcp{0.01, 0.02, 0.1, 0, 0, 0.2};
        QVERIFY(six(Client::kTwelve, 44, other, {tcp[0], tcp[1], tcp[2], tcp[3], tcp[4], tcp[5]}));
        QVERIFY(close(kinematics::forwardTcp(dh, JointPositions(other), Pose::fromArray(tcp)).array(), 1e-9));
        const Six there = kinematics::forwardTcp(dh, JointPositions(other)).array();
        QVERIFY(six(Client::kFourteen, 30, there, {0.5, -1.2, 1.4, -1.7, -1.5, 0.3, 1e-10, 1e-10}));
        QVERIFY(close(other, 1e-6));
        QVERIFY(six(Client::kSix, 46, poseNow()));
        QVERIFY(close(jointsNow(), 1e-3));
        QVERIFY(six(Client::kSix, 60, {10, 0, 0, 0, 0, 0}));
        QCOMPARE(client_->state().ints[1], 0);
        QVERIFY(six(Client::kFourteen, 61, there, {0.5, -1.2, 1.4, -1.7, -1.5, 0.3, 1e-10, 1e-10}));
        QCOMPARE(client_->state().ints[1], 1);
        QVERIFY(six(Client::kSix, 36, poseNow()));
        QCOMPARE(client_->state().ints[1], 1);
        QVERIFY(six(Client::kSix, 37, {0, 0, 7, 0, 0, 0}));
        QCOMPARE(client_->state().ints[1], 0);
        QVERIFY(six(Client::kTwelve, 39, {.2, .5, .1, 1.57, 0, 0}, {.2, .5, .6, 1.57, 0, 0}));
        QVERIFY(close({0.4, -0.0996, 0.60048, 3.14, 0, 0}, 1e-4));
        QVERIFY(client_->command(Client::kNothing, 40));
        QVERIFY(close({}, 1e-12));
        QVERIFY(client_->command(Client::kNothing, 28));
        QVERIFY(close(poseNow(), 1e-4));
        QVERIFY(client_->command(Client::kNothing, 58));  // the reply is overwritten in the same period
        QVERIFY(close(poseNow(), 1e-4));
        QVERIFY(client_->until([this] { return client_->state().ints[0] == 1; }, 1));
        client_->step(300);
        QVERIFY(client_->command(Client::kNothing, 47));
        QCOMPARE(client_->state().ints[1], 1);
        QVERIFY(client_->command(Client::kNothing, 54));
        QCOMPARE(client_->state().ints[1], 0);
        // A command that is sent without waiting is answered within three periods.
        QVERIFY(client_->realtime(Client::kNothing, 26));
        client_->step(3);
        QCOMPARE(results()[0], kDt);
        QVERIFY(client_->realtime(Client::kInt, 27, {}, {5}));
        client_->step(3);
        QVERIFY(close(jointsNow(), 1e-4));
        QVERIFY(client_->realtime(Client::kNothing, 38));
        client_->step(3);
        QVERIFY(close({}, 0.5));
        QVERIFY(client_->realtime(Client::kSix, 25, {0, 0, 1, 0, 0, 0}));
        client_->step(3);
        QCOMPARE(client_->state().ints[1], 0);
        QVERIFY(client_->clear());
        client_->step(2);
    }

    void configurationIsVisibleOnRtde() {
        QVERIFY(six(Client::kSix, 29, {0, 0, 0.12, 0, 0, 0.5}));
        QVERIFY(client_->command(Client::kFour, 17, {1.5, 0.01, 0.02, 0.03}));
        QVERIFY(client_->command(Client::kFour, 59, {0, 4.91, 8.5, 0}));
        RawRtde rtde = robot_.rtde();
        QVERIFY(rtde.useVersion());
        QCOMPARE(rtde.setupOutputs(500, "tcp_offset,payload,payload_cog,target_gravity").count(','), 3);
        QVERIFY(rtde.start());
        client_->step();
        const QByteArray data = rtde.next().payload;
        QCOMPARE(doubleAt(data, 1 + 16), 0.12);
        QCOMPARE(doubleAt(data, 1 + 40), 0.5);
        QCOMPARE(doubleAt(data, 1 + 48), 1.5);
        QCOMPARE(doubleAt(data, 1 + 72), 0.03);
        QCOMPARE(doubleAt(data, 1 + 88), 4.91);
        // A centre of gravity of zero leaves the current value unchanged.
        QVERIFY(client_->command(Client::kFour, 17, {2.0, 0, 0, 0}));
        client_->step();
        QByteArray last = data;
        for (auto package = rtde.next(); package.type == 'U'; package = rtde.next()) {
            last = package.payload;
            if (doubleAt(last, 1 + 48) == 2.0) {
                break;
            }
        }
        QCOMPARE(doubleAt(last, 1 + 72), 0.03);
    }

    void movesUntilContact() {
        const double z = poseNow()[2];
        robot_.controller.changeWorld([z](simulator::arm::Environment& world) {
            world.addPlane({.point = {0, 0, z - 0.02}});
        });
        QVERIFY(client_->command(Client::kUntilContact, 51, {0, 0, -0.05, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5}));
        QVERIFY(std::abs(poseNow()[2] - (z - 0.02)) < 1e-3);
        QCOMPARE(client_->state().safetyBits, 1U);
    }

    void contactIsDetectedDuringAMove() {
        const double z = poseNow()[2];
        robot_.controller.changeWorld([z](simulator::arm::Environment& world) {
            world.addPlane({.point = {0, 0, z - 0.02}});
        });
        QVERIFY(six(Client::kSix, 62, {}));
        QVERIFY(client_->command(Client::kNothing, 64));
        QCOMPARE(client_->state().ints[1], 0);
        QVERIFY(client_->realtime(Client::kSpeed, 10, {0, 0, -0.02, 0, 0, 0, 0.5, 0}));
        QVERIFY(client_->until([&] { return poseNow()[2] < z - 0.0215; }, 3));
        QVERIFY(client_->clear());
        client_->step(2);
        QVERIFY(client_->command(Client::kNothing, 63));
        QVERIFY(client_->state().ints[1] > 0);
        QVERIFY(client_->command(Client::kOne, 15, {10}));
    }

    void theArmIsGuidedInFreedriveAndTeachMode() {
        for (const bool teach : {false, true}) {
            const Six start = poseNow();
            QVERIFY(teach ? client_->command(Client::kNothing, 18)
                          : client_->command(Client::kFreedrive, 52, {0, 0, 0, 0, 0, 0}, {1, 1, 1, 1, 1, 1}));
            robot_.controller.pressHand({{0, 0, 25}, {0, 0, 0}});
            QVERIFY(client_->until([&] { return poseNow()[2] > start[2] + 0.03; }, 5));
            robot_.controller.pressHand({});
            QVERIFY(client_->command(Client::kNothing, teach ? 19 : 53));
            client_->step(500);
            QVERIFY(robot_.controller.truth().qd.values.norm() < 2e-3);
        }
    }

    void anInjectedPathRuns_data() {
        QTest::addColumn<bool>("async");
        QTest::newRow("to its end") << false;
        QTest::newRow("beside the main loop") << true;
    }
    void anInjectedPathRuns() {
        QFETCH(bool, async);
        const QByteArray path =
            "        movej(p[-0.140,-0.400,0.100,0,3.14,0], a=1.4, v=1.05)\n"
            "        turn = 1  progress(True, turn)\n"
            "        movel(p[-0.140,-0.400,0.300,0,3.14,0], a=0.5, v=0.5, r=0.099)\n"
            "        movel(p[-0.140,-0.600,0.300,0,3.14,0], a=0.5, v=0.4, r=0.099)\n"
            "        turn = 2  progress(True, turn)\n"
            "        movel(p[0.140,-0.600,0.100,0,3.14,0], a=0.5, v=0.3, r=0.099)\n"
            "        movel(p[0.280,-0.400,0.100,0,3.14,0], a=0.5, v=0.2)\n"
            "        turn = 3";
        QVERIFY(client_->stopScript());
        client_->scriptSocket().send(registerScript(0, path));
        robot_.controller.drainSockets();
        QVERIFY(client_->until([this] { return client_->state().runtime == 2; }, 5));
        QVERIFY(client_->command(Client::kPath, 45, {}, {async ? 1 : 0}));
        QVERIFY(client_->until([this] { return (client_->state().ints[2] & 0xffff) == 3; }, async ? 20 : 1));
        QVERIFY((robot_.controller.truth().tcpPose.position - Eigen::Vector3d(0.28, -0.4, 0.1)).norm() <
                1e-4);
    }

    void aWatchdogStopsTheScript() {
        QVERIFY(client_->command(Client::kOne, 35, {10}));
        for (int n = 0; n < 300; ++n) {
            QVERIFY(client_->send(Client::kKick, 0, {}, {}));
            client_->step();
        }
        QCOMPARE(client_->state().runtime, 2U);
        QVERIFY(client_->until([this] { return client_->state().runtime == 1; }, 0.3));
        QVERIFY2(client_->upload(), client_->trouble);
    }

    void aProtectiveStopEndsCommandsUntilItIsUnlocked() {
        QVERIFY(!client_->command(Client::kNothing, 31));
        QVERIFY((client_->state().safetyBits >> 2 & 1U) != 0);
        client_->step(2600);
        QCOMPARE(client_->dashboard().ask("unlock protective stop"),
                 QByteArray("Protective stop releasing\n"));
        QVERIFY(client_->until([this] { return client_->state().safetyBits == 1; }, 1));
        client_->dashboard().ask("stop");
        QVERIFY(client_->until([this] { return client_->state().runtime == 1; }, 2));
        QVERIFY2(client_->upload(), client_->trouble);
        QVERIFY(client_->command(Client::kNothing, 43));
    }

    void aCustomFunctionRunsBetweenTwoUploads() {
        QVERIFY(client_->stopScript());
        client_->scriptSocket().send(
            "def custom():\n\twrite_output_integer_register(0, 1)\n\tset_tool_digital_out(0, "
            "True)\n\tsleep(0.1)\n"
            "\twrite_output_integer_register(0, 2)\nend\n");
        robot_.controller.drainSockets();
        QVERIFY(client_->until([this] { return client_->state().ints[0] == 1; }, 5));
        QVERIFY(client_->until([this] { return client_->state().ints[0] == 2; }, 5));
        QVERIFY(client_->clear());
        QVERIFY((robot_.controller.truth().digitalOutputs >> 16 & 1U) == 1);
        QVERIFY2(client_->upload(), client_->trouble);
    }

    void anExternalSensorReplacesTheInternalOne() {
        QVERIFY(client_->command(Client::kSensor, 56, {0, 0, 0, 0, 0, 0, 0}, {1}));
        RawRtde rtde = robot_.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(500, "actual_TCP_force");
        QVERIFY(rtde.start());
        for (int n = 0; n < 100; ++n) {
            QVERIFY(client_->send(Client::kExternalForce, 55, {0, 0, -7, 0, 0, 0}, {}));
            client_->step();
            const QByteArray data = rtde.next().payload;
            if (n > 5) {
                QVERIFY(std::abs(std::abs(doubleAt(data, 1 + 16)) - 7) < 1e-6);
            }
        }
        QVERIFY(client_->clear());
        client_->step(2);
        QVERIFY(client_->command(Client::kSensor, 56, {0, 0, 0, 0, 0, 0, 0}, {0}));
    }
};

QTEST_GUILESS_MAIN(TestRegisterClient)
#include "tst_register_client.moc"
