// SPDX-License-Identifier: MIT
// Port 30020 receives statements and commands as lines, and sends one reply per line.

#include <QTest>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

const char* const kMode = "def ready():\n  global n = 0\n  interpreter_mode()\n  n = -1\nend\n";

/// A robot in interpreter mode and a client connected to it.
struct Interpreting {
    VirtualRobot robot;
    RawPrimary primary = robot.primary();
    RawClient client{robot.host(), robot.controller.ports().interpreter};

    explicit Interpreting(const char* program = kMode) {
        primary.send(program);
        robot.stepUntil([this] { return robot.programState() == RuntimeState::Playing; });
        robot.controller.step(2);
    }
    QByteArray ask(const QByteArray& line) {
        client.send(line + '\n');
        return client.line();
    }
};

}  // namespace

class TestInterpreterService : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void withoutAProgramLinesAreDiscarded() {
        VirtualRobot robot;
        QVERIFY(robot.controller.ports().interpreter != 0);
        RawClient client(robot.host(), robot.controller.ports().interpreter);
        client.send("a = 1\n");
        QCOMPARE(client.line(), QByteArray("discard: no program is running: a = 1\n"));
        client.send("statelastexecuted\n");
        QCOMPARE(client.line(), QByteArray("state: 0: statelastexecuted\n"));
    }
    void statementsAreAcknowledgedAndRun() {
        Interpreting i;
        QCOMPARE(i.ask("set_standard_digital_out(3, True)"),
                 QByteArray("ack: 1: set_standard_digital_out(3, True)\n"));
        QCOMPARE(i.ask("stateunexecuted"), QByteArray("state: 1: stateunexecuted\n"));
        i.robot.controller.step(2);
        QCOMPARE(i.robot.controller.truth().digitalOutputs, 8ULL);
        QCOMPARE(i.ask("statelastexecuted"), QByteArray("state: 1: statelastexecuted\n"));
        QCOMPARE(i.ask("statelastinterpreted"), QByteArray("state: 1: statelastinterpreted\n"));
        QCOMPARE(i.ask("stateunexecuted"), QByteArray("state: 0: stateunexecuted\n"));
        QCOMPARE(i.robot.programState(), RuntimeState::Playing);
    }
    void uncompilableStatementsAreDiscardedWithTheReason() {
        Interpreting i;
        QCOMPARE(i.ask("nosuch(1)"), QByteArray("discard: compile_error_name_not_found:nosuch: nosuch(1)\n"));
        QCOMPARE(i.ask("a = 1\r"), QByteArray("ack: 1: a = 1\n"));
        QCOMPARE(i.ask("global g = 1"),
                 QByteArray("discard: new globals cannot be created in interpreter mode: global g = 1\n"));
    }
    void linesMayArriveTogetherOrInPieces() {
        Interpreting i;
        i.client.send("x = 1\n\n   \nx = x + 1\nset_standard_digital_o");
        QCOMPARE(i.client.line(), QByteArray("ack: 1: x = 1\n"));
        QCOMPARE(i.client.line(), QByteArray("ack: 2: x = x + 1\n"));
        i.client.send("ut(0, x == 2)\n");
        QCOMPARE(i.client.line(), QByteArray("ack: 3: set_standard_digital_out(0, x == 2)\n"));
        i.robot.controller.step(2);
        QCOMPARE(i.robot.controller.truth().digitalOutputs, 1ULL);
    }
    void movesRunInOrderAndCanBeAborted() {
        Interpreting i;
        const double start = i.robot.controller.truth().q[0];
        i.ask("movej([-0.5,-1.7,-2.2,-0.8,1.6,0], a=1, v=0.3)");
        i.ask("set_standard_digital_out(7, True)");
        i.robot.controller.stepSeconds(1.5);
        QVERIFY(i.robot.controller.truth().q[0] > start + 0.1);
        QCOMPARE(i.robot.controller.truth().digitalOutputs, 0ULL);
        i.ask("abort");
        i.robot.controller.stepSeconds(0.5);
        const double stopped = i.robot.controller.truth().q[0];
        QVERIFY(stopped < -0.8);
        QCOMPARE(i.robot.controller.truth().digitalOutputs, 128ULL);
        i.robot.controller.stepSeconds(0.5);
        QVERIFY(std::abs(i.robot.controller.truth().q[0] - stopped) < 1e-3);
        QCOMPARE(i.robot.programState(), RuntimeState::Playing);
    }
    void skippedStatementsDoNotRun() {
        Interpreting i;
        i.ask("sleep(0.1)");
        i.ask("set_standard_digital_out(1, True)");
        i.robot.controller.step(2);
        QCOMPARE(i.ask("skipbuffer").left(6), QByteArray("state:"));
        i.robot.controller.stepSeconds(0.3);
        QCOMPARE(i.robot.controller.truth().digitalOutputs, 0ULL);
    }
    void statementsAfterAClearWaitForIt() {
        Interpreting i;
        i.client.send("a = 1\nclear_interpreter()\nb = 2\nb = a\n");
        QCOMPARE(i.client.line(), QByteArray("ack: 1: a = 1\n"));
        QCOMPARE(i.client.line(), QByteArray("ack: 2: clear_interpreter()\n"));
        i.robot.controller.drainSockets();
        QCOMPARE(i.client.takeAll(), QByteArray());
        i.robot.controller.step(2);
        QCOMPARE(i.client.line(), QByteArray("ack: 3: b = 2\n"));
        QCOMPARE(i.client.line(), QByteArray("discard: compile_error_name_not_found:a: b = a\n"));
        QCOMPARE(i.ask("statelastcleared"), QByteArray("state: 2: statelastcleared\n"));
    }
    void endInterpreterLetsTheProgramEnd() {
        Interpreting i;
        i.ask("end_interpreter()");
        QVERIFY(i.robot.stepUntil([&] { return i.robot.programState() == RuntimeState::Stopped; }));
        QCOMPARE(i.ask("a = 1"), QByteArray("discard: no program is running: a = 1\n"));
    }
    void newProgramRestartsTheCount() {
        Interpreting i;
        i.ask("a = 1");
        i.primary.send(kMode);
        i.robot.controller.drainSockets();
        i.robot.controller.step(3);
        QCOMPARE(i.ask("a = 1"), QByteArray("ack: 1: a = 1\n"));
    }
    void aRunTimeErrorIsShownToPrimaryClients() {
        Interpreting i;
        i.primary.takeAll();
        i.ask("b = [1][4]");
        QVERIFY(i.robot.stepUntil([&] { return i.robot.programState() == RuntimeState::Stopped; }));
        QVERIFY(!i.primary.messages(10).empty());
    }
    void aFloodOfLinesIsAnsweredInOrder() {
        Interpreting i;
        i.ask("n = 0");
        QByteArray flood;
        for (int k = 0; k < 500; ++k) {
            flood += "n = n + 1\n";
        }
        i.client.send(flood);
        for (int k = 0; k < 500; ++k) {
            QCOMPARE(i.client.line(), "ack: " + QByteArray::number(k + 2) + ": n = n + 1\n");
        }
        i.robot.controller.step(10);
        i.ask("write_output_integer_register(0, n)");
        i.robot.controller.step(2);
        QCOMPARE(i.ask("set_standard_digital_out(0, read_output_integer_register(0) == 500)").left(4),
                 QByteArray("ack:"));
        i.robot.controller.step(2);
        QCOMPARE(i.robot.controller.truth().digitalOutputs, 1ULL);
    }
    void aBareStatementEntersTheModeToo() {
        VirtualRobot robot;
        RawPrimary primary = robot.primary();
        primary.send("def p():\n  while True:\n    sync()\n  end\nend\n");
        robot.stepUntil([&] { return robot.programState() == RuntimeState::Playing; });
        primary.send("interpreter_mode()\n");
        robot.controller.drainSockets();
        robot.controller.step(5);
        RawClient client(robot.host(), robot.controller.ports().interpreter);
        client.send("a = 1\n");
        QCOMPARE(client.line(), QByteArray("ack: 1: a = 1\n"));
    }
    void twoClientsShareTheSession() {
        Interpreting i;
        RawClient other(i.robot.host(), i.robot.controller.ports().interpreter);
        QCOMPARE(i.ask("v = 4"), QByteArray("ack: 1: v = 4\n"));
        other.send("set_standard_digital_out(v, True)\n");
        QCOMPARE(other.line(), QByteArray("ack: 2: set_standard_digital_out(v, True)\n"));
        i.robot.controller.step(2);
        QCOMPARE(i.robot.controller.truth().digitalOutputs, 16ULL);
    }
    void anEndlessLineIsRefused() {
        Interpreting i;
        i.client.send(QByteArray(100'000, 'a'));
        QVERIFY(i.client.line().startsWith("discard: line is too long: aaaa"));
        QCOMPARE(i.ask("\nb = 1"), QByteArray("ack: 1: b = 1\n"));
    }
    void aGatedRobotRefusesStatementsInLocalControl() {
        simulator::SimulatorOptions options = VirtualRobot::options();
        options.remoteControl = false;
        options.gateLocalControl = true;
        VirtualRobot robot(options);
        RawClient client(robot.host(), robot.controller.ports().interpreter);
        client.send("a = 1\n");
        QCOMPARE(client.line(), QByteArray("discard: the robot is in local control: a = 1\n"));
    }
    void softwareWithoutTheModeHasNoInterpreterPort() {
        simulator::SimulatorOptions options = VirtualRobot::options();
        options.software = {5, 9, 4, 0};
        VirtualRobot robot(options);
        QVERIFY(robot.started);
        QCOMPARE(robot.controller.ports().interpreter, quint16(0));
    }
};

QTEST_GUILESS_MAIN(TestInterpreterService)
#include "tst_interpreter_service.moc"
