// SPDX-License-Identifier: MIT
// The language reference, statement by statement: one function per section, one row per rule. Rules that need
// several frames, threads or error positions have functions below; scheduling and sockets are covered by
// tst_scheduling and tst_sockets.

#include "robot/simulator/urscript/source_splitter.h"
#include "tests/unit/robot/simulator/urscript/script_run.h"

using namespace tiller::simulator::urscript;

namespace {

void columns() {
    QTest::addColumn<QString>("body");
    QTest::addColumn<QString>("expression");
    QTest::addColumn<QString>("expected");
}

void rule(const char* name, const char* body, const char* expression, const char* expected) {
    QTest::newRow(name) << body << expression << expected;
}

void checkRule() {
    QFETCH(QString, body);
    QFETCH(QString, expression);
    QFETCH(QString, expected);
    QCOMPARE(QString::fromStdString(evaluate(expression.toStdString(), body.toStdString())), expected);
}

std::string compileError(const std::string& text) {
    const CompileOutcome outcome = compile(text);
    return outcome ? "ok"
                   : std::to_string(outcome.error.line) + ":" + std::to_string(outcome.error.column) + " " +
                         outcome.error.text;
}

std::vector<std::string> units(const std::string& text) {
    SourceSplitter splitter;
    splitter.feed(text);
    std::vector<std::string> out;
    while (const auto unit = splitter.next()) {
        out.push_back((unit->kind == SourceSplitter::Unit::Kind::Command ? "command " : "") + unit->text);
    }
    return out;
}

}  // namespace

