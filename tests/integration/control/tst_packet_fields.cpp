// SPDX-License-Identifier: MIT
// One connection for control and data. The callback of a packet loop receives every field of its packet.
#include <QTest>
#include <cmath>

#include "robot/control/packet_loop.h"
#include "robot/testing/robot_fixture.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;
using namespace tiller::virtual_time;

namespace {

/// A simulated robot whose controller receives these fields.
struct FieldsBench {
    explicit FieldsBench(std::vector<std::string> fields) {
        bench.start().value();
        ControllerOptions options;
        options.fields = std::move(fields);
        controller = bench.makeController(options);
    }
    ~FieldsBench() {
        bench.whileTimePasses([this] { controller->release(); });
    }
    FieldsBench(const FieldsBench&) = delete;
    FieldsBench& operator=(const FieldsBench&) = delete;

    Result<void> takeControl() {
        return bench.whileTimePasses([this] { return controller->takeControl(RobotFixture::limit()); });
    }

    LockStep bench;
    std::shared_ptr<Controller> controller;
};

}  // namespace

class TestPacketFields : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theCallbackReceivesEveryFieldOfItsPacket() {
        // The controller always receives "actual_q", even if it is not requested.
        FieldsBench robot({"actual_current", "joint_temperatures", "actual_q"});
        const auto taken = robot.takeControl();
        QVERIFY2(taken.ok(), why(taken));
        std::vector<receive::Sample> samples;
        bool agrees = true;
        const auto hold = [&](const CycleState& state) -> std::optional<JointVelocities> {
            const receive::RobotState values = state.robot();
            agrees = agrees && values.q() == state.q && values.tcpPose().array() == state.tcpPose.array() &&
                     state.packet->hostTimeNs == state.hostNs;
            samples.push_back(*state.packet);
            return state.cycle < 20 ? std::optional(JointVelocities()) : std::nullopt;
        };
        const auto ended = robot.bench.whileTimePasses(
            [&] { return PacketLoop(*robot.controller).speedJ(hold, {}, RobotFixture::limit()); });
        QVERIFY2(ended.ok(), why(ended));
        QVERIFY(agrees);
        QCOMPARE(samples.size(), std::size_t(21));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const receive::RobotState values(samples[i]);
            QVERIFY(!std::isnan(values.jointCurrent()[1]) && values.jointTemperature()[0] > 0);
            QVERIFY(!std::isnan(values.tcpForce().force.z()));
            QCOMPARE(values.robotMode(), RobotMode::Running);
            if (i > 0) {
                QVERIFY(samples[i].sequence > samples[i - 1].sequence);
                QVERIFY(values.timestamp() > receive::RobotState(samples[i - 1]).timestamp());
            }
        }
    }

    void anUnknownOutputFieldIsRefusedWithASuggestion() {
        FieldsBench robot({"actual_curent"});
        const auto taken = robot.takeControl();
        QCOMPARE(taken.error().code, ErrorCode::FieldUnknown);
        QVERIFY2(taken.error().controllerMessage.contains(QStringLiteral("\"actual_current\"")), why(taken));
        QVERIFY(!robot.controller->isConnected());
    }

    void fieldsThatAreNotReceivedHaveNoValue() {
        QVERIFY(CycleState().robot().q().values.hasNaN());
        FieldsBench robot({});
        QVERIFY(robot.takeControl().ok());
        bool has = true;
        const auto once = [&](const CycleState& state) -> std::optional<JointVelocities> {
            has = state.robot().has("actual_current");
            return std::nullopt;
        };
        QVERIFY(robot.bench
                    .whileTimePasses(
                        [&] { return PacketLoop(*robot.controller).speedJ(once, {}, RobotFixture::limit()); })
                    .ok());
        QVERIFY(!has);
    }
};

QTEST_GUILESS_MAIN(TestPacketFields)
#include "tst_packet_fields.moc"
