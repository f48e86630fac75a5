// SPDX-License-Identifier: MIT
// Behaviour of a user program with an inserted watchdog thread, run in the simulator's interpreter.
#include <QTest>

#include "robot/script/supervised_program.h"
#include "robot/simulator/urscript/interpreter.h"
#include "tests/unit/robot/simulator/urscript/fake_host.h"

using namespace tiller;
using namespace tiller::script;
namespace urscript = tiller::simulator::urscript;

namespace {

constexpr SoftwareVersion kVersion{5, 22, 0, 0};
constexpr int kTimeoutFrames = 50;  ///< 100 ms

Heartbeat heartbeat() {
    Heartbeat out;
    out.number = 24;
    out.session = {28, 99};
    out.lastEpoch = {25, 7};
    out.expired = {26, 4321};
    out.timeout = std::chrono::milliseconds(100);
    return out;
}

/// A supervised program on a simulated robot.
struct Bench {
    urscript::FakeHost host;
    std::unique_ptr<urscript::Interpreter> program;

    explicit Bench(const QString& text) {
        host.intIn[25] = 7;
        host.intIn[28] = 99;
        urscript::CompileOptions options;
        options.version = kVersion;
        const auto compiled =
            urscript::compile(supervised(text, heartbeat(), kVersion).text.toStdString(), options);
        if (!compiled) {
            qFatal("line %d, column %d: %s", compiled.error.line, compiled.error.column,
                   compiled.error.text.c_str());
        }
        program = std::make_unique<urscript::Interpreter>(compiled.program, host);
    }
    /// Runs until the program ends, but at most the given number of frames. Returns the number of frames run.
    int run(int frames, bool alive) {
        for (int i = 0; i < frames; ++i) {
            host.intIn[24] += alive ? 1 : 0;
            program->runFrame();
            if (program->error()) {
                qFatal("line %d: %s", program->error()->line, program->error()->text.c_str());
            }
            if (program->ended()) {
                return i + 1;
            }
        }
        return frames;
    }
};

const QString kEndless = QStringLiteral("def endless():\n  while True:\n    sync()\n  end\nend\n");
const QString kMoving =
    QStringLiteral("def moving():\n  while True:\n    movej([0,0,0,0,0,0])\n  end\nend\n");

}  // namespace

