// SPDX-License-Identifier: MIT
// The language except expressions: layout, functions, scopes, control flow, compile errors.

#include "tests/unit/robot/simulator/urscript/script_run.h"

using namespace tiller::simulator::urscript;

namespace {

// Compile error as "line:column text", or "ok".
std::string compileError(const std::string& text) {
    const CompileOutcome outcome = compile(text);
    return outcome ? "ok"
                   : std::to_string(outcome.error.line) + ":" + std::to_string(outcome.error.column) + " " +
                         outcome.error.text;
}

}  // namespace

class tst_Language : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // ---- layout
    void newlinesDoNotMatter() {
        QCOMPARE(evaluate("a + b + c", "a = 1    b = 2 c\n=\n# comment \"here\n3"), "6");
        QCOMPARE(evaluate("x", "x = 0\nif x == 1 or\nx == 2 or\nx == 0: x = 5 end"), "5");
        QCOMPARE(evaluate("x", "def f(a): return a * 2 end x = f (\n 4\n )"), "8");
        QCOMPARE(evaluate("x", "x = 0 while x < 3: x = x + 1 end"), "3");
    }
    void offsetInjectionLayoutWorks() {
        ScriptRun run(
            "def m():\n    global reg_float = # float register offset\n0    global reg_int = # int\n24\n"
            "    sum = reg_float + reg_int\nend\n");
        run.frames(2);
        QCOMPARE(run.value("sum"), "24");
    }
    void crlfAndTabsAreBlanks() { QCOMPARE(evaluate("a", "\ta = 1\r\n \t a = a + 1\r"), "2"); }
    void builtinNamesAreNotReserved() {
        QCOMPARE(evaluate("time + length([1,2]) + length", "time = 1\nlength = 2"), "5");
    }
    void userFunctionsHideBuiltins() { QCOMPARE(evaluate("d2r(1)", "def d2r(x): return x + 41 end"), "42"); }

    // ---- compile errors
    void unknownNamesFailBeforeTheFirstStatement() {
        QCOMPARE(compileError("def m():\n  txtmsg(\"x\")\nend\n"),
                 "2:3 compile_error_name_not_found:txtmsg:");
        QCOMPARE(compileError("def m():\n\n txtmsg(1)\nend\n"), "3:2 compile_error_name_not_found:txtmsg:");
        QCOMPARE(compileError("def m():\nif False:\n  a = missing + 1\nend\nend\n"),
                 "3:7 compile_error_name_not_found:missing:");
        QCOMPARE(compileError("def m():\nthread t():\n x = 1\n end\n h = run u()\nend\n"),
                 "5:10 compile_error_name_not_found:u:");
        QCOMPARE(compileError("def m():\n x[0] = 1\nend\n"), "2:2 compile_error_name_not_found:x:");
    }
    void theFirstUnknownNameInTheTextIsReported() {
        QCOMPARE(compileError("def m():\ndef f():\n one()\nend\ntwo()\nend\n"),
                 "3:2 compile_error_name_not_found:one:");
    }
    void syntaxErrorsQuoteTheirLine_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* text, const char* expected) {
            QTest::newRow(text) << text << expected;
        };
        row("def m():\n a = \nend\n", "3:1 syntax_error_on_line:3:end:");
        row("def m():\n a = (1 + 2\nend\n", "3:1 syntax_error_on_line:3:end:");
        row("def m():\n if a\n x = 1\n end\nend", "3:2 syntax_error_on_line:3: x = 1:");
        row("def m():\n a = \"open\nend\n", "2:6 syntax_error_on_line:2: a = \"open:");
        row("def m():\n b\nend\n", "2:2 syntax_error_on_line:2: b:");
        row("def m():\n 1 + 2\nend\n", "2:2 syntax_error_on_line:2: 1 + 2:");
        row("def m():\n break\nend\n", "2:2 syntax_error_on_line:2: break:");
        row("def m():\n while True:\n def f():\n break\n end\n end\nend\n",
            "4:2 syntax_error_on_line:4: break:");
        row("def m():\n a = 12abc\nend\n", "2:6 syntax_error_on_line:2: a = 12abc:");
        row("def m():\n a = @\nend\n", "2:6 syntax_error_on_line:2: a = @:");
        row("def m():\n f(a=1, 2)\nend\n", "2:9 syntax_error_on_line:2: f(a=1, 2):");
        row("def m():\n p[1,2,3] = 4\nend\n", "2:3 syntax_error_on_line:2: p[1,2,3] = 4:");
        row("def m():\nend\nend\n", "3:1 syntax_error_on_line:3:end:");
        row("def m():\n x = 1\n", "3:1 syntax_error_on_line:3::");
        row("def m():\n thread t(a):\n end\nend\n", "2:12 syntax_error_on_line:2: thread t(a)::");
        row("def m():\n 1 = 2\nend\n", "2:2 syntax_error_on_line:2: 1 = 2:");
        row("def m():\n f() = 2\nend\n", "2:6 syntax_error_on_line:2: f() = 2:");
    }
    void syntaxErrorsQuoteTheirLine() {
        QFETCH(QString, text);
        QFETCH(QString, expected);
        QCOMPARE(QString::fromStdString(compileError(text.toStdString())).remove('\r').left(expected.size()),
                 expected);
    }
    void deepNestingIsASyntaxError() {
        QVERIFY(compileError("def m():\na = " + std::string(100000, '(') + "\nend\n").find("syntax_error") !=
                std::string::npos);
        std::string sum = "1";
        for (int i = 0; i < 100000; ++i) {
            sum += "+1";
        }
        QVERIFY(compileError("def m():\na = " + sum + "\nend\n").find("syntax_error") != std::string::npos);
        std::string ifs;
        for (int i = 0; i < 10000; ++i) {
            ifs += "if True:\n";
        }
        QVERIFY(compileError("def m():\n" + ifs).find("syntax_error") != std::string::npos);
    }

    // ---- program units
    void rawStatementsAreAProgram() {
        const CompileOutcome outcome = compile("textmsg(\"x\")\nmovej([0,0,0,0,0,0])\n");
        QVERIFY(outcome);
        QVERIFY(outcome.program->isRaw());
        QVERIFY(outcome.program->commandsMotion());
        QVERIFY(!compile("textmsg(\"x\")\n").program->commandsMotion());
    }
    void programNamesAndKindsAreReported() {
        QCOMPARE(compile("def prog(): end").program->name(), "prog");
        QVERIFY(compile("sec s(): end").program->kind() == ProgramKind::Secondary);
        QVERIFY(compile("def prog(): end").program->kind() == ProgramKind::Main);
    }
    void labelsAreReported() {
        ScriptRun run("def m():\n  $ 1 \"Robot Program\"\n  $ 12 \"Move # 1\" \"noBreak\"\n x = 1\nend\n");
        run.frames(2);
        QCOMPARE(run.host.calls.size(), 2u);
        QCOMPARE(run.host.calls[1], "label 12 Move # 1");
    }
    void aProgramWithoutDefIsReplacedByItsStatements() {
        ScriptRun run("x = 1\nif x == 1:\nx = 2\nend\n");
        QCOMPARE(run.frames(1), Interpreter::State::Finished);
        QCOMPARE(run.value("x"), "2");
    }

    // ---- functions
    void argumentsMixPositionsAndNames() {
        const std::string f = "def f(a, b=2, c = 3.5):\nreturn str_cat(str_cat(a, b), c)\nend";
        QCOMPARE(evaluate("f(1)", f), "123.5");
        QCOMPARE(evaluate("f(1, c=9)", f), "129");
        QCOMPARE(evaluate("f(c=9, a=4)", f), "429");
        QCOMPARE(evaluate("f(1, 5, 6)", f), "156");
        QCOMPARE(evaluate("f()", f), "error: Type error: f is missing argument 'a'");
        QCOMPARE(evaluate("f(1,2,3,4)", f), "error: Type error: f takes at most 3 arguments");
    }
    void defaultsMayUseGlobalsAndOtherParameters() {
        QCOMPARE(evaluate("f(2)", "g = 10\ndef f(a, b=a * g): return b end\n"), "20");
    }
    void functionsReturnFromAnywhere() {
        const std::string f =
            "def f(n):\ni = 0\nwhile True:\nif i == n:\nreturn i * 10\nend\ni = i + 1\nend\nend";
        QCOMPARE(evaluate("f(3)", f), "30");
        QCOMPARE(evaluate("f()", "def f():\nreturn\nx = 1\nend"), "None");
        QCOMPARE(evaluate("f()", "def f():\n# nothing\nend"), "None");
    }
    void functionsAreKnownBeforeTheyAreDefined() {
        QCOMPARE(evaluate("f()", "def f(): return g() end\ndef g(): return 7 end"), "7");
    }
    void recursionIsLimited() {
        QCOMPARE(evaluate("fac(10)", "def fac(n):\nif n < 2:\nreturn 1\nend\nreturn n * fac(n - 1)\nend"),
                 "3628800");
        QCOMPARE(evaluate("f()", "def f(): return f() end"), "error: Too many nested function calls");
    }
    void nestedFunctionsAreFoundInTheirScope() {
        QCOMPARE(evaluate("outer()", "def outer():\ndef inner(): return 3 end\nreturn inner()\nend"), "3");
        QCOMPARE(evaluate("inner()", "def outer():\ndef inner(): return 3 end\nend"),
                 "error: compile_error_name_not_found:inner:");
    }
    void commandsEndWithTheirComparison() {
        QCOMPARE(evaluate("f(255)", "def f(cmd): return cmd != 255 end"), "False");
        QCOMPARE(evaluate("f(0)", "def f(sum): return (sum < 0.0000000001) end"), "True");
        QCOMPARE(evaluate("f(False)", "def f(x): return True and (x == False) end"), "True");
    }

    // ---- scopes
    void topLevelVariablesAreGlobal() {
        QCOMPARE(evaluate("x", "x = 1\ndef f():\nx = x + 1\nend\nf()\nf()"), "3");
        QCOMPARE(evaluate("x", "local x = 1\ndef f():\nx = 5\nend\nf()"), "5");
    }
    void globalsMayBeDeclaredAnywhere() {
        QCOMPARE(evaluate("x", "def f():\nif True:\nglobal x = 4\nend\nend\nf()"), "4");
        QCOMPARE(evaluate("x", "global x = 0\ndef f():\nglobal x = 4\nend\nf()"), "4");
        QCOMPARE(evaluate("x", "def f():\nglobal x = 4\nend"), "error: Variable 'x' has no value");
    }
    void localsStayLocal() {
        QCOMPARE(evaluate("x", "x = 1\ndef f():\nlocal x = 5\nx = 6\nend\nf()"), "1");
        QCOMPARE(evaluate("y", "def f():\ny = 5\nreturn y\nend\nz = f()"),
                 "error: compile_error_name_not_found:y:");
    }
    void innerFunctionsDoNotSeeOuterLocals() {
        QCOMPARE(evaluate("one()", "def one():\na = 1\ndef two():\nreturn a\nend\nreturn two()\nend"),
                 "error: compile_error_name_not_found:a:");
        QCOMPARE(
            evaluate("one()", "a = 9\ndef one():\nlocal a = 1\ndef two():\nreturn a\nend\nreturn two()\nend"),
            "9");
    }
    void localsAreFreshInEveryCall() {
        QCOMPARE(evaluate("f(False)", "def f(set):\nif set:\ny = 1\nend\nreturn y\nend\nx = f(True)"),
                 "error: Variable 'y' has no value");
    }
    void localsMayBeRepeatedInLoops() {
        const std::string f =
            "def f():\ni = 0\nwhile i < 3:\nlocal l = make_list(i + 1, i)\ni = i + 1\nend\nreturn l\nend";
        QCOMPARE(evaluate("f()", f), "[2, 2, 2]");
    }
    void parametersHideGlobals() {
        QCOMPARE(evaluate("f(5) + x", "x = 1\ndef f(x):\nx = x + 1\nreturn x\nend"), "7");
    }
    void branchesShareTheScopeOfTheirFunction() {
        QCOMPARE(evaluate("f(1)", "def f(a):\nif a == 1:\nv = 3\nelse:\nv = 4\nend\nreturn v\nend"), "3");
    }
    void elementsOfGlobalsAreWrittenFromFunctions() {
        QCOMPARE(evaluate("sel", "global sel = [0,0,0]\ndef f(i, v):\nsel[i] = v\nend\nf(1, 0.5)"),
                 "[0, 0.5, 0]");
    }

    // ---- flow
    void branchesAreTakenInOrder_data() {
        QTest::addColumn<int>("x");
        QTest::addColumn<QString>("expected");
        QTest::newRow("if") << 1 << "one";
        QTest::newRow("elif") << 2 << "two";
        QTest::newRow("second elif") << 3 << "three";
        QTest::newRow("else") << 4 << "many";
    }
    void branchesAreTakenInOrder() {
        QFETCH(int, x);
        QFETCH(QString, expected);
        const std::string body = "x = " + std::to_string(x) +
                                 "\nif (x == 1):\nr = \"one\"\nelif x == 2:\nr = \"two\"\n elif x == 3:\n"
                                 "r = \"three\"\nelse:\nr = \"many\"\nend";
        QCOMPARE(evaluate("r", body), expected.toStdString());
    }
    void manyBranchesWork() {
        std::string body = "x = 61\nif x == 0:\nr = 0\n";
        for (int i = 1; i < 80; ++i) {
            body += "elif x == " + std::to_string(i) + ":\nr = " + std::to_string(i * 2) + "\n";
        }
        QCOMPARE(evaluate("r", body + "end"), "122");
    }
    void loopsBreakAndContinue() {
        QCOMPARE(evaluate("sum",
                          "sum = 0\ni = 0\nwhile (True):\ni = i + 1\nif i % 2 == 0:\ncontinue\nend\n"
                          "if i > 7:\nbreak\nend\nsum = sum + i\nend"),
                 "16");
        QCOMPARE(
            evaluate("n",
                     "n = 0\ni = 0\nwhile i < 3:\nj = 0\nwhile True:\nj = j + 1\nif j == 2:\nbreak\nend\n"
                     "n = n + 1\nend\ni = i + 1\nend"),
            "3");
    }
    void numbersAndStringsAreConditions() {
        QCOMPARE(evaluate("r", "r = 0\nif 0.5:\nr = 1\nend"), "1");
        QCOMPARE(evaluate("r", "r = 0\nif \"\":\nr = 1\nend"), "0");
        QCOMPARE(evaluate("not 2"), "False");
        QCOMPARE(evaluate("r", "r = 0\nif [1]:\nr = 1\nend"),
                 "error: Type error: a condition must be a bool, not list");
    }
    void haltEndsTheProgramAnywhere() {
        ScriptRun run("def m():\nx = 1\ndef f():\nwhile True:\nhalt\nend\nend\nf()\nx = 2\nend\n");
        QCOMPARE(run.frames(5), Interpreter::State::Finished);
        QCOMPARE(run.value("x"), "1");
        QCOMPARE(run.host.ended, 1);
    }
    void runtimeErrorsContainTheirPosition() {
        ScriptRun run("def m():\n  l = [1,2]\n  x = 1\n  x = x + l[2]\nend\n");
        QCOMPARE(run.frames(2), Interpreter::State::Failed);
        QCOMPARE(run.interpreter->error()->line, 4);
        QCOMPARE(run.interpreter->error()->column, 12);
        QCOMPARE(run.host.ended, 1);
    }
};

QTEST_GUILESS_MAIN(tst_Language)
#include "tst_language.moc"
