// SPDX-License-Identifier: MIT
// Numbers, operators, lists, matrices, poses, strings, structs: the value of an expression.

#include "tests/unit/robot/simulator/urscript/script_run.h"

using namespace tiller::simulator::urscript;

class tst_Expressions : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void value_data() {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* expression, const char* expected) {
            QTest::newRow(expression) << expression << expected;
        };
        // numbers
        row("1 + 2 * 3", "7");
        row("(1 + 2) * 3", "9");
        row("7 / 2", "3.5");
        row("4 / 2", "2");
        row("7 % 3", "1");
        row("7.5 % 2", "1.5");
        row("3 * 4 % 5.0", "2");
        row("2 - 3 - 4", "-5");
        row("-3 * -2", "6");
        row("- - 3", "3");
        row("+3", "3");
        row(".36", "0.36");
        row("5.", "5");
        row("1e-5", "0.00001");
        row("2.5E-5 * 2", "0.00005");
        row("2147483647", "2147483647");
        row("-2147483648", "-2147483648");
        row("2147483647 + 1", "-2147483648");
        row("1000000 * 1000000.0", "1000000000000");
        row("1.0 / 0", "inf");
        row("5 % 0", "error: Division by zero");
        row("-get_steptime()", "-0.002");
        row("-(1 + 2)", "-3");
        // comparison and logic
        row("2.0 == 2", "True");
        row("1 < 2", "True");
        row("not 1 == 2", "True");
        row("not True and False", "False");
        row("True or False and False", "True");
        row("True xor True", "False");
        row("True xor False", "True");
        row("1 == 1 and not 2 == 3 and 4 < 5", "True");
        row("\"a\" == \"a\"", "True");
        row("\"a\" != \"a\"", "False");
        row("[1,2] == [1,2]", "True");
        row("[1,2] == [1.0,2.0]", "True");
        row("[1,2] == [1,3]", "False");
        row("p[1,2,3,4,5,6] == p[1,2,3,4,5,6]", "True");
        row("False and 1 / 0 > 0", "False");
        row("\"a\" < 1", "error: Type error: unsupported operands for <: string and int");
        // lists
        row("[1, 2, 3]", "[1, 2, 3]");
        row("[1, 2.5]", "[1, 2.5]");
        row("[True, False]", "[True, False]");
        row("[]", "[]");
        row("[1,2] + [3,4]", "[4, 6]");
        row("[1.5,2] - [1,1]", "[0.5, 1]");
        row("[2,3] * [4,5]", "[8, 15]");
        row("[1,2] / [2,4]", "[0.5, 0.5]");
        row("[5,7] % [3,4]", "[2, 3]");
        row("-3 * [1,2]", "[-3, -6]");
        row("[1,2] * 3", "[3, 6]");
        row("10 - [1,2]", "[9, 8]");
        row("-[1,2]", "[-1, -2]");
        row("[1000000, 2000000] / 1000000", "[1, 2]");
        row("[1,2] + [1,2,3]", "error: Lengths of lists do not match: 2 and 3");
        row("[1,2,3][1]", "2");
        row("[1,2,3][3]", "error: Index out of bounds: 3 in 3 elements");
        row("[1,2,3][-1]", "error: Index out of bounds: -1 in 3 elements");
        row("[1,2,3][0.5]", "error: Type error: an index must be an integer, not 0.5");
        row("[1,2,3][2.0]", "3");
        row("[1, \"a\"]", "error: Type error: elements of a list must be of one type, not int and string");
        row("[p[1,2,3,4,5,6], p[0,0,0,0,0,0]][0]", "p[1, 2, 3, 4, 5, 6]");
        row("[\"a\", \"b\"]", "[a, b]");
        row("[1,2] + \"a\"", "error: Type error: unsupported operands for +: list and string");
        // matrices
        row("[[1,2],[3,4],[5,6]]", "[[1, 2], [3, 4], [5, 6]]");
        row("[[1,2],[3,4]][1,0]", "3");
        row("[[1,2],[3,4]][1]", "[3, 4]");
        row("[[1,2],[3,4]] * [[0,1],[1,0]]", "[[2, 1], [4, 3]]");
        row("[[1,2],[3,4]] * [1,1]", "[3, 7]");
        row("[[1,2],[3,4]] * 2", "[[2, 4], [6, 8]]");
        row("1 + [[1,2],[3,4]]", "[[2, 3], [4, 5]]");
        row("[[1,2],[3,4]] + [[1,1],[1,1]]", "[[2, 3], [4, 5]]");
        row("[[1,2],[3]]", "error: Rows of a matrix must be of equal length");
        row("transpose([[1,2,3],[4,5,6]])", "[[1, 4], [2, 5], [3, 6]]");
        row("inv([[2,0],[0,4]])", "[[0.5, 0], [0, 0.25]]");
        row("inv([[1,1],[1,1]])", "error: inv: the matrix is singular");
        row("size([[1,2],[3,4],[5,6]])", "[3, 2]");
        row("[[1,2],[3,4]] * [1,2,3]", "error: Dimensions do not match: 2x2 and 3x1");
        // poses
        row("p[1,2,3,0.5,5,6]", "p[1, 2, 3, 0.5, 5, 6]");
        row("p[1,2,3,4,5,6][5]", "6");
        row("p[1,2,3,4,5,\"a\"]", "error: Type error: elements of a pose must be numbers, not string");
        row("p[0,0,0,0,0,0] + p[0,0,0,0,0,0]",
            "error: Type error: unsupported operands for +: pose and pose");
        // strings
        row("\"a\" + \"b\"", "ab");
        row("\"# no comment {%\"", "# no comment {%");
        row("str_cat(\"n = \", 5)", "n = 5");
        row("str_cat(str_cat(1.50, \" \"), True)", "1.5 True");
        row("str_cat(\"\", p[1,2,3,4,5,6])", "p[1, 2, 3, 4, 5, 6]");
        row("str_cat(\"\", [True, False])", "[True, False]");
        // structs
        row("struct(a=1, b=\"x\").b", "x");
        row("time().sec", "12");
        row("time().nanosec", "345000000");
        row("struct(a=1).c", "error: struct has no member 'c'");
        row("struct(a=struct(b=[1,2])).a.b[1]", "2");
    }
    void value() {
        QFETCH(QString, expression);
        QFETCH(QString, expected);
        QCOMPARE(QString::fromStdString(evaluate(expression.toStdString())), expected);
    }

    void intListTakesFloats() { QCOMPARE(evaluate("l", "l = [0,0,0]\nl[1] = 0.25"), "[0, 0.25, 0]"); }
    void listsAndPosesArePassedByValue() {
        const std::string body =
            "def f(l, q):\nl[0] = 9\nq[0] = 9\nreturn l[0] + q[0]\nend\n"
            "a = [1,2]\nb = p[1,2,3,4,5,6]\nsum = f(a, b)\n";
        QCOMPARE(evaluate("str_cat(str_cat(a, b), sum)", body), "[1, 2]p[1, 2, 3, 4, 5, 6]18");
    }
    void assigningAListCopiesIt() {
        QCOMPARE(evaluate("str_cat(a, b)", "a = [1,2]\nb = a\nb[0] = 5"), "[1, 2][5, 2]");
    }
    void variableCalledPIsIndexed() {
        QCOMPARE(evaluate("p[0] + p[1]", "p = [1,2]\np[0] = p[0] * 10"), "12");
        QCOMPARE(evaluate("p[p[0], p[1], 0, 0, 0, 0]", "p = [1,2]"), "p[1, 2, 0, 0, 0, 0]");
        QCOMPARE(evaluate("p[1,0]", "p = [[1,2],[3,4]]"), "3");
    }
    void matrixElementsAreWritten() {
        QCOMPARE(evaluate("m", "m = [[1,2],[3,4]]\nm[0,1] = 7\nm[1] = [8,9]"), "[[1, 7], [8, 9]]");
    }
    void structMembersAreWritten() {
        QCOMPARE(evaluate("str_cat(s.a, s.l)", "s = struct(a=1, l=[1,2])\ns.a = 5\ns.l[1] = 9"), "5[1, 9]");
        QCOMPARE(evaluate("t.a", "s = struct(a=1)\nt = s\ns.a = 5"), "1");
        QCOMPARE(evaluate("s", "s = struct(a=1)\ns.b = 2"), "error: struct has no member 'b'");
    }
    void poseInListIsWritten() {
        QCOMPARE(evaluate("l[1]", "l = [p[0,0,0,0,0,0], p[1,1,1,1,1,1]]\nl[1][2] = 5"),
                 "p[1, 1, 5, 1, 1, 1]");
    }
    void fixedListsDoNotGrow() {
        QCOMPARE(evaluate("a", "a = [1,2]\na = [1,2,3]"), "error: Resizing of 'List' is not supported");
        QCOMPARE(evaluate("a", "a = [1,2,3]\na = [1,2]"), "[1, 2]");
        QCOMPARE(evaluate("a", "a = [1,2]\na.append(3)"), "error: List is full: its capacity is 2");
    }
    void listsMadeWithCapacityGrow() {
        const char* body =
            "l = make_list(0, 0, 5)\nl.append(3)\nl.append(4.5)\nl.insert(0, 1)\nlast = l.pop()\n";
        QCOMPARE(evaluate("str_cat(l, last)", body), "[1, 3]4.5");
        QCOMPARE(evaluate("l.length() * 10 + l.capacity()", body), "25");
        QCOMPARE(evaluate("l.to_string()", body), "[1, 3]");
        QCOMPARE(evaluate("l", std::string(body) + "l.clear()"), "[]");
        QCOMPARE(evaluate("make_list(3, True)"), "[True, True, True]");
    }
    void methodsWorkOnMembersAndResults() {
        QCOMPARE(evaluate("s.l", "s = struct(l=make_list(1, 7, 3))\ns.l.append(8)"), "[7, 8]");
        QCOMPARE(evaluate("make_list(4, 1).length()"), "4");
        QCOMPARE(evaluate("l.shift()", "l = [1]"), "error: Type error: list has no method 'shift'");
    }
    void typeOfAVariableIsFixed() {
        QCOMPARE(evaluate("x", "x = 0\nx = 0.5\nx = True\nx = 3"), "3");
        QCOMPARE(evaluate("x", "x = 0\nx = \"a\""),
                 "error: Type error: variable 'x' is a int and cannot become a string");
        QCOMPARE(evaluate("x", "x = [0,0,0,0,0,0]\nx = get_target_tcp_speed()"), "p[0.5, 0, 0, 0, 0, 0.25]");
    }
    void splineFormulaOfListsIsEvaluated() {
        const char* body = "t = 0.5\nc1 = [1.0,2.0]\nc2 = [2,4]\nc3 = [3,6]\n";
        QCOMPARE(evaluate("c1 + 2.0*t*c2 + 3.0*pow(t,2)*c3", body), "[5.25, 10.5]");
        QCOMPARE(evaluate("(-3*q0 + q1*3 - v0*2*T - v1*T) / pow(T,2)",
                          "q0=[1,1] q1=[2,3] v0=[0.5,0] v1=[0,1] T=2"),
                 "[0.25, 1]");
    }
    void stringsAreLimited() {
        const std::string body =
            "s = \"0123456789\"\ni = 0\nwhile i < 10:\ns = str_cat(s, s)\ni = i + 1\nend\n";
        QCOMPARE(evaluate("s", body), "error: String is too long: more than 1023 characters");
    }
    void nestingOfValuesIsLimited() {
        const std::string body =
            "s = struct(a=1, b=2)\nt = struct(a=s, b=s)\ni = 0\n"
            "while i < 100:\nlocal u = t\nt = struct(a=u, b=u)\ni = i + 1\nend\n";
        QCOMPARE(evaluate("1", body), "error: Value is nested too deeply or too large");
    }
};

QTEST_GUILESS_MAIN(tst_Expressions)
#include "tst_expressions.moc"
