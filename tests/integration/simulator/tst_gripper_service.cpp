// SPDX-License-Identifier: MIT

#include <QTest>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

struct GripperClient : RawClient {
    explicit GripperClient(VirtualRobot& given)
        : RawClient(given.host(), given.controller.ports().gripper), robot(given) {}
    bool set(const QByteArray& what) {
        send("SET " + what + '\n');
        return take(3) == "ack";
    }
    QByteArray get(const QByteArray& name) {
        send("GET " + name + '\n');
        return line();
    }
    int value(const QByteArray& name) { return get(name).mid(name.size() + 1).trimmed().toInt(); }
    void activate() {
        set("ACT 1");
        stepUntil([&] { return value("STA") == 3; });
    }
    /// Moves the gripper and returns the object status.
    int move(const QByteArray& what) {
        set(what + " GTO 1");
        stepUntil([&] { return value("OBJ") != 0; });
        return value("OBJ");
    }
    template <class Condition>
    void stepUntil(Condition condition) {
        for (int i = 0; i < 1000 && !condition(); ++i) {
            robot.controller.step(10);
        }
    }
    VirtualRobot& robot;
};

}  // namespace

class TestGripperService : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void variablesAreSetAndRead() {
        VirtualRobot robot;
        GripperClient gripper(robot);
        gripper.send("SET SPE 100\n");
        QCOMPARE(gripper.take(3), QByteArray("ack"));
        // No newline after the reply, because clients compare the exact text.
        QVERIFY(gripper.takeAll().isEmpty());
        QCOMPARE(gripper.get("SPE"), QByteArray("SPE 100\n"));
        QVERIFY(gripper.set("FOR 12 POS 300"));
        QCOMPARE(gripper.get("FOR"), QByteArray("FOR 12\n"));
        QCOMPARE(gripper.get("PRE"), QByteArray("PRE 255\n"));
        QVERIFY(gripper.set("SID 9"));
        QCOMPARE(gripper.get("NIX"), QByteArray("NIX ?\n"));
        for (const char* wrong : {"SET NIX 1\n", "SET POS\n", "SET POS x\n", "SET\n", "HELLO\n"}) {
            gripper.send(wrong);
            QCOMPARE(gripper.take(4), QByteArray("nack"));
        }
    }

    void severalRequestsInOneSegmentAreAnsweredInOneSegment() {
        VirtualRobot robot;
        GripperClient gripper(robot);
        gripper.send("GET ACT\nGET STA\nGET FLT\n");
        gripper.socket().waitForReadyRead(kWaitTimeoutMs);
        QCOMPARE(gripper.socket().readAll(), QByteArray("ACT 0\nSTA 0\nFLT 0\n"));
    }

    void theVendorScriptRequestsWithoutALineEnd() {
        VirtualRobot robot;
        GripperClient gripper(robot);
        const auto ask = [&](const QByteArray& name, int bytes) {
            gripper.send("GET " + name);
            return gripper.take(bytes);
        };
        QCOMPARE(ask("STA", 1), QByteArray("0"));
        QCOMPARE(ask("FLT", 2), QByteArray("00"));
        QVERIFY(gripper.set("POS 7"));
        QCOMPARE(ask("PRE", 3), QByteArray("007"));
        const QByteArray addresses = ask("SID", 17);
        QCOMPARE(addresses[1], '9');
        QVERIFY(gripper.takeAll().isEmpty());
        // The line is sent in two pieces. Its end must not be treated as another request.
        gripper.send("\n");
        QCOMPARE(gripper.get("PRE"), QByteArray("PRE 7\n"));
        QVERIFY(gripper.set("LBP 1") && gripper.set("LRD 0") && gripper.set("MSC 40") &&
                gripper.set("SCN_BLOCK 1"));
        QCOMPARE(ask("MSC", 3), QByteArray("040"));
        // The gripper waits for the end of an incomplete line.
        gripper.send("SET POS");
        QVERIFY(gripper.takeAll().isEmpty());
        gripper.send(" 9\n");
        QCOMPARE(gripper.take(3), QByteArray("ack"));
    }

    void programReachesTheGripperAtTheControllerAddress() {
        auto options = VirtualRobot::options();
        options.listenAddress = "127.0.0.7";  // address of the controller; its programs use 127.0.0.1
        VirtualRobot robot(options);
        RawClient scripts(robot.host(), robot.controller.ports().secondary);
        scripts.send(
            "def p():\n"
            "  opened = socket_open(\"127.0.0.1\", 63352, \"1\")\n"
            "  socket_set_var(\"POS\", 42, 1)\n"
            "  ack = socket_read_byte_list(3, 1)\n"
            "  set_standard_digital_out(0, opened and ack[0] == 3)\n"
            "end\n");
        QVERIFY(robot.stepUntil([&] { return robot.controller.truth().digitalOutputs == 1; }));
        GripperClient gripper(robot);
        QCOMPARE(gripper.value("PRE"), 42);
    }

    void activationIsRequiredBeforeMoves() {
        VirtualRobot robot;
        GripperClient gripper(robot);
        QVERIFY(gripper.set("POS 100 GTO 1"));
        robot.controller.stepSeconds(2);
        QCOMPARE(gripper.value("FLT"), 7);
        QVERIFY(gripper.value("POS") < 5);
        QVERIFY(gripper.set("ACT 0"));
        QCOMPARE(gripper.value("STA"), 0);
        QVERIFY(gripper.set("ACT 1"));
        robot.controller.step();
        QCOMPARE(gripper.value("STA"), 1);
        robot.controller.stepSeconds(0.5);
        QVERIFY(gripper.value("POS") > 100);  // during activation, the gripper closes and opens once
        gripper.activate();
        QCOMPARE(gripper.value("STA"), 3);
        QCOMPARE(gripper.value("FLT"), 0);
    }

    void movesWithTheSetSpeed() {
        VirtualRobot robot;
        GripperClient gripper(robot);
        gripper.activate();
        const auto duration = [&](const QByteArray& what) {
            const double begin = robot.controller.truth().timestamp;
            gripper.move(what);
            return robot.controller.truth().timestamp - begin;
        };
        const double slow = duration("POS 200 SPE 0");
        QCOMPARE(gripper.value("POS"), 200);
        QCOMPARE(gripper.value("OBJ"), 3);
        const double fast = duration("POS 3 SPE 255");
        QVERIFY2(slow / fast > 7 && slow / fast < 8, qPrintable(QString::number(slow / fast)));
        QCOMPARE(gripper.move("POS 255"), 3);
        QCOMPARE(gripper.value("POS"), 230);  // the fingers touch the object
        QCOMPARE(gripper.value("PRE"), 255);
    }

    void anObjectStopsTheFingersFromEitherSide() {
        VirtualRobot robot;
        GripperClient gripper(robot);
        gripper.activate();
        QVERIFY(robot.controller.inject("gripper-object 120").ok());
        QCOMPARE(gripper.move("POS 255 SPE 255"), 2);
        QCOMPARE(gripper.value("POS"), 120);
        QCOMPARE(gripper.move("POS 50"), 3);
        QVERIFY(robot.controller.inject("gripper-object none").ok());
        QCOMPARE(gripper.move("POS 255"), 3);
        QVERIFY(robot.controller.inject("gripper-object 100").ok());
        QCOMPARE(gripper.move("POS 0"), 1);
        QCOMPARE(gripper.value("POS"), 100);
    }

    void automaticReleaseOpensSlowlyAndRequiresANewActivation() {
        VirtualRobot robot;
        GripperClient gripper(robot);
        gripper.activate();
        gripper.move("POS 200 SPE 255");
        QVERIFY(gripper.set("ARD 1 ATR 1"));
        robot.controller.step();
        QCOMPARE(gripper.value("FLT"), 0x0B);
        QCOMPARE(gripper.value("STA"), 0);
        gripper.stepUntil([&] { return gripper.value("FLT") == 0x0F; });
        QCOMPARE(gripper.value("FLT"), 0x0F);
        QCOMPARE(gripper.value("POS"), 3);
        QCOMPARE(gripper.value("STA"), 0);
        QCOMPARE(gripper.value("ACT"), 1);
        QVERIFY(gripper.set("POS 100 GTO 1"));
        robot.controller.stepSeconds(2);
        QCOMPARE(gripper.value("POS"), 3);
        // Neither the end of the release nor a second activation without a reset makes the gripper ready
        // again.
        QVERIFY(gripper.set("ATR 0"));
        robot.controller.stepSeconds(2);
        QCOMPARE(gripper.value("STA"), 0);
        QVERIFY(gripper.set("ACT 1"));
        robot.controller.stepSeconds(2);
        QCOMPARE(gripper.value("STA"), 0);
        QCOMPARE(gripper.value("POS"), 3);
        QVERIFY(gripper.set("ACT 0"));
        QCOMPARE(gripper.value("FLT"), 0);
        gripper.activate();
        QCOMPARE(gripper.move("POS 100"), 3);
    }

    // The emergency release has priority over all commands except a reset.
    void anAutomaticReleaseEndsAnActivation() {
        VirtualRobot robot;
        GripperClient gripper(robot);
        QVERIFY(gripper.set("ACT 1"));
        robot.controller.stepSeconds(0.5);
        QCOMPARE(gripper.value("STA"), 1);
        QVERIFY(gripper.set("ARD 1 ATR 1"));
        robot.controller.step();
        QCOMPARE(gripper.value("STA"), 0);
        gripper.stepUntil([&] { return gripper.value("FLT") == 0x0F; });
        QCOMPARE(gripper.value("FLT"), 0x0F);
        QCOMPARE(gripper.value("STA"), 0);
    }

    // A program reaches its controller at 127.0.0.1 with the standard ports, regardless of the actual
    // address.
    void programReachesTheGripperOfItsController() {
        VirtualRobot robot;
        GripperClient gripper(robot);
        RawPrimary secondary(robot.host(), robot.controller.ports().secondary);
        secondary.send(
            "def grip():\n\tsocket_close(\"g\")\n\tsocket_open(\"127.0.0.1\",63352,\"g\")\n"
            "\tsocket_set_var(\"SPE\",255,\"g\")\n\tsync()\n\tsocket_set_var(\"ACT\",1,\"g\")\n\tsync()\n"
            "\tsocket_set_var(\"GTO\",1,\"g\")\n\tsync()\n\tsocket_set_var(\"POS\",180,\"g\")\n\tsync()\n"
            "\tsleep(2.0)\nend\n");
        robot.controller.drainSockets();
        gripper.stepUntil([&] { return gripper.value("STA") == 3 && gripper.value("POS") == 180; });
        QCOMPARE(gripper.value("POS"), 180);
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 5));
    }

    void withoutPowerTheGripperDoesNotAnswerAndLosesItsActivation() {
        VirtualRobot robot;
        GripperClient gripper(robot);
        gripper.activate();
        QVERIFY(robot.controller.inject("power-loss").ok());
        robot.controller.step();
        QCOMPARE(gripper.get("POS"), QByteArray("POS ?\n"));
        robot.dashboard().ask("brake release");
        QVERIFY(robot.stepUntil([&] { return robot.controller.truth().robotMode == RobotMode::Running; }, 5));
        robot.controller.step();
        QCOMPARE(gripper.get("STA"), QByteArray("STA 0\n"));
    }
};

QTEST_GUILESS_MAIN(TestGripperService)
#include "tst_gripper_service.moc"
