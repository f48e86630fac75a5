// SPDX-License-Identifier: MIT
// Interpreter mode: lines run inside a program, in order, with the program's variables.

#include "robot/simulator/urscript/interpreter_mode.h"

#include "tests/unit/robot/simulator/urscript/script_run.h"

using namespace tiller::simulator::urscript;
using Kind = InterpreterMode::Reply::Kind;

namespace {

const char* const kHost =
    "def host():\n global shared = 1\n def twice(x, by=2): return x * by end\n"
    " thread counter():\n while True:\n shared = shared + 1\n sync()\n end\n end\n"
    " interpreter_mode()\n after = True\nend\n";

struct Session : ScriptRun {
    explicit Session(const std::string& program = kHost, const Limits& limits = {})
        : ScriptRun(program, limits) {
        frames(1);
    }
    InterpreterMode& mode() { return interpreter->mode(); }
    /// Submits a line. Returns "ack 3", "discard <reason>" or "wait".
    std::string line(const std::string& text) {
        const InterpreterMode::Reply reply = mode().submit(text);
        return reply.kind == Kind::Ack       ? "ack " + std::to_string(reply.id)
               : reply.kind == Kind::Discard ? "discard " + reply.reason
                                             : "wait";
    }
};

}  // namespace

class tst_InterpreterMode : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void linesAreRefusedOutsideTheMode() {
        ScriptRun run("def p():\n sleep(1)\nend\n");
        run.frames(1);
        QVERIFY(run.interpreter->mode().submit("a = 1").kind == Kind::Discard);
        QCOMPARE(run.interpreter->mode().submit("a = 1").reason, "program is not in interpreter mode");
    }
    void idsCountFromOne() {
        Session s;
        QCOMPARE(s.line("a = 1"), "ack 1");
        QCOMPARE(s.line("a = a + 1"), "ack 2");
        QCOMPARE(s.line("textmsg(a)"), "ack 3");
        QCOMPARE(s.mode().counts().unexecuted, 3u);
        QCOMPARE(s.mode().counts().lastExecuted, 0u);
        s.frames(1);
        QCOMPARE(s.host.lastMessage(), "2");
        QCOMPARE(s.mode().counts().unexecuted, 0u);
        QCOMPARE(s.mode().counts().lastExecuted, 3u);
        QCOMPARE(s.mode().counts().lastInterpreted, 3u);
    }
    void linesCanUseProgramVariablesAndFunctions() {
        Session s;
        QCOMPARE(s.line("shared = twice(shared + 4)"), "ack 1");
        QCOMPARE(s.line("textmsg(twice(by=3, x=shared))"), "ack 2");
        s.frames(1);
        QCOMPARE(s.value("shared"), "10");
        QCOMPARE(s.host.lastMessage(), "30");
    }
    void newGlobalsCannotBeCreated() {
        Session s;
        QCOMPARE(s.line("global fresh = 1"), "discard new globals cannot be created in interpreter mode");
        QCOMPARE(s.line("global shared = 7"), "ack 1");
        s.frames(1);
        QCOMPARE(s.value("shared"), "7");
    }
    void badLinesAreDiscardedWithoutEffect() {
        Session s;
        QCOMPARE(s.line("nosuch()"), "discard compile_error_name_not_found:nosuch:");
        QCOMPARE(s.line("x ="), "discard syntax_error_on_line:1:x =:");
        QCOMPARE(s.line("if True:"), "discard syntax_error_on_line:1:if True::");
        QCOMPARE(s.line("textmsg(unset)"), "discard compile_error_name_not_found:unset:");
        QCOMPARE(s.line("textmsg(1)"), "ack 1");
        QCOMPARE(s.frames(3), Interpreter::State::Running);
        QCOMPARE(s.host.lastMessage(), "1");
    }
    void functionsAreDefinedOnOneLine() {
        Session s;
        QCOMPARE(s.line("def f(a, b=1): return a + b end"), "ack 1");
        QCOMPARE(s.line("textmsg(f(1) * 10 + f(a=1, b=4))"), "ack 2");
        s.frames(1);
        QCOMPARE(s.host.lastMessage(), "25");
        QCOMPARE(s.line("def f(a): return 100 * a end"),
                 "ack 3");  // redefined, so the newest definition is used
        QCOMPARE(s.line("textmsg(f(2))"), "ack 4");
        s.frames(1);
        QCOMPARE(s.host.lastMessage(), "200");
    }
    void linesThatTakeTimeDelayFollowingLines() {
        Session s;
        s.line("movej([0,0,0,0,0,0])");
        s.line("textmsg(\"there\")");
        s.frames(3);
        QVERIFY(s.host.messages.empty());
        QCOMPARE(s.mode().counts().lastExecuted, 1u);
        QCOMPARE(s.mode().counts().unexecuted, 1u);
        s.frames(s.host.moveFrames);
        QCOMPARE(s.host.lastMessage(), "there");
    }
    void skippedLinesNeverRun() {
        Session s;
        s.line("movej([0,0,0,0,0,0])");
        s.line("def g(): return 5 end");
        s.line("textmsg(\"no\")");
        s.frames(1);
        s.mode().skip();
        QCOMPARE(s.mode().counts().unexecuted, 0u);
        QCOMPARE(s.line("textmsg(g())"), "ack 4");
        s.frames(20);
        QCOMPARE(s.host.messages, std::vector<std::string>{"5"});
    }
    void abortEndsAMoveWithAStop() {
        Session s;
        s.host.moveFrames = 1000;
        s.line("movel(p[0,0,0,0,0,0])");
        s.line("textmsg(\"next\")");
        s.frames(5);
        s.host.moveFrames = 3;
        s.mode().abortMove();
        s.frames(6);
        QCOMPARE(s.host.motions.size(), std::size_t(2));
        QVERIFY(std::holds_alternative<StopJ>(s.host.motions[1].command));
        QCOMPARE(s.host.lastMessage(), "next");
    }
    void abortAffectsOnlyMoves() {
        Session s;
        s.host.moveFrames = 20;
        s.line("stopj(1)");
        s.frames(2);
        s.mode().abortMove();
        s.frames(5);
        QCOMPARE(s.host.motions.size(), std::size_t(1));
        s.frames(20);
        s.mode().abortMove();  // no line is running
        s.frames(2);
        QCOMPARE(s.host.motions.size(), std::size_t(1));
    }
    void endInterpreterLetsTheProgramContinue() {
        Session s;
        s.line("end_interpreter()");
        QCOMPARE(s.frames(2), Interpreter::State::Finished);
        QCOMPARE(s.value("after"), "True");
    }
    void theProgramMayEndTheModeFromAThread() {
        Session s(
            "def p():\n thread t():\n sleep(0.01)\n end_interpreter()\n end\n h = run t()\n"
            " interpreter_mode()\nend\n");
        QCOMPARE(s.frames(20), Interpreter::State::Finished);
    }
    void clearingRemovesDefinitionsOfLines() {
        Session s;
        s.line("v = 3");
        s.line("def f(): return v end");
        s.frames(1);
        QCOMPARE(s.line("clear_interpreter()"), "ack 3");
        QCOMPARE(s.line("textmsg(f())"), "wait");  // waits until the queue is cleared
        s.frames(1);
        QCOMPARE(s.mode().counts().lastCleared, 3u);
        QCOMPARE(s.line("textmsg(f())"), "discard compile_error_name_not_found:f:");
        QCOMPARE(s.line("textmsg(v)"), "discard compile_error_name_not_found:v:");
        QCOMPARE(s.line("v = \"a string now\""), "ack 4");
        QCOMPARE(s.line("textmsg(v)"), "ack 5");
        s.frames(1);
        QCOMPARE(s.host.lastMessage(), "a string now");
    }
    void unreachedClearingBlocksNothing() {
        Session s;
        s.line("if False: clear_interpreter() end");
        QCOMPARE(s.line("a = 1"), "wait");
        s.frames(1);
        QCOMPARE(s.line("a = 1"), "ack 2");
    }
    void clearingEndsThreadsThatRunInLines() {
        Session s;
        s.line("thread t(): while True: sync() end end");
        s.line("h = run t()");
        s.line("k = run counter()");  // defined by the program, so it is kept
        s.frames(2);
        QCOMPARE(s.interpreter->threadCount(), 3);
        s.line("clear_interpreter()");
        s.frames(2);
        QCOMPARE(s.interpreter->threadCount(), 2);
    }
    void aLineMayClearFromAFunctionItDefined() {
        Session s;
        s.line("def f(): clear_interpreter() return 6 end");
        s.frames(1);
        QCOMPARE(s.line("textmsg(f())"), "ack 2");
        QCOMPARE(s.frames(3), Interpreter::State::Running);
        QCOMPARE(s.host.lastMessage(), "6");
        QCOMPARE(s.line("x = f()"), "discard compile_error_name_not_found:f:");
    }
    void withoutClearOnEndTheNextSessionContinues() {
        const char* const kTwice =
            "def p():\n interpreter_mode(True, False)\n sync()\n interpreter_mode(clearQueueOnEnter=False)\n"
            "end\n";
        Session s(kTwice);
        s.line("v = 8");
        s.line("end_interpreter()");
        s.line("textmsg(\"left over\")");
        s.frames(3);
        QCOMPARE(s.host.lastMessage(), "left over");
        QCOMPARE(s.line("textmsg(v)"), "ack 4");
        s.frames(1);
        QCOMPARE(s.host.lastMessage(), "8");
    }
    void withClearOnEndNoLinesRemain() {
        Session s(
            "def p():\n interpreter_mode()\n sync()\n interpreter_mode(clearQueueOnEnter=False)\nend\n");
        s.line("v = 8");
        s.line("end_interpreter()");
        s.line("textmsg(\"left over\")");
        s.frames(4);
        QVERIFY(s.host.messages.empty());
        QCOMPARE(s.line("textmsg(v)"), "discard compile_error_name_not_found:v:");
    }
    void onlyTheMainThreadOfAMainProgramMayEnter() {
        ScriptRun thread("def p():\n thread t():\n interpreter_mode()\n end\n h = run t()\n sleep(1)\nend\n");
        QCOMPARE(thread.frames(3), Interpreter::State::Failed);
        QCOMPARE(thread.error(), "interpreter_mode: only the main thread can enter interpreter mode");
        ScriptRun secondary("sec s():\n interpreter_mode()\nend\n");
        QCOMPARE(secondary.frames(1), Interpreter::State::Failed);
        Session nested;
        nested.line("interpreter_mode()");
        QCOMPARE(nested.frames(2), Interpreter::State::Failed);
        QCOMPARE(nested.error(), "interpreter_mode: interpreter mode is already active");
    }
    void anErrorInALineEndsTheProgramWithItsPosition() {
        Session s;
        s.line("a = [1,2]");
        s.line("b = a[5]");
        QCOMPARE(s.frames(2), Interpreter::State::Failed);
        QCOMPARE(s.interpreter->error()->line, 1);
        QCOMPARE(s.interpreter->error()->column, 6);
    }
    void aThousandLinesAreDistributedOverFrames() {
        Session s;
        s.line("n = 0");
        for (int i = 0; i < 1000; ++i) {
            s.line("n = n + 1");
        }
        s.frames(1);
        QCOMPARE(s.mode().counts().lastExecuted, unsigned(InterpreterMode::kLinesPerFrame));
        s.frames(11);
        s.line("textmsg(n)");
        s.frames(1);
        QCOMPARE(s.host.lastMessage(), "1000");
    }
    void linesAndDefinitionsAreLimited() {
        Session s;
        for (std::size_t i = 0; i < InterpreterMode::kMaxWaiting; ++i) {
            s.mode().submit("sync()");
        }
        QCOMPARE(s.line("sync()"), "discard too many statements are waiting");
        s.mode().skip();
        for (std::size_t i = 0; i <= InterpreterMode::kMaxDefinitions; ++i) {
            s.mode().submit("v" + std::to_string(i) + " = 0");
            s.mode().skip();
        }
        QCOMPARE(s.line("a = 1"), "discard too many definitions without clear_interpreter()");
    }
    void branchesAndLoopsFitOnALine() {
        Session s;
        s.line("i = 0");
        s.line("while i < 5: i = i + 1 if i == 3: textmsg(\"three\") end end");
        s.frames(1);
        QCOMPARE(s.host.lastMessage(), "three");
    }
    void oldSoftwareHasNoInterpreterMode() {
        CompileOptions options;
        options.version = tiller::SoftwareVersion{5, 9, 0, 0};
        QCOMPARE(compile("def p():\n interpreter_mode()\nend\n", options).error.text,
                 "compile_error_name_not_found:interpreter_mode:");
        options.version = tiller::SoftwareVersion{5, 10, 0, 0};
        QVERIFY(compile("def p():\n interpreter_mode()\nend\n", options));
    }
    void linesUseTheSoftwareVersionOfTheProgram() {
        CompileOptions options;
        options.version = tiller::SoftwareVersion{5, 15, 0, 0};
        const CompileOutcome outcome = compile("def p():\n interpreter_mode()\nend\n", options);
        QVERIFY(outcome);
        FakeHost host;
        Interpreter interpreter(outcome.program, host);
        interpreter.runFrame();
        QVERIFY(interpreter.mode().submit("optimovej([0,0,0,0,0,0])").kind == Kind::Discard);
        QVERIFY(interpreter.mode().submit("movej([0,0,0,0,0,0])").kind == Kind::Ack);
    }
    void linesCannotUseFunctionsMissingInTheProgram() {
        CompileOptions options;
        options.missing = {"teach_mode"};
        const CompileOutcome outcome = compile("def p():\n interpreter_mode()\nend\n", options);
        QVERIFY(outcome);
        FakeHost host;
        Interpreter interpreter(outcome.program, host);
        interpreter.runFrame();
        QVERIFY(interpreter.mode().submit("teach_mode()").kind == Kind::Discard);
        QVERIFY(interpreter.mode().submit("freedrive_mode()").kind == Kind::Ack);
    }
};

QTEST_GUILESS_MAIN(tst_InterpreterMode)
#include "tst_interpreter_mode.moc"
