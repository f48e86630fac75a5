// SPDX-License-Identifier: MIT
// Frames, threads, critical sections, motion ownership, secondary programs, external control.

#include "tests/unit/robot/simulator/urscript/script_run.h"

using namespace tiller::simulator::urscript;
using State = Interpreter::State;

class tst_Scheduling : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // ---- time
    void aLoopWithSyncRunsOncePerFrame() {
        ScriptRun run("def m():\nn = 0\nwhile True:\nn = n + 1\nsync()\nend\nend\n");
        run.frames(10);
        QCOMPARE(run.value("n"), "10");
    }
    void statementsTakeNoTime() {
        ScriptRun run("def m():\ni = 0\nwhile i < 1000:\ni = i + 1\nend\nend\n");
        QCOMPARE(run.frames(1), State::Finished);
    }
    void sleepTakesItsTime() {
        ScriptRun run(
            "def m():\nx = 0\nsleep(1.0)\nx = 1\nsleep(0.003)\nx = 2\nsleep(0)\nx = 3\nsync()\nend\n");
        run.frames(500);
        QCOMPARE(run.value("x"), "0");
        run.frames(1);
        QCOMPARE(run.value("x"), "1");
        run.frames(1);
        QCOMPARE(run.value("x"), "3");
    }
    void shortSleepsAddUp() {
        ScriptRun run("def m():\nn = 0\nwhile True:\nn = n + 1\nsleep(0.0005)\nend\nend\n");
        run.frames(10);
        QCOMPARE(run.value("n"), "40");
    }
    void sleepFollowsTheStepTime() {
        ScriptRun run;
        run.host.step = 0.008;
        run.load("def m():\nx = 0\nsleep(0.8)\nx = 1\nsync()\nend\n");
        run.frames(100);
        QCOMPARE(run.value("x"), "0");
        run.frames(1);
        QCOMPARE(run.value("x"), "1");
    }
    void threadWithTheMostRemainingTimeRunsFirst() {
        // The main body has used half of its time slice while the thread still has its full slice.
        ScriptRun run(
            "def m():\n order = \"\"\n thread t():\n order = order + \"t\"\n sync()\n order = order + \"t\"\n"
            " end\n h = run t()\n sleep(0.001)\n order = order + \"m\"\n sleep(0.002)\n"
            " order = order + \"m\"\nend\n");
        run.frames(1);
        QCOMPARE(run.value("order"), "tm");
        run.frames(2);
        QCOMPARE(run.value("order"), "tmtm");
    }
    void theMainProgramUsesValuesCopiedByItsThread() {
        // Structured like the vendor's example of an RTDE control loop.
        const std::string text =
            "def m():\n setp = 0\n done = 0\n thread copy():\n while True:\n"
            " setp = read_input_float_register(0)\n sync()\n end\n end\n run copy()\n"
            " while True:\n if read_input_integer_register(0) > done:\n"
            " done = read_input_integer_register(0)\n executed = setp\n end\n sync()\n end\nend\n";
        const auto executed = [&](bool mainFirst) {
            Limits limits;
            limits.mainFirst = mainFirst;
            ScriptRun run(text, limits);
            std::string all;
            run.frames(2);
            for (int i = 1; i <= 3; ++i) {
                run.host.floatIn[0] = 10.0 * i;
                run.host.intIn[0] = i;
                run.frames(1);
                all += run.value("executed") + " ";
            }
            return all;
        };
        QCOMPARE(executed(false), "10 20 30 ");
        QCOMPARE(executed(true), "0 10 20 ");
    }
    void threadsKeepTheirOrderAmongThemselves() {
        ScriptRun run(
            "def m():\n order = \"\"\n thread a():\n while True:\n order = order + \"a\"\n sync()\n end\n "
            "end\n"
            " thread b():\n while True:\n order = order + \"b\"\n sync()\n end\n end\n"
            " run a()\n run b()\n while True:\n order = order + \"m\"\n sync()\n end\nend\n");
        run.frames(3);
        QCOMPARE(run.value("order"), "mababmabm");
    }
    void aLoopThatTakesNoTimeIsAnError() {
        ScriptRun run("def m():\n  while True:\n    x = 1\n  end\nend\n");
        QCOMPARE(run.frames(1), State::Failed);
        QVERIFY(run.error().find("infinite loop") != std::string::npos);
        QVERIFY(run.interpreter->error()->line == 2 || run.interpreter->error()->line == 3);
        QCOMPARE(run.host.ended, 1);
    }
    void theBudgetIsPerFrameAndDeterministic() {
        Limits limits;
        limits.threadOperationsPerFrame = 1000;
        const std::string text =
            "def m():\nn = 0\nwhile True:\nn = n + 1\nif n % 50 == 0:\nsync()\nend\nend\nend\n";
        ScriptRun run(text, limits);
        QCOMPARE(run.frames(100), State::Running);
        QCOMPARE(run.value("n"), "5000");
        limits.threadOperationsPerFrame = 200;
        ScriptRun tight(text, limits);
        QCOMPARE(tight.frames(1), State::Failed);
    }
    void startingThreadsForeverIsAnError() {
        ScriptRun run("def m():\nthread t():\nend\nwhile True:\nh = run t()\njoin h\nend\nend\n");
        QCOMPARE(run.frames(1), State::Failed);
        ScriptRun many("def m():\nthread t():\nsleep(1)\nend\nwhile True:\nh = run t()\nend\nend\n");
        QCOMPARE(many.frames(1), State::Failed);
        QCOMPARE(many.error(), "Too many threads");
    }

    // ---- threads
    void threadsShareGlobalsAndHaveTheirOwnLocals() {
        ScriptRun run(
            "def m():\nn = 0\nthread t():\ni = 0\nwhile i < 3:\ni = i + 1\nn = n + 1\nsync()\nend\nend\n"
            "a = run t()\nb = run t()\njoin a\njoin b\nend\n");
        QCOMPARE(run.frames(20), State::Finished);
        QCOMPARE(run.value("n"), "6");
    }
    void handlesCompareWithZero() {
        ScriptRun run(
            "def m():\nh = 0\nwas = h == 0\nthread t():\nsync()\nh = 0\nend\nh = run t()\nis = h != 0\n"
            "sync()\nsync()\nsync()\nend\n");
        run.frames(10);
        QCOMPARE(run.value("was"), "True");
        QCOMPARE(run.value("is"), "True");
        QCOMPARE(run.value("h"), "0");
    }
    void joinWaitsAndInvalidHandlesAreHarmless() {
        ScriptRun run(
            "def m():\nx = 0\nthread t():\nsleep(0.01)\nx = 1\nend\nh = run t()\njoin h\ny = x\njoin h\nkill "
            "h\n"
            "join 0\nkill 0\nkill 99\njoin -1\nz = 1\nend\n");
        QCOMPARE(run.frames(5), State::Running);
        QCOMPARE(run.frames(2), State::Finished);
        QCOMPARE(run.value("y"), "1");
        QCOMPARE(run.value("z"), "1");
    }
    void killEndsAThreadAndTheThreadsItStarted() {
        ScriptRun run(
            "def m():\na = 0\nb = 0\nthread inner():\nwhile True:\nb = b + 1\nsync()\nend\nend\n"
            "thread outer():\nh = run inner()\nwhile True:\na = a + 1\nsync()\nend\nend\n"
            "k = run outer()\nsleep(0.01)\nkill k\nwhile True:\nsync()\nend\nend\n");
        run.frames(6);
        const std::string a = run.value("a");
        const std::string b = run.value("b");
        QVERIFY(std::stoi(a) >= 5 && std::stoi(b) >= 5);
        run.frames(10);
        QCOMPARE(run.value("a"), a);
        QCOMPARE(run.value("b"), b);
        QCOMPARE(run.interpreter->threadCount(), 1);
    }
    void killReachesThreadsOfThreadsThatEnded() {
        ScriptRun run(
            "def m():\nb = 0\nthread inner():\nwhile True:\nb = b + 1\nsync()\nend\nend\n"
            "thread middle():\nh = run inner()\nend\nthread outer():\ng = run middle()\nwhile "
            "True:\nsync()\nend\n"
            "end\nk = run outer()\nsleep(0.01)\nkill k\nwhile True:\nsync()\nend\nend\n");
        run.frames(8);
        QCOMPARE(run.interpreter->threadCount(), 1);
    }
    void threadsEndWithTheMainBody() {
        ScriptRun run(
            "def m():\nn = 0\nthread t():\nwhile True:\nn = n + 1\nsync()\nend\nend\nh = run "
            "t()\nsleep(0.01)\nend\n");
        QCOMPARE(run.frames(20), State::Finished);
        QVERIFY(std::stoi(run.value("n")) <= 6);
        QCOMPARE(run.host.ended, 1);
    }
    void haltInAThreadEndsTheProgram() {
        ScriptRun run(
            "def m():\nthread t():\nenter_critical\nhalt\nend\nh = run t()\nwhile True:\nsync()\nend\nend\n");
        QCOMPARE(run.frames(3), State::Finished);
    }
    void errorsInAThreadEndTheProgram() {
        ScriptRun run(
            "def m():\nthread t():\nx = sqrt(-1)\nend\nh = run t()\nwhile True:\nsync()\nend\nend\n");
        QCOMPARE(run.frames(3), State::Failed);
        QCOMPARE(run.interpreter->error()->line, 3);
    }

    // ---- critical sections
    void blockingInACriticalSectionLetsOthersRun() {
        ScriptRun run(
            "def m():\nn = 0\nthread t():\nwhile True:\nenter_critical\nn = n + "
            "1\nsync()\nexit_critical\nend\nend\n"
            "h = run t()\nok = socket_open(\"127.0.0.1\", 50001, \"s\")\nwhile True:\nenter_critical\n"
            "v = socket_read_binary_integer(1, \"s\", 0)\nexit_critical\nend\nend\n");
        run.frames(50);
        QVERIFY(std::stoi(run.value("n")) >= 49);
        run.host.sockets["s"].in = std::string("\0\0\0\7", 4);
        run.frames(1);
        QCOMPARE(run.value("v"), "[1, 7]");
    }
    void killInsideACriticalSectionFreesIt() {
        ScriptRun run(
            "def m():\nthread t():\nenter_critical\nwhile True:\nsync()\nend\nend\nh = run t()\nsync()\nkill "
            "h\n"
            "enter_critical\nx = 1\nexit_critical\nend\n");
        QCOMPARE(run.frames(5), State::Finished);
        QCOMPARE(run.value("x"), "1");
    }

    // ---- motion
    void movesBlockOnlyTheirThread() {
        ScriptRun run(
            "def m():\nn = 0\nthread t():\nwhile True:\nn = n + 1\nsync()\nend\nend\nh = run t()\n"
            "movej([0,0,0,0,0,0])\nend\n");
        run.host.moveFrames = 20;
        QCOMPARE(run.frames(20), State::Running);
        QCOMPARE(run.frames(1), State::Finished);
        QCOMPARE(run.value("n"), "21");  // includes the last period of the main program
    }
    void servoTakesOneFrameEach() {
        ScriptRun run("def m():\nwhile True:\nservoj([0,0,0,0,0,0], t=0.002)\nend\nend\n");
        run.frames(50);
        QCOMPARE(run.host.motions.size(), 50u);
    }
    void reducedSpeedStretchesDurations() {
        ScriptRun run("def m():\nwhile True:\nspeedj([0,0,0,0,0,0], 1, 0.002)\nend\nend\n");
        run.host.durationScale = 4;
        run.frames(40);
        QCOMPARE(run.host.motions.size(), 10u);
    }
    void twoThreadsMayNotCommandAtOnce() {
        ScriptRun run(
            "def m():\nthread t():\nmovej([0,0,0,0,0,0])\nend\nh = run "
            "t()\nsync()\nmovej([1,1,1,1,1,1])\nend\n");
        QCOMPARE(run.frames(3), State::Failed);
        QCOMPARE(run.error(), "Another thread is already controlling the robot");
        QCOMPARE(run.interpreter->error()->line, 7);
    }
    void aKilledMovePermitsAStop() {
        ScriptRun run(
            "def m():\nthread t():\nmovej([0,0,0,0,0,0])\nend\nh = run t()\nsync()\nkill h\nstopj(4)\nend\n");
        run.host.moveFrames = 3;
        QCOMPARE(run.frames(6), State::Finished);
        QCOMPARE(run.host.abandoned, std::vector<ThreadId>{1});
        QVERIFY(std::holds_alternative<StopJ>(run.host.motions.back().command));
        QCOMPARE(run.host.motions.back().thread, 0);
    }
    void finishedMotionFreesTheArmBeforeThreadsRun() {
        // The servo command of the thread that was started last has already ended when the main body stops,
        // because the main body runs first in the frame.
        ScriptRun run(
            "def m():\nthread t():\nservoj([0,0,0,0,0,0], t=0.002)\nwhile True:\nsync()\nend\nend\nh = run "
            "t()\n"
            "sync()\nstopj(1)\nend\n");
        run.host.moveFrames = 1;
        QCOMPARE(run.frames(4), State::Finished);
        QCOMPARE(run.host.motions.size(), 2u);
    }
    void motionErrorsEndTheProgramAtTheCommand() {
        ScriptRun run("def m():\nx = 1\n\n  movel(p[9,0,0,0,0,0])\nend\n");
        run.frames(2);
        run.host.motionError = "no inverse kinematics on the path";
        QCOMPARE(run.frames(1), State::Failed);
        QCOMPARE(run.interpreter->error()->line, 4);
        QCOMPARE(run.interpreter->error()->column, 3);
        QCOMPARE(run.error(), "no inverse kinematics on the path");
    }
    void currentLineFollowsTheMainBody() {
        ScriptRun run("def m():\nx = 1\nmovej([0,0,0,0,0,0])\nsync()\nsync()\nend\n");
        QCOMPARE(run.interpreter->currentLine(), 0);
        run.frames(1);
        QCOMPARE(run.interpreter->currentLine(), 3);
        run.frames(5);
        QCOMPARE(run.interpreter->currentLine(), 4);
    }

    // ---- popups and requests
    void blockingPopupsBlockTheirThread() {
        ScriptRun run("def m():\npopup(\"hello<br/>you\", title=\"T\", blocking=True)\nx = 1\nsync()\nend\n");
        run.frames(100);
        QCOMPARE(run.value("x"), "(unset)");
        QCOMPARE(run.host.popups.size(), 1u);
        run.host.popupAnswered = true;
        run.frames(1);
        QCOMPARE(run.value("x"), "1");
    }
    void threadsWaitForRequestedValues() {
        ScriptRun run("def m():\nx = request_integer_from_primary_client(\"how many?\")\nend\n");
        QCOMPARE(run.frames(10), State::Running);
        run.host.answer = std::int32_t{5};
        QCOMPARE(run.frames(1), State::Finished);
        QCOMPARE(run.value("x"), "5");
    }

    // ---- external control
    void pauseFreezesAndResumeContinues() {
        ScriptRun run("def m():\nn = 0\nwhile True:\nn = n + 1\nsleep(0.004)\nend\nend\n");
        run.frames(4);
        run.interpreter->pause();
        QCOMPARE(run.frames(100), State::Paused);
        QCOMPARE(run.value("n"), "2");
        run.interpreter->resume();
        run.frames(2);
        QCOMPARE(run.value("n"), "3");
    }
    void pauseStatementPausesTheProgram() {
        ScriptRun run("def m():\nx = 1\npause\nx = 2\nsync()\nend\n");
        QCOMPARE(run.frames(1), State::Paused);
        QCOMPARE(run.value("x"), "1");
        run.interpreter->resume();
        run.frames(1);
        QCOMPARE(run.value("x"), "2");
    }
    void protectiveStopLetsTheFrameEnd() {
        // Clients expect that the one-line program has ended, although the robot is stopped.
        ScriptRun run("def m():\nprotective_stop()\nend\n");
        run.host.onProtectiveStop = [&] { run.interpreter->pause(); };
        QCOMPARE(run.frames(1), State::Finished);
        ScriptRun longer("def m():\nprotective_stop()\nx = 1\nsync()\nx = 2\nend\n");
        longer.host.onProtectiveStop = [&] { longer.interpreter->pause(); };
        QCOMPARE(longer.frames(5), State::Paused);
        QCOMPARE(longer.value("x"), "1");
    }
    void stopEndsTheProgramOnce() {
        ScriptRun run("def m():\nwhile True:\nsync()\nend\nend\n");
        run.frames(3);
        run.interpreter->stop();
        QVERIFY(run.interpreter->state() == State::Stopped);
        run.interpreter->stop();
        QCOMPARE(run.interpreter->runFrame(), State::Stopped);
        run.interpreter.reset();
        QCOMPARE(run.host.ended, 1);
    }
    void stopFromInsideAFrameWorks() {
        ScriptRun run("def m():\nprotective_stop()\nx = 1\nsync()\nend\n");
        run.host.onProtectiveStop = [&] { run.interpreter->stop(); };
        QCOMPARE(run.frames(2), State::Stopped);
        QCOMPARE(run.value("x"), "(unset)");
        QCOMPARE(run.host.ended, 1);
    }
    void destructionNotifiesTheHost() {
        ScriptRun run("def m():\nwhile True:\nsync()\nend\nend\n");
        run.frames(1);
        run.interpreter.reset();
        QCOMPARE(run.host.ended, 1);
        ScriptRun never("def m():\nend\n");
        never.interpreter.reset();
        QCOMPARE(never.host.ended, 0);
    }
    void programsRunSeveralTimesIndependently() {
        const CompileOutcome outcome = compile("def m():\nl = [1,2]\nl[0] = l[0] + 1\ns = \"a\"\nend\n");
        for (int i = 0; i < 2; ++i) {
            FakeHost host;
            Interpreter interpreter(outcome.program, host);
            interpreter.runFrame();
            QCOMPARE(toStr(*interpreter.global("l")), "[2, 2]");
        }
    }

    // ---- secondary programs
    void secondaryProgramsFinishInOneFrame() {
        ScriptRun run("sec setup():\nset_payload(1.0, [0, 0, 0.1])\nend\n");
        QCOMPARE(run.frames(1), State::Finished);
        QCOMPARE(run.host.load.mass, 1.0);
    }
    void secondaryProgramsMayNotTakeTime_data() {
        QTest::addColumn<QString>("statement");
        for (const char* s : {"sync()", "sleep(0.001)", "movej([0,0,0,0,0,0])", "x = socket_read_line(\"s\")",
                              "popup(\"a\", blocking=True)", "x = run t()", "pause"}) {
            QTest::newRow(s) << s;
        }
    }
    void secondaryProgramsMayNotTakeTime() {
        QFETCH(QString, statement);
        ScriptRun run("sec s():\nthread t():\nend\n" + statement.toStdString() + "\nend\n");
        run.host.sockets["s"].state = SocketHost::State::Open;
        QCOMPARE(run.frames(1), State::Failed);
        QCOMPARE(run.error(), "Runtime is too much behind");
        QVERIFY(run.host.motions.empty());
    }
    void secondaryProgramsMayStopTheRobot() {
        ScriptRun run("sec s():\nprotective_stop()\nend\n");
        QCOMPARE(run.frames(1), State::Finished);
    }
};

QTEST_GUILESS_MAIN(tst_Scheduling)
#include "tst_scheduling.moc"
