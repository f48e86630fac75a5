// SPDX-License-Identifier: MIT

#include <QTest>

#include "robot/station/program/expression.h"

using namespace tiller::program;

class TestExpression : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void terminalLabelsBecomeCalls_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("script");
        QTest::newRow("input") << "DI3 and not TI1"
                               << "get_standard_digital_in(3) and not get_tool_digital_in(1)";
        QTest::newRow("output") << "CO7 == true"
                                << "get_configurable_digital_out(7) == True";
        QTest::newRow("analog") << "AI0 > 2.5"
                                << "get_standard_analog_in(0) > 2.5";
        QTest::newRow("pose") << "pose_trans(place, p[0, 0, -0.05, 0, 0, 0])"
                              << "pose_trans(place, p[0, 0, -0.05, 0, 0, 0])";
        QTest::newRow("text") << "name == \"DI3 ) end\""
                              << "name == \"DI3 ) end\"";
        QTest::newRow("no terminal") << "TI2 + DI9"
                                     << "TI2 + DI9";
    }
    void terminalLabelsBecomeCalls() {
        QFETCH(QString, text);
        QFETCH(QString, script);
        const Expression parsed = parseExpression(text);
        QCOMPARE(parsed.error, QString());
        QCOMPARE(parsed.script, script);
    }

    void statementsAreRefused_data() {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"", " ", "1\nhalt", "1)", "(1", "[1)", "\"open", "a = 1", "halt", "1 # rest", "x end",
              "run f()", "a; b", "while", "$ 1", "count := 2", "\u00e4 + 1", "def f()"}) {
            QTest::newRow(text) << QString::fromUtf8(text);
        }
    }
    void statementsAreRefused() {
        QFETCH(QString, text);
        const Expression parsed = parseExpression(text);
        QVERIFY2(!parsed.error.isEmpty(), qPrintable(parsed.script));
        QVERIFY(parsed.script.isEmpty());
    }

    void scriptBlocksMustBeBalanced() {
        for (const char* whole :
             {"", "sync()", "if a:\n  b()\nelif c:\n  d()\nend", "end_force_mode()", "x = \"end\" # end"}) {
            QVERIFY2(hasWholeBlocks(whole), whole);
        }
        for (const char* broken : {"end", "while True:", "end\nif x:", "def f():\nend\nend"}) {
            QVERIFY2(!hasWholeBlocks(broken), broken);
        }
    }

    void variableNamesAreChecked() {
        for (const char* good : {"a", "part_count", "_x", "Place2"}) {
            QVERIFY2(isVariableName(good), good);
        }
        for (const char* bad :
             {"", "2a", "a b", "tiller_x", "end", "True", "DI3", "gr\u00f6\u00dfe", "a\n"}) {
            QVERIFY2(!isVariableName(QString::fromUtf8(bad)), bad);
        }
    }

    void textsBecomeStringsAndNames() {
        QCOMPARE(scriptString("say \"hi\"\\\nnow"), QString("\"say 'hi' now\""));
        QCOMPARE(scriptName("Fill the tray"), QString("fill_the_tray"));
        QCOMPARE(scriptName("2. K\u00e4fig!"), QString("program_2_ka_fig"));
        QCOMPARE(scriptName(""), QString("program_"));
        QCOMPARE(scriptComment("a\nb \u2192 c"), QString("a b  c"));
    }
};

QTEST_APPLESS_MAIN(TestExpression)
#include "tst_expression.moc"