class tst_Conformance : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // ---- 1. Lexical structure
    void section1LexicalStructure_data() {
        columns();
        rule("newlines and indentation mean nothing", "a = 1    b = 2\n  c =\n3", "a + b + c", "6");
        rule("condition over lines", "a = 3\nif a == 1 or\na == 2 or\na == 3: b = 1\nelif True:\nb = 2 end",
             "b", "1");
        rule("blank before the bracket of a call", "", "pose_trans (p[1,0,0,0,0,0], p[0,1,0,0,0,0])",
             "p[1, 1, 0, 0, 0, 0]");
        rule("nested calls over lines", "s = str_cat(\n str_cat(\n \"a\",\n 1),\n str_cat(2.5,\n True))", "s",
             "a12.5True");
        rule("CRLF", "a = 1\r\nb = 2\r\n", "a + b", "3");
        rule("comments hold anything", "a = 1 # \"quote % {brace} \xc3\xa9\n### more\nb = 2", "a + b", "3");
        rule("a # in a string is no comment", "", "str_len(\"a#b$<br/>{}%\")", "12");
        rule("identifiers are case sensitive", "Ab = 1\nab = 2", "Ab * 10 + ab", "12");
        rule("builtin names are variables too", "time = 3\nlength = 2\nnorm = 1",
             "norm([3,4]) + length + time + norm", "11");
        rule("p is a variable", "p = [7, 8]\np[0] = p[0] + p[1]", "p[0]", "15");
        rule("p[ is a pose", "p = p[1,2,3,4,5,6]", "p[p[5], p[0], 0, 0, 0, 0]", "p[6, 1, 0, 0, 0, 0]");
        rule("integer limits", "", "[2147483647, -2147483648]", "[2147483647, -2147483648]");
        rule("float literals", "", "[1.5, .36, 5., 1e-5, 2.5E-5, 1E2]",
             "[1.5, 0.36, 5, 0.00001, 0.000025, 100]");
        rule("hexadecimal", "", "[0x10, 0xff, 0xFFFFFFFF]", "[16, 255, -1]");
        rule("no escapes in strings", "", "str_len(\"a\\n\")", "3");
        // Operators, by descending precedence.
        rule("index before sign", "a = [1,2]", "-a[1]", "-2");
        rule("sign before times", "", "-2 * -3", "6");
        rule("times and modulo from the left", "", "7 * 3 % 5", "1");
        rule("modulo of floats", "", "5.5 * 2 % 5.0", "1");
        rule("times before plus", "", "1 + 2 * 3 - 4 / 2", "5");
        rule("plus before comparison", "", "1 + 1 == 2", "True");
        rule("not is weaker than comparison", "", "not 1 == 2", "True");
        rule("not before and", "x = True\ny = False\nz = -1", "x and not y and z < 0", "True");
        rule("not of a bracket", "a = True\nb = False", "not (a and b and a)", "True");
        rule("and before or", "", "True or True and False", "True");
        rule("xor", "", "[True xor False, True xor True]", "[True, False]");
        rule("and does not look further than it must", "l = [1]\ni = 3", "i < 1 and l[i] == 1", "False");
    }
    void section1LexicalStructure() { checkRule(); }
    void section1Keywords() {
        for (const char* word :
             {"def",           "thread", "end",   "if",    "elif", "else", "while", "break",
              "continue",      "return", "halt",  "pause", "run",  "join", "kill",  "enter_critical",
              "exit_critical", "global", "local", "and",   "or",   "xor",  "not",   "True",
              "False",         "struct", "None"}) {
            QVERIFY2(compileError(std::string("def m():\n ") + word + " = 1\nend\n") != "ok", word);
        }
        for (const char* word : {"time", "type", "target", "message", "async", "list", "max", "dir", "sum",
                                 "length", "p", "mode", "state", "command", "str", "for", "switch", "case"}) {
            QCOMPARE(compileError(std::string("def m():\n ") + word + " = 1\nend\n"), "ok");
        }
    }
    void section1ProgramLabels() {
        ScriptRun run("def m():\n $ 1 \"Robot Program\"\n $ 2 \"Move\"\n x = 1\nend\n");
        run.frames(1);
        QCOMPARE(run.host.calls, (std::vector<std::string>{"label 1 Robot Program", "label 2 Move"}));
    }

    // ---- 2. Grammar
    void section2Grammar_data() {
        columns();
        rule("one line function", "def f(): return 4 end", "f()", "4");
        rule("one line loop", "i = 0 while i < 3: i = i + 1 end", "i", "3");
        rule("brackets around conditions", "x = 0\nif (x == 0): y = 1 end while (True): break end", "y", "1");
        rule("while without brackets", "while True: y = 2 break end", "y", "2");
        rule("nested targets", "s = struct(l=[struct(v=1)], m=[[1,2],[3,4]])\ns.l[0].v = 9\n", "s.l[0].v",
             "9");
        rule("matrix element", "m = [[1,2],[3,4]]\nm[1,0] = 7", "m[1,0] + m[0,1]", "9");
        rule("run is an expression", "thread t():\n sync()\n end\n h = run t()", "h > 0", "True");
        rule("named arguments in any order", "def f(a, b, c): return a * 100 + b * 10 + c end",
             "f(1, c=3, b=2)", "123");
        rule("a tuple is a list", "t = (1, 2, 3)", "t", "[1, 2, 3]");
        rule("a bracket is no tuple", "t = (1)", "t", "1");
        rule("old outputs", "digital_out[2] = True\nn = 1\ndigital_out[n + 2] = False",
             "[get_digital_out(2), get_digital_out(3)]", "[True, False]");
        rule("a variable of that name is one", "digital_out = [1, 2]\ndigital_out[1] = 5", "digital_out",
             "[1, 5]");
    }
    void section2Grammar() { checkRule(); }

    // ---- 3. Program units and how they start and end
    void section3Units() {
        QCOMPARE(units("def a():\n x = 1\nend\nsec b():\nend\n"),
                 (std::vector<std::string>{"def a():\n x = 1\nend\n", "sec b():\nend\n"}));
        QCOMPARE(units("stop program\ndef a():\nend\n\n"),
                 (std::vector<std::string>{"command stop program", "def a():\nend\n"}));
        QCOMPARE(units("textmsg(\"x\")\nmovej([0,0,0,0,0,0],\na=1)\n").size(), std::size_t(2));
        QVERIFY(units("def a():\nend").empty());  // the newline completes the line
        // Each statement is followed by the terminating zero of a C string.
        QCOMPARE(units(std::string("f(1)\n\0g(2)\n\0", 12)), (std::vector<std::string>{"f(1)\n", "g(2)\n"}));
    }
    void section3CommandWords() {
        for (const char* words : {"power on", "power off", "set robotmode run", "set unlock protective stop",
                                  "stop program", "set speed 0.8", "confirm user safety parameters",
                                  "pause program", "run program", "set sim", "set real"}) {
            QCOMPARE(units(std::string(words) + "\n"),
                     std::vector<std::string>{std::string("command ") + words});
        }
    }
    void section3NamesAreResolvedFirst() {
        QCOMPARE(compileError("def m():\n if False:\n  f()\n end\nend\n"),
                 "3:3 compile_error_name_not_found:f:");
        QCOMPARE(evaluate("g()", "def g(): return later() end\ndef later(): return 3 end"), "3");
        QCOMPARE(
            compileError("def m():\n thread t():\n  later()\n end\n def later():\n end\n run t()\nend\n"),
            "ok");
    }
    void section3TheMainBodyEndsTheProgram() {
        ScriptRun run(
            "def m():\n thread t():\n while True:\n sync()\n end\n end\n run t()\n sleep(0.01)\nend\n");
        QCOMPARE(run.frames(100), Interpreter::State::Finished);
        QVERIFY(run.interpreter->frame() <= 7);
        QCOMPARE(run.host.ended, 1);
    }

    // ---- 4. Functions
    void section4Functions_data() {
        columns();
        rule("defaults", "def f(a, b=2, c = 3.0): return a + b + c end", "[f(1), f(1, 1), f(1, c=0)]",
             "[6, 5, 3]");
        rule("positions first, then names", "def f(a, b=2, c=3): return [a, b, c] end", "f(9, c=7)",
             "[9, 2, 7]");
        rule("arguments by value", "def f(l): l[0] = 9 return l end\na = [1,2]\nb = f(a)", "[a[0], b[0]]",
             "[1, 9]");
        rule("poses by value",
             "def scale(p, k): p[0] = p[0] * k return p end\na = p[2,0,0,0,0,0]\nb = scale(a, 3)",
             "[a[0], b[0]]", "[2, 6]");
        rule("a parameter may change", "def f(v): if v > 5: v = 5 end return v end", "[f(3), f(8)]",
             "[3, 5]");
        rule("return from a loop", "def f(n): i = 0 while True: if i == n: return i end i = i + 1 end end",
             "f(4)", "4");
        rule("none without a value", "def f():\nreturn\nend", "f()", "None");
        rule("none at the end", "def f():\n# nothing\nend", "f()", "None");
        rule("nested definitions", "def f(): def g(): return 2 end return g() end", "f()", "2");
        rule("result ignored", "x = 0\ndef f(): global x = 5 return 1 end\nf()", "x", "5");
        rule("comparison as result", "def f(cmd): return cmd != 255 end", "[f(255), f(1)]", "[False, True]");
        rule("missing argument", "def f(a): return a end", "f()",
             "error: Type error: f is missing argument 'a'");
        rule("unknown name", "def f(a): return a end", "f(b=1)",
             "error: Type error: f has no argument named 'b'");
        rule("given twice", "def f(a): return a end", "f(1, a=1)",
             "error: Type error: f got argument 'a' twice");
    }
    void section4Functions() { checkRule(); }

    // ---- 5. Scoping
    void section5Scoping_data() {
        columns();
        rule("global from inside", "def f(): global g = 3 end\nf()", "g", "3");
        rule("local does not leave", "x = 1\ndef f(): local x = 2 return x end\ny = f()", "[x, y]", "[1, 2]");
        rule("local again in a loop",
             "def f():\ni = 0\nwhile i < 3:\nlocal t = i\ni = i + 1\nend\nreturn t\nend", "f()", "2");
        rule("unqualified writes the global", "x = 1\ndef f(): x = 5 end\nf()", "x", "5");
        rule("unqualified makes a local", "def f(): z = 5 return z end\ny = f()", "z",
             "error: compile_error_name_not_found:z:");
        rule("top level is global, even local", "local x = 1\ndef f(): x = x + 1 end\nf()", "x", "2");
        rule("inner functions do not see locals of outer ones",
             "a = 1\ndef f(): local a = 2 def g(): return a end return g() end", "f()", "1");
        rule("elements of globals", "global v = [0,0]\ndef f(): v[0] = 1 end\nf()", "v", "[1, 0]");
        rule("global over an existing one", "global h = 0\ndef f(): global h = 4 end\nf()", "h", "4");
        rule("one branch assigns", "if True: v = 1 else: w = 2 end", "v", "1");
        rule("never assigned", "", "nothing", "error: compile_error_name_not_found:nothing:");
        rule("not yet assigned", "if False: v = 1 end", "v", "error: Variable 'v' has no value");
    }
    void section5Scoping() { checkRule(); }

    // ---- 6. Types
    void section6Types_data() {
        columns();
        rule("none", "", "None", "None");
        rule("comparison is a bool", "", "1 < 2", "True");
        rule("ints wrap at 32 bits", "", "2147483647 + 1", "-2147483648");
        rule("string bytes", "", "str_at(\"abc\", 1)", "b");
        rule("pose elements", "q = p[1,2,3,4,5,6]\nq[3] = 0.5", "q", "p[1, 2, 3, 0.5, 5, 6]");
        rule("int lists take floats", "l = [0,0,0]\nl[2] = 0.25", "l", "[0, 0, 0.25]");
        rule("lists have one type", "", "[1, \"a\"]",
             "error: Type error: elements of a list must be of one type, not int and string");
        rule("matrix", "m = [[1,2],[3,4],[5,6]]", "[size(m)[0], size(m)[1], m[2,1]]", "[3, 2, 6]");
        rule("matrix rows are equal", "", "[[1,2],[3]]", "error: Rows of a matrix must be of equal length");
        rule("struct", "s = struct(a=1, b=\"x\")\ns.a = 4", "s", "struct(a=4, b=x)");
        rule("member of a result", "", "time().sec", "12");
        rule("struct by value", "s = struct(a=1)\nt = s\nt.a = 2", "[s.a, t.a]", "[1, 2]");
        rule("handles are ints", "thread t(): sync() end\nh = 0\nh = run t()", "h != 0", "True");
        rule("int, float and handle on one variable", "v = 0\nv = 0.5\nv = get_steptime()\nv = 20", "v",
             "20");
        rule("types stay", "v = 1\nv = \"a\"", "v",
             "error: Type error: variable 'v' is a int and cannot become a string");
        // Conversions.
        rule("int and int", "", "[7 + 2, 7 - 2, 7 * 2, 7 % 2]", "[9, 5, 14, 1]");
        rule("division gives a float", "", "[1 / 4, 3000000 / 1000000]", "[0.25, 3]");
        rule("int and float", "", "2 + 0.5", "2.5");
        rule("int equals float", "", "2.0 == 2", "True");
        rule("number as condition", "r = 0\nif 0.5: r = 1 end if 0: r = 2 end", "r", "1");
        rule("string as condition", "r = 0\nif \"a\": r = 1 end if \"\": r = 2 end", "r", "1");
        rule("float for an int", "set_tool_voltage(24.0)", "integer_to_binary_list(2.0)[1]", "True");
        rule("float that is no int", "", "integer_to_binary_list(2.5)",
             "error: Type error: integer_to_binary_list argument 'x' must be an integer, not float");
        rule("pose for a list", "", "norm(p[0,3,4,0,0,0])", "5");
        rule("list equality", "", "[[1,2] == [1,2], [1,2] == [1,3], [1,2] == [1,2,3]]",
             "[True, False, False]");
        rule("matrix inverse", "", "inv([[2,0],[0,4]])", "[[0.5, 0], [0, 0.25]]");
    }
    void section6Types() { checkRule(); }

    // ---- 7. Lists, matrices, poses: arithmetic
    void section7Arithmetic_data() {
        columns();
        rule("list and list", "a = [6,8]\nb = [3,2]",
             "[a + b == [9,10], a - b == [3,6], a * b == [18,16], a / b == [2,4], a % b == [0,0]]",
             "[True, True, True, True, True]");
        rule("lengths must match", "", "[1,2] + [1]", "error: Lengths of lists do not match: 2 and 1");
        rule("scalar on either side", "q = [1,2]", "-3 * q + q * 3 + q / 2 + 1 - q", "[0.5, 0]");
        rule("list over scalar", "", "[1000000, 500000] / 1000000", "[1, 0.5]");
        rule("scalar over list", "", "12 / [3, 4]", "[4, 3]");
        rule("sign of a list", "", "-[1,-2]", "[-1, 2]");
        rule("matrix and scalar", "", "2 * [[1,2],[3,4]] + 1", "[[3, 5], [7, 9]]");
        rule("matrix times matrix", "", "[[1,2],[3,4]] * [[0,1],[1,0]]", "[[2, 1], [4, 3]]");
        rule("matrix times list", "", "[[1,2],[3,4]] * [1,1]", "[3, 7]");
        rule("matrix plus matrix", "", "[[1,2],[3,4]] + [[1,1],[1,1]]", "[[2, 3], [4, 5]]");
        rule("shapes must match", "", "[[1,2]] * [[1,2]]", "error: Dimensions do not match: 1x2 and 1x2");
        rule("norm of a difference", "", "norm([3,4] - [0,0])", "5");
        rule("norm of a number", "", "norm(-2)", "2");
        rule("transpose", "", "transpose([[1,2,3],[4,5,6]])", "[[1, 4], [2, 5], [3, 6]]");
        rule("poses are added by functions", "", "p[1,0,0,0,0,0] + p[1,0,0,0,0,0]",
             "error: Type error: unsupported operands for +: pose and pose");
        rule("literals do not grow", "l = [1,2]\nl.append(3)", "l", "error: List is full: its capacity is 2");
        rule("resizing", "l = [1,2]\nl = [1,2,3]", "l", "error: Resizing of 'List' is not supported");
        rule("capacity", "l = make_list(1, 0, 4)\nl.append(5)\nl.insert(0, 7)\nn = l.pop()",
             "[l.length(), l.capacity(), l[0], n]", "[2, 4, 7, 5]");
        rule("clear", "l = make_list(3, 1)\nl.clear()", "l.length()", "0");
        rule("to_string", "l = [1,2.5]", "l.to_string()", "[1, 2.5]");
        rule("index out of range", "l = [1,2]", "l[2]", "error: Index out of bounds: 2 in 2 elements");
        rule("negative index", "l = [1,2]", "l[-1]", "error: Index out of bounds: -1 in 2 elements");
        rule("size", "", "[size([1,2,3]), size(\"ab\"), length([1]), get_list_length([1,2])]",
             "[3, 2, 1, 2]");
        rule("spline speed", "t = 0.5\nc1 = [1,0]\nc2 = [0,1]\nc3 = [1,1]\nc4 = [2,0]\nc5 = [0,4]",
             "c1 + 2.0*t*c2 + 3.0*pow(t,2)*c3 + 4.0*pow(t,3)*c4 + 5.0*pow(t,4)*c5", "[2.75, 3]");
        rule("spline coefficients", "q0 = [0,1]\nq1 = [1,1]\nv0 = [0,0]\nv1 = [0,2]\nT = 2",
             "(-3*q0 + q1*3 - v0*2*T - v1*T) / pow(T,2)", "[0.75, -1]");
        rule("a time of nothing", "", "([1,-1] - [0,0]) / 0.0", "[inf, -inf]");
    }
    void section7Arithmetic() { checkRule(); }

    // ---- 8. Strings and formatting
    void section8Strings_data() {
        columns();
        rule("concatenation of all kinds", "", "str_cat(str_cat(\"a\", 1), str_cat(2.5, [True, False]))",
             "a12.5[True, False]");
        rule("pose", "", "str_cat(\"\", p[1,2,3,4,5,6])", "p[1, 2, 3, 4, 5, 6]");
        rule("other kinds are refused", "", "str_cat(\"\", struct(a=1))",
             "error: Type error: str_cat argument 'op2' must be a string, bool, number, pose or list of "
             "those, "
             "not struct");
        rule("plus", "", "\"ab\" + \"cd\"", "abcd");
        rule("six decimals, no zeros behind", "",
             "[to_str(1.50) == \"1.5\", to_str(1/3) == \"0.333333\", to_str(2.0) == \"2\"]",
             "[True, True, True]");
        rule("to_num", "", "[to_num(\"  -12\"), to_num(\"+7\"), to_num(\"0x1F\")]", "[-12, 7, 31]");
        rule("to_num of floats", "", "[to_num(\"1.5\"), to_num(\"2e3\")]", "[1.5, 2000]");
        rule("to_num of no number", "", "to_num(\"a\")", "error: to_num: \"a\" is not a number");
        rule("str_sub", "", "str_sub(\"abcdef\", 2, 100)", "cdef");
        rule("str_find", "",
             "[str_find(\"abcabc\", \"c\"), str_find(\"abcabc\", \"c\", 3), str_find(\"a\", \"x\")]",
             "[2, 5, -1]");
        rule("str_at out of range", "", "str_at(\"a\", 1)", "error: str_at: index 1 is out of bounds");
        rule("too long", "s = \"0123456789abcdef\"\ni = 0\nwhile i < 6: s = s + s i = i + 1 end", "s",
             "error: String is too long");
    }
    void section8Strings() { checkRule(); }
    void section8MessagesHaveSixDigits() {
        ScriptRun run(
            "def m():\n textmsg(\"pose \", p[0.605825,-0.720087,0.233797,-0.01113684,0,1.570732])\nend\n");
        run.frames(1);
        QCOMPARE(run.host.lastMessage(), "pose p[0.605825,-0.720087,0.233797,-0.0111368,0,1.57073]");
    }

    // ---- 9. Threads
    void section9Threads_data() {
        columns();
        rule("join waits", "x = 0\nthread t(): sleep(0.02) x = 5 end\nh = run t()\njoin h", "x", "5");
        rule("join of nothing", "join 0\nh = 0\njoin h", "1", "1");
        rule("kill of nothing", "kill 0\nh = 0\nkill h\nkill h", "1", "1");
        rule("kill stops at once",
             "x = 0\nthread t(): while True: x = x + 1 sync() end end\nh = run t()\nsync()\n"
             "kill h\nkill h\ny = x\nsync()\nsync()",
             "x == y", "True");
        rule("a thread clears its handle",
             "thread t(): sync() h = 0 end\nglobal h = run t()\nsync()\nsync()\nsync()", "h", "0");
        rule("own locals",
             "r = 0\nthread t(): local n = 0 while n < 3: n = n + 1 sync() end r = r + n end\n"
             "a = run t()\nb = run t()\njoin a\njoin b",
             "r", "6");
        rule("kill inside a critical section",
             "x = 0\nthread t(): enter_critical while True: sync() end exit_critical end\nh = run "
             "t()\nsync()\n"
             "kill h\nenter_critical\nx = 1\nexit_critical",
             "x", "1");
        rule("others run while a critical section blocks",
             "x = 0\nthread t(): while True: x = x + 1 sync() end end\nh = run "
             "t()\nenter_critical\nsleep(0.02)\n"
             "exit_critical",
             "x > 5", "True");
        rule("step time", "", "get_steptime()", "0.002");
    }
    void section9Threads() { checkRule(); }
    void section9SyncOncePerFrame() {
        ScriptRun run("def m():\n i = 0\n while True:\n i = i + 1\n sync()\n end\nend\n");
        run.frames(10);
        QCOMPARE(run.value("i"), "10");
    }
    void section9InfiniteLoop() {
        ScriptRun run("def m():\n i = 0\n while True:\n  i = i + 1\n end\nend\n");
        QCOMPARE(run.frames(1), Interpreter::State::Failed);
        QVERIFY(run.interpreter->error()->overrun);
        QVERIFY(run.interpreter->error()->line >= 3);
    }
    void section9MotionBelongsToOneThread() {
        ScriptRun run(
            "def m():\n thread t():\n  movej([1,0,0,0,0,0])\n end\n h = run t()\n sync()\n"
            " movej([0,0,0,0,0,0])\nend\n");
        run.frames(5);
        QCOMPARE(run.error(), "Another thread is already controlling the robot");
    }

    // ---- 10. Secondary programs
    void section10Secondary_data() {
        QTest::addColumn<QString>("body");
        QTest::addColumn<bool>("allowed");
        QTest::newRow("payload") << "set_payload(1, [0,0,0.1])" << true;
        QTest::newRow("sensor") << "zero_ftsensor()" << true;
        QTest::newRow("voltage") << "set_tool_voltage(24)" << true;
        QTest::newRow("stop") << "protective_stop()" << true;
        QTest::newRow("popup") << "popup(\"a\")" << true;
        QTest::newRow("arithmetic") << "x = 1\nwhile x < 10:\n x = x + 1\nend" << true;
        QTest::newRow("move") << "movej([0,0,0,0,0,0])" << false;
        QTest::newRow("sleep") << "sleep(0.1)" << false;
        QTest::newRow("sync") << "sync()" << false;
        QTest::newRow("thread") << "thread t():\nend\nrun t()" << false;
        QTest::newRow("blocking popup") << "popup(\"a\", blocking=True)" << false;
        QTest::newRow("blocking socket") << "socket_open(\"h\", 5)\nsocket_read_string()" << false;
        QTest::newRow("interpreter") << "interpreter_mode()" << false;
        QTest::newRow("pause") << "pause" << false;
    }
    void section10Secondary() {
        QFETCH(QString, body);
        QFETCH(bool, allowed);
        ScriptRun run("sec s():\n" + body.toStdString() + "\nend\n");
        QCOMPARE(run.frames(1), allowed ? Interpreter::State::Finished : Interpreter::State::Failed);
        if (!allowed) {
            QVERIFY(run.error().starts_with("Runtime is too much behind"));
        }
    }

    // ---- 11. Errors
    void section11Errors() {
        QCOMPARE(compileError("def t():\n  movej([0,0,0,0,0,0])\ntxtmsg(1)\nend\n"),
                 "3:1 compile_error_name_not_found:txtmsg:");
        QCOMPARE(compileError("def t():\n  txtmsg(1)\nend\n"), "2:3 compile_error_name_not_found:txtmsg:");
        QVERIFY(compileError("def t():\n x = = 1\nend\n").find("syntax_error_on_line:2: x = = 1:") !=
                std::string::npos);
    }
    void section11RuntimeExceptions_data() {
        QTest::addColumn<QString>("statement");
        for (const char* statement :
             {"x = [1][3]", "x = acos(2)", "x = asin(-1.1)", "x = sqrt(-1)", "x = log(0, 1)",
              "x = log(2, -1)", "x = pow(0, -1)", "x = pow(-1, 0.5)", "x = 1 + \"a\"", "x = normalize([0,0])",
              "x = str_at(\"\", 0)", "x = 5 % 0", "x = inv([[1,1],[1,1]])", "x = movej([0,0])",
              "x = set_tool_voltage(5)", "x = speedj([1/0.0,0,0,0,0,0], 1, 0.1)",
              "x = speedj([0,0,0,0,0,0], 0/0.0, 0.1)", "x = speedl([0,0,0,0,0,0/0.0], 1, 0.1)"}) {
            QTest::newRow(statement) << statement;
        }
    }
    void section11RuntimeExceptions() {
        QFETCH(QString, statement);
        ScriptRun run("def m():\n y = 1\n " + statement.toStdString() + "\nend\n");
        QCOMPARE(run.frames(3), Interpreter::State::Failed);
        QCOMPARE(run.interpreter->error()->line, 3);
        QVERIFY(!run.error().empty());
        QCOMPARE(run.host.ended, 1);
    }

    // ---- 12. Interpreter mode: see tst_interpreter_mode; here only the language itself is tested
    void section12InterpreterMode() {
        ScriptRun run(
            "def m():\n a = 1\n interpreter_mode(clearQueueOnEnter=True, clearOnEnd=True)\n a = 2\nend\n");
        run.frames(50);
        QCOMPARE(run.value("a"), "1");  // this call blocks the main thread
    }

    // ---- 13. Modifications that clients make to a script before sending it
    void section13OffsetInjection() {
        ScriptRun run(
            "def rtde_control():\n    global reg_offset_float = # float register offset\n0    global "
            "reg_offset_int = # int register offset\n24\n    x = reg_offset_float + reg_offset_int\nend\n");
        run.frames(1);
        QCOMPARE(run.value("x"), "24");
    }
    void section13MarkersBecomeBlanks() {
        ScriptRun run("def m():\n          x = 1\n     if x == 1:\n          x = 2\n     end\nend\n");
        run.frames(1);
        QCOMPARE(run.value("x"), "2");
    }
    void section13HeadlessText() {
        QCOMPARE(units("stop program\ndef externalControl():\n\ttextmsg(\"a\")\n\tif True:\n\tend\nend\n\n")
                     .back(),
                 "def externalControl():\n\ttextmsg(\"a\")\n\tif True:\n\tend\nend\n");
    }
    void section13InjectedPath() {
        ScriptRun run(
            "def m():\n def signal(i):\n end\n def path():\n # inject move path\n\tsignal(0)\n"
            "\tmovej([0,0.5,-1,0,0,0],a=1.4,v=1.05,r=0)\n\tsignal(1)\n"
            "\tmovel(p[0.1,0.2,0.3,0,3.14,0],a=0.5,v=0.2,r=0.02)\n end\n path()\nend\n");
        QCOMPARE(run.frames(50), Interpreter::State::Finished);
        QCOMPARE(std::get<Move>(run.host.motions[1].command).blend, 0.02);
    }

    // ---- 14. Constructs of both client scripts; tst_control_programs has complete programs
    void section14Constructs_data() {
        columns();
        rule("statements between definitions", "a = 1\ndef f(): return a end\na = 2\nthread t():\nend\na = 3",
             "f()", "3");
        rule("condition of calls",
             "a = 5\nb = 1\ndef f(): return 3 end\nn = 0\nwhile (a - b) > f(): b = b + 1 n = n + 1 end", "n",
             "1");
        rule("list literal with operator", "a = 2000000\nb = 1000000\nc = 1000000", "[a, b] / c", "[2, 1]");
        rule("index with expression", "INDEX = 1\nraw = [1,2,3]", "raw[INDEX + 1]", "3");
        rule("call as condition", "r = 0\nif socket_open(\"127.0.0.1\", 50001, \"s\"):\nr = 1\nend", "r",
             "1");
        rule("element of a pose parameter", "def f(p, k): p[0] = p[0] * k return p end",
             "f(p[1,2,0,0,0,0], 4)[0]", "4");
        rule("return of a bracket", "def f(sum): return (sum < 0.0000000001) end", "f(0)", "True");
        rule("misaligned ends", "x = 3\n    if x == 1:\n y = 1\n  elif x == 3:\n        y = 3\n end", "y",
             "3");
        rule("keyword arguments with blanks", "popup(\"a\", error = True, blocking = False)", "1", "1");
    }
    void section14Constructs() { checkRule(); }
};

QTEST_GUILESS_MAIN(tst_Conformance)
#include "tst_conformance.moc"
