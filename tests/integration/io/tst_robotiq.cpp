// SPDX-License-Identifier: MIT
// The gripper client of the backend and the simulated gripper, with real sockets.
#include <QTest>

#include "robot/io/robotiq_client.h"
#include "tests/support/raw_client.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::io;
using namespace tiller::test;

namespace {

constexpr int kOpen = 3;
constexpr int kClosed = 230;

struct Bench {
    explicit Bench(const simulator::SimulatorOptions& options = VirtualRobot::options())
        : robot(options), client(robot.host(), robot.controller.ports().gripper) {
        robot.controller.step();  // the gripper is powered on or off from here on
        const Result<void> connected = client.connect(testTimeout());
        if (!connected) {
            qFatal("%s", why(connected).constData());
        }
    }
    /// Returns the state. Fails the test if the gripper does not respond.
    RobotiqState look() {
        const auto found = client.look(testTimeout());
        if (!found || !found->has_value()) {
            qFatal("no state: %s", why(found).constData());
        }
        return **found;
    }
    template <class Condition>
    bool until(Condition condition) {
        for (int i = 0; i < 200; ++i) {
            if (condition(look())) {
                return true;
            }
            robot.controller.step(10);
        }
        return false;
    }
    void activate() {
        const Result<void> begun = client.beginActivation(testTimeout());
        if (!begun ||
            !until([](const RobotiqState& state) { return state.activation == RobotiqActivation::Active; })) {
            qFatal("not active: %s", why(begun).constData());
        }
    }
    /// Waits until the motion is complete.
    RobotiqState move(int position, int speed = 255, int force = 0) {
        const Result<void> taken = client.move(position, speed, force, testTimeout());
        if (!taken ||
            !until([](const RobotiqState& state) { return state.object != RobotiqObject::Moving; })) {
            qFatal("not there: %s", why(taken).constData());
        }
        return look();
    }

    VirtualRobot robot;
    RobotiqClient client;
};

}  // namespace

class TestRobotiq : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void gripperCanBeActivatedOpenedClosedAndPositioned() {
        Bench bench;
        QCOMPARE(bench.look().activation, RobotiqActivation::Reset);
        QVERIFY(bench.client.beginActivation(testTimeout()).ok());
        QVERIFY(bench.until(
            [](const RobotiqState& state) { return state.activation == RobotiqActivation::Activating; }));
        QVERIFY(bench.until(
            [](const RobotiqState& state) { return state.activation == RobotiqActivation::Active; }));
        QVERIFY2(!bench.look().goTo, "the gripper reports a motion before any request");

        RobotiqState state = bench.move(kRobotiqMost);
        QCOMPARE(state.position, kClosed);
        QCOMPARE(state.requested, kRobotiqMost);
        QCOMPARE(state.object, RobotiqObject::AtDestination);
        QVERIFY(!state.holds());
        QCOMPARE(bench.move(0).position, kOpen);
        QCOMPARE(bench.move(100, 10, 255).position, 100);
    }

    void gripperRefusesToMoveBeforeActivation() {
        Bench bench;
        QVERIFY(bench.client.move(200, 255, 0, testTimeout()).ok());
        bench.robot.controller.stepSeconds(0.5);
        const RobotiqState state = bench.look();
        QCOMPARE(state.fault, RobotiqFault::NotActivated);
        QCOMPARE(state.position, kOpen);
        QVERIFY(!state.holds());
        bench.activate();
        QCOMPARE(bench.look().fault, RobotiqFault::None);
    }

    void gripperReportsAHeldObject() {
        Bench bench;
        bench.activate();
        QVERIFY(bench.robot.controller.inject("gripper-object 120").ok());
        const RobotiqState outside = bench.move(kRobotiqMost);
        QCOMPARE(outside.object, RobotiqObject::StoppedClosing);
        QCOMPARE(outside.position, 120);
        QVERIFY(outside.holds());
        QVERIFY(!bench.move(0).holds());
        QVERIFY(bench.robot.controller.inject("gripper-object none").ok());
        bench.move(kRobotiqMost);
        QVERIFY(bench.robot.controller.inject("gripper-object 100").ok());
        const RobotiqState inside = bench.move(0);
        QCOMPARE(inside.object, RobotiqObject::StoppedOpening);
        QVERIFY(inside.holds());
    }

    void stopOfTheArmDoesNotOpenTheGripper() {
        Bench bench;
        bench.activate();
        QVERIFY(bench.robot.controller.inject("gripper-object 120").ok());
        const RobotiqState before = bench.move(kRobotiqMost);
        QVERIFY(before.holds());
        bench.robot.controller.protectiveStop();
        bench.robot.controller.stepSeconds(1);
        QCOMPARE(bench.robot.controller.truth().safetyMode, SafetyMode::ProtectiveStop);
        QVERIFY(bench.look() == before);
    }

    void gripperStateIsUnknownWithoutArmPower() {
        Bench bench(VirtualRobot::poweredOff());
        const auto look = bench.client.look(testTimeout());
        QVERIFY2(look.ok(), why(look).constData());
        QVERIFY(!look->has_value());
        QVERIFY(bench.client.isConnected());
    }

    void reconnectsAfterTheControllerDisconnects() {
        Bench bench;
        bench.look();  // the reply shows that the controller has accepted the connection
        bench.robot.controller.closeClients();
        bench.robot.controller.step();
        QCOMPARE(bench.client.look(testTimeout()).error().code, ErrorCode::ConnectionClosed);
        QVERIFY(bench.client.connect(testTimeout()).ok());
        QCOMPARE(bench.look().activation, RobotiqActivation::Reset);
    }

    void aSilentControllerIsAbandonedAtTheDeadline() {
        Bench bench;
        bench.robot.controller.silence(true);
        bench.robot.controller.step();
        const auto mute = bench.client.look(Deadline::after(std::chrono::milliseconds(200)));
        QCOMPARE(mute.error().code, ErrorCode::Timeout);
        QVERIFY(!bench.client.isConnected());
        bench.robot.controller.silence(false);
        bench.robot.controller.step();
        QVERIFY(bench.client.connect(testTimeout()).ok());
        QCOMPARE(bench.look().activation, RobotiqActivation::Reset);
    }
};

QTEST_GUILESS_MAIN(TestRobotiq)
#include "tst_robotiq.moc"