class TestSupervisedProgram : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theGateCompilesOnEverySoftware() {
        using Type = GateVariable::Type;
        for (const SoftwareVersion& version : {SoftwareVersion{3, 15, 0, 0}, SoftwareVersion{5, 0, 0, 0},
                                               SoftwareVersion{5, 22, 0, 0}, SoftwareVersion{10, 12, 0, 0}}) {
            Heartbeat gated = heartbeat();
            gated.gate =
                GateInputs{27, 31, 24, {{"x", Type::Number}, {"n", Type::Whole}, {"ok", Type::Flag}}};
            const QString text =
                supervised(
                    "def p():\n  global x = 0.0\n  global n = 0\n  global ok = False\n  tiller_step(1)\n"
                    "  tiller_break(2)\n  n = tiller_turn(n + 1)\nend\n",
                    gated, version)
                    .text;
            urscript::CompileOptions options;
            options.version = version;
            const auto compiled = urscript::compile(text.toStdString(), options);
            QVERIFY2(compiled, compiled.error.text.c_str());
            QCOMPARE(text.count("tiller_take_change()"), 3);  // the definition, and before each wait
            // Without variables, the program only waits.
            gated.gate->variables.clear();
            QVERIFY(!supervised("def p():\n  tiller_step(1)\nend\n", gated, version).text.contains("change"));
        }
    }

    void aProgramEndsWithItsHeartbeat_data() {
        QTest::addColumn<QString>("program");
        QTest::newRow("loop") << kEndless;
        QTest::newRow("moves") << kMoving;
        QTest::newRow("bare lines") << QStringLiteral("while True:\n  sync()\nend\n");
        QTest::newRow("threads of its own") << QStringLiteral(
            "def own():\n  thread t():\n    while True:\n      sync()\n    end\n  end\n"
            "  h = run t()\n  join h\nend\n");
        QTest::newRow("in a critical section")
            << QStringLiteral("def critical():\n  enter_critical\n  while True:\n    sync()\n  end\nend\n");
        QTest::newRow("one line") << QStringLiteral("def one(): while True: sync() end end\n");
        QTest::newRow("first statement on the first line")
            << QStringLiteral("def first(): sync()\n  while True:\n    sync()\n  end\nend\n");
        QTest::newRow("long sleep") << QStringLiteral("def long():\n  sleep(1000)\nend\n");
    }
    void aProgramEndsWithItsHeartbeat() {
        QFETCH(QString, program);
        Bench bench(program);
        QCOMPARE(bench.run(300, true), 300);
        const int frames = bench.run(300, false);
        QVERIFY2(frames <= kTimeoutFrames + 2 && frames >= kTimeoutFrames - 2,
                 qPrintable(QString::number(frames)));
        QCOMPARE(bench.host.intOut[26], 4321);
    }

    void anotherClientsHeartbeatDoesNotCount() {
        Bench bench(kEndless);
        QCOMPARE(bench.run(300, true), 300);
        bench.host.intIn[28] = 100;
        QVERIFY(bench.run(300, true) <= kTimeoutFrames + 2);
    }

    // Some controllers may clear the inputs of a disconnected client, which also changes the number.
    void clearedRegistersAreNotAHeartbeat() {
        Bench bench(kEndless);
        QCOMPARE(bench.run(300, true), 300);
        bench.host.intIn[24] = bench.host.intIn[25] = bench.host.intIn[28] = 0;
        QVERIFY(bench.run(300, false) <= kTimeoutFrames + 2);
    }

    void stopEndsTheProgramAtOnce() {
        Bench bench(kMoving);
        bench.host.intOut[26] = 4321;  // left by an earlier program
        QCOMPARE(bench.run(300, true), 300);
        bench.host.intIn[25] = 8;
        QVERIFY(bench.run(300, true) <= 2);
        QCOMPARE(bench.host.intOut[26], 0);
    }

    void aCompletedProgramEnds() {
        Bench bench(QStringLiteral("def brief():\n  sync()\nend\n"));
        QVERIFY(bench.run(300, true) <= 3);
    }

    void supervisionFollowsTheWatchdogOfTheController() {
        const QString text = supervised(kEndless, heartbeat(), kVersion).text;
        QVERIFY(
            text.contains(QStringLiteral("rtde_set_watchdog(\"input_int_register_24\", 6.667, \"stop\")")));
    }

    void lineNumbersAreThoseOfTheUser_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("name");
        QTest::newRow("one") << "# a comment\ndef mine():\n  a = 1\n  b = 2\nend\n"
                             << "mine";
        QTest::newRow("two") << "def mine():\n  a = 1\nend\n\ndef other():\n  b = 2\n  c = 3\nend\n"
                             << "mine";
        QTest::newRow("statements around them") << "a = 1\nsync()\ndef mine():\n  b = 2\nend\nsync()\nc = 3\n"
                                                << "tiller_heartbeat_program";
        QTest::newRow("secondary first") << "sec quick():\n  a = 1\nend\ndef mine():\n  b = 2\nend\n"
                                         << "mine";
    }
    void lineNumbersAreThoseOfTheUser() {
        QFETCH(QString, text);
        QFETCH(QString, name);
        const SupervisedProgram made = supervised(text, heartbeat(), kVersion);
        QCOMPARE(made.name, name);
        const QStringList lines = made.text.split('\n');
        const QStringList own = text.split('\n');
        int found = 0;
        for (int line = 1; line <= lines.size(); ++line) {
            if (const int at = made.lineOf(line); at > 0) {
                QCOMPARE(lines[line - 1], own[at - 1]);
                ++found;
            }
        }
        QCOMPARE(found, own.size());
        QCOMPARE(made.lineOf(0), 0);
        QCOMPARE(made.lineOf(static_cast<int>(lines.size()) + 1), 0);
    }

    void bareLinesBecomeOneProgram() {
        Bench bench(
            QStringLiteral("# two\nset_standard_digital_out(1, True)\nsync()\n\n"
                           "set_standard_digital_out(2, True)\n"));
        QVERIFY(bench.run(300, true) < 10);
        QVERIFY(bench.host.pins[1] && bench.host.pins[2]);
    }

    void onlyPrimaryProgramsAreSupervised() {
        const auto count = [](const QString& text) {
            return supervised(text, heartbeat(), kVersion)
                .text.count(QStringLiteral("thread tiller_heartbeat"));
        };
        QCOMPARE(count(QStringLiteral("def a():\n  sync()\nend\ndef b():\n  sync()\nend\n")), 2);
        QCOMPARE(count(QStringLiteral("sec a():\n  set_standard_digital_out(1, True)\nend\n")), 0);
        QCOMPARE(count(QStringLiteral("sec a():\n  sync()\nend\nmovej([0,0,0,0,0,0])\n")), 1);
        // Programs for ur_rtde end in this way. The last line is not part of the program.
        const QString whole = QStringLiteral("def a():\n  sync()\nend\nrun program\n");
        QCOMPARE(count(whole), 1);
        QVERIFY(
            supervised(whole, heartbeat(), kVersion).text.endsWith(QStringLiteral("\nend\nrun program\n")));
        // Functions inside a program, and keywords in comments and strings, do not start a program.
        QCOMPARE(count(QStringLiteral(
                     "def a():\n  def f():\n    # end\n    textmsg(\"end def x():\")\n    if True:\n"
                     "      sync()\n    end\n  end\n  f()\nend # def\n\n")),
                 1);
        QCOMPARE(count(QStringLiteral("\r\ndef a():\r\n  sync()\r\nend\r\n")), 1);
    }

    void textIsUnchangedWithoutSupervision() {
        const SupervisedProgram made = unsupervised(kEndless);
        QCOMPARE(made.text, kEndless);
        QCOMPARE(made.lineOf(3), 3);
    }
};

QTEST_GUILESS_MAIN(TestSupervisedProgram)
#include "tst_supervised_program.moc"
