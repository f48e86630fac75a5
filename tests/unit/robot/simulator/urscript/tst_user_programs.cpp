// SPDX-License-Identifier: MIT
//
// Features of published programs that the other language tests do not cover: spellings, containers, built-in
// functions that PolyScope writes into exported programs, functions missing in a software version, and the
// end of a program sent over a socket.

#include <QTest>
#include <vector>

#include "robot/simulator/urscript/program.h"
#include "robot/simulator/urscript/source_splitter.h"
#include "tests/unit/robot/simulator/urscript/script_run.h"

using namespace tiller;
using namespace tiller::simulator;
using namespace tiller::simulator::urscript;

namespace {

/// Text messages of a program. After an error, the last message is the error.
std::vector<std::string> messagesOf(const std::string& body) {
    const CompileOutcome outcome = compile("def p():\n" + body + "\nend\n");
    if (!outcome) {
        return {"error: " + outcome.error.text};
    }
    FakeHost host;
    Interpreter interpreter(outcome.program, host);
    for (int i = 0; i < 2000 && !interpreter.ended(); ++i) {
        interpreter.runFrame();
    }
    std::vector<std::string> messages = host.messages;
    if (interpreter.error()) {
        messages.push_back("error: " + interpreter.error()->text);
    }
    return messages;
}

bool compilesOn(const std::string& body, SoftwareVersion version) {
    CompileOptions options;
    options.version = version;
    return static_cast<bool>(compile("def p():\n" + body + "\nend\n", options));
}

std::vector<std::string> unitsOf(std::string_view text) {
    SourceSplitter splitter;
    splitter.feed(text);
    std::vector<std::string> units;
    while (auto unit = splitter.next()) {
        units.push_back(unit->text);
    }
    return units;
}

using Texts = std::vector<std::string>;

}  // namespace

class TestUserPrograms : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // Built-in functions in exported programs

    void toolPoseIsTheTcpInTheBaseFrame() {
        const std::string same = "pose_dist(tool_pose(), get_actual_tcp_pose())";
        QCOMPARE(messagesOf("textmsg(" + same + " < 0.000001)"), (Texts{"True"}));
        QCOMPARE(
            messagesOf("force_mode(tool_pose(),[0,0,1,0,0,0],[0,0,-5,0,0,0],2,[0.1,0.1,0.05,0.2,0.2,0.2])\n"
                       "sleep(0.2)\nend_force_mode()\ntextmsg(\"done\")"),
            (Texts{"done"}));
    }

    void runStateOutputsOfAllKinds_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("outputs");
        QTest::newRow("standard digital") << "set_runstate_standard_digital_outputs" << 8;
        QTest::newRow("configurable digital") << "set_runstate_configurable_digital_outputs" << 8;
        QTest::newRow("tool digital") << "set_runstate_tool_digital_outputs" << 2;
        QTest::newRow("standard analog") << "set_runstate_standard_analog_outputs" << 2;
        QTest::newRow("registers") << "set_runstate_gp_boolean_outputs" << 128;
    }
    void runStateOutputsOfAllKinds() {
        QFETCH(QString, name);
        QFETCH(int, outputs);
        ScriptRun run("def p():\n " + name.toStdString() + "([1])\nend\n");
        run.frames(10);
        QCOMPARE(run.error(), std::string());
        QCOMPARE(static_cast<int>(run.host.calls.size()), outputs);
        QCOMPARE(run.host.calls[0], std::string("run state 0 0"));
        QCOMPARE(run.host.calls[1], std::string("run state 1 3"));
        ScriptRun wrong("def p():\n " + name.toStdString() + "([" + std::to_string(outputs) + "])\nend\n");
        wrong.frames(10);
        QVERIFY(!wrong.error().empty());
    }

    // Spellings

    void exclamationMarkNegates() {
        QCOMPARE(messagesOf("ready=False\nif (! ready):\n textmsg(\"not ready\")\nend"),
                 (Texts{"not ready"}));
        QCOMPARE(
            messagesOf("a=True\nb=False\ntextmsg(!a)\ntextmsg(!b and a)\ntextmsg(!(a and b))\ntextmsg(!!a)"),
            (Texts{"False", "True", "True", "True"}));
        QCOMPARE(messagesOf("a=1\ntextmsg(a!=2)\ntextmsg(a != 1)\ntextmsg(!a==2)"),
                 (Texts{"True", "False", messagesOf("a=1\ntextmsg(not a==2)").front()}));
        QCOMPARE(messagesOf("while !get_standard_digital_in(0):\n textmsg(\"wait\")\n break\nend"),
                 (Texts{"wait"}));
        QVERIFY(!compile("def p():\n a = 1 ! 2\nend\n"));
        QVERIFY(!compile("def p():\n a = !\nend\n"));
    }

    void aBareNameIsAStatement() {
        QCOMPARE(messagesOf("side=1\nif side>1:\n side=0\nelse: side\n side=-1\nend\ntextmsg(side)"),
                 (Texts{"-1"}));
        QCOMPARE(messagesOf("a=1\na\ntextmsg(a)"), (Texts{"1"}));
        // Some expressions and all unknown names are refused.
        QVERIFY(!compile("def p():\n a=1\n a b\nend\n"));
        QVERIFY(!compile("def p():\n nowhere\nend\n"));
        QVERIFY(!compile("def p():\n 1\nend\n"));
    }

    // Containers of 5.15 and later

    void structMembersAreReadByIndex() {
        QCOMPARE(messagesOf("s=struct(a=4,b=5)\ntextmsg(s[1])\ntextmsg(s[0])"), (Texts{"5", "4"}));
        QCOMPARE(messagesOf("s=struct(a=4,b=5)\ns[1]=7\ntextmsg(s.b)"), (Texts{"7"}));
        QCOMPARE(messagesOf("s=struct(a=4,b=[1,2])\ns.b[1]=9\ns[1][0]=8\ntextmsg(s.b)"), (Texts{"[8,9]"}));
        QVERIFY(messagesOf("s=struct(a=4)\ntextmsg(s[1])").back().find("out of bounds") != std::string::npos);
        QVERIFY(messagesOf("s=struct(a=4)\ntextmsg(s[-1])").back().find("out of bounds") !=
                std::string::npos);
        QVERIFY(messagesOf("s=struct(a=4)\ns[0]=\"x\"").back().find("cannot become") != std::string::npos);
    }

    void aStructIsConvertedToAList() {
        QCOMPARE(messagesOf("t=struct(a=1.5,b=2.5)\nl=[0.0,0.0]\nl=t\ntextmsg(l)"), (Texts{"[1.5,2.5]"}));
        QCOMPARE(messagesOf("t=struct(a=1,b=2)\nl=[0,0]\nl=t\ntextmsg(l)\ntextmsg(length(l))"),
                 (Texts{"[1,2]", "2"}));
        QVERIFY(messagesOf("t=struct(a=1,b=2,c=3)\nl=[0,0]\nl=t").back().find("error") == 0);
        QVERIFY(messagesOf("t=struct(a=1,b=\"x\")\nl=[0,0]\nl=t").back().find("error") == 0);
        QVERIFY(messagesOf("t=struct(a=1)\nl=3\nl=t").back().find("error") == 0);
    }

    void listsHaveMethods() {
        const std::string list = "l=make_list(3,1,10)\nl.extend([4,5])\n";
        QCOMPARE(messagesOf(list + "l.remove(0)\ntextmsg(l.slice(1,3))\ntextmsg(l.excess_capacity())"),
                 (Texts{"[1,4]", "6"}));
        QCOMPARE(messagesOf(list +
                            "textmsg(l)\ntextmsg(l.slice(0,0))\ntextmsg(l.slice(0,5))\ntextmsg(l.slice(3))"),
                 (Texts{"[1,1,1,4,5]", "[]", "[1,1,1,4,5]", "[4,5]"}));
        QCOMPARE(messagesOf("l=make_list(0,\"\",3)\nl.extend([\"a\",\"b\"])\nl.remove(0)\ntextmsg(l)"),
                 (Texts{messagesOf("l=[\"b\"]\ntextmsg(l)").front()}));
        QCOMPARE(messagesOf("l=make_list(2,7,4)\nl.extend(l)\ntextmsg(l)"), (Texts{"[7,7,7,7]"}));
        for (const char* wrong :
             {"l.extend([1,2,3,4,5,6])", "l.extend(1)", "l.extend([\"x\"])", "l.remove(5)", "l.remove(-1)",
              "l.slice(3,2)", "l.slice(0,6)", "l.slice(-1,2)", "l.excess_capacity(1)"}) {
            QVERIFY2(messagesOf(list + wrong).back().find("error") == 0, wrong);
        }
        // If one element does not fit, no element is added.
        ScriptRun run("def p():\n global l=make_list(1,1,2)\n l.extend([2,3])\nend\n");
        run.frames(5);
        QVERIFY(!run.error().empty());
        QCOMPARE(run.value("l"), std::string("[1]"));
    }

    // Cost

    void anImmediatelyFailingConnectTakesAPeriod() {
        ScriptRun run;
        run.host.acceptSockets = false;
        run.load(
            "def p():\n global tries=0\n ok=False\n while (not ok):\n  "
            "ok=socket_open(\"10.9.8.7\",8500,\"cam\")\n"
            "  tries=tries+1\n end\nend\n");
        QCOMPARE(run.frames(50), Interpreter::State::Running);
        const int tries = std::stoi(run.value("tries"));
        QVERIFY2(tries >= 40 && tries <= 50, qPrintable(QString::number(tries)));
    }

    // Versions

    void functionsOfLaterSoftwareAreUnknown_data() {
        QTest::addColumn<QString>("call");
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::addColumn<bool>("known");
        QTest::newRow("str_cat 3.7") << "textmsg(str_cat(\"a\",\"b\"))" << 3 << 7 << false;
        QTest::newRow("str_cat 5.11") << "textmsg(str_cat(\"a\",\"b\"))" << 5 << 11 << true;
        QTest::newRow("str_cat 3.15") << "textmsg(str_cat(\"a\",\"b\"))" << 3 << 15 << true;
        QTest::newRow("tool_contact 5.3") << "textmsg(tool_contact([0,0,1,0,0,0]))" << 5 << 3 << false;
        QTest::newRow("tool_contact 5.4") << "textmsg(tool_contact([0,0,1,0,0,0]))" << 5 << 4 << true;
        QTest::newRow("tool_contact 10.7") << "textmsg(tool_contact([0,0,1,0,0,0]))" << 10 << 7 << true;
        for (const char* call :
             {"textmsg(str_len(\"a\"))", "s=struct(a=1)", "m=inv(p[0,0,0,0,0,0])", "j=get_jacobian()",
              "m=get_mass_matrix()", "g=jerk_gain_scaling_get()", "v=motion_version_get()",
              "set_baselight_off()", "high_holding_torque_enable()"}) {
            QTest::addRow("%s 3.5", call) << call << 3 << 5 << false;
            QTest::addRow("%s 5.24", call) << call << 5 << 24 << true;
        }
        QTest::newRow("protective_stop 3.7") << "protective_stop()" << 3 << 7 << false;
        QTest::newRow("protective_stop 3.8") << "protective_stop()" << 3 << 8 << true;
        QTest::newRow("get_tcp_offset 3.5") << "t=get_tcp_offset()" << 3 << 5 << false;
        QTest::newRow("get_tcp_offset 3.6") << "t=get_tcp_offset()" << 3 << 6 << true;
        QTest::newRow("force_mode_set_damping 3.4") << "force_mode_set_damping(0.1)" << 3 << 4 << false;
        QTest::newRow("force_mode_set_damping 3.5") << "force_mode_set_damping(0.1)" << 3 << 5 << true;
        QTest::newRow("gain scaling 3.15")
            << "force_mode_set_gain_scaling(0.1)" << 3 << 15 << true;  // fails when called
        QTest::newRow("gain scaling 5.0") << "force_mode_set_gain_scaling(0.1)" << 5 << 0 << true;
        QTest::newRow("get_target_waypoint 5.2") << "w=get_target_waypoint()" << 5 << 2 << false;
        QTest::newRow("get_target_waypoint 5.3") << "w=get_target_waypoint()" << 5 << 3 << true;
        QTest::newRow("get_target_waypoint 3.8") << "w=get_target_waypoint()" << 3 << 8 << false;
        QTest::newRow("get_target_waypoint 3.15") << "w=get_target_waypoint()" << 3 << 15 << true;
        QTest::newRow("history 5.3") << "q=get_actual_joint_positions_history(1)" << 5 << 3 << false;
        QTest::newRow("history 5.4") << "q=get_actual_joint_positions_history(1)" << 5 << 4 << true;
        QTest::newRow("movej 3.0") << "movej([0,0,0,0,0,0])" << 3 << 0 << true;
        QTest::newRow("make_list 5.14") << "l=make_list(1,1)" << 5 << 14 << false;
        QTest::newRow("list method 5.15") << "l=make_list(1,1,2)\nl.append(3)" << 5 << 15 << true;
    }
    void functionsOfLaterSoftwareAreUnknown() {
        QFETCH(QString, call);
        QFETCH(int, major);
        QFETCH(int, minor);
        QFETCH(bool, known);
        QCOMPARE(compilesOn(call.toStdString(),
                            {static_cast<unsigned>(major), static_cast<unsigned>(minor), 0, 0}),
                 known);
    }

    // End of a program sent over a socket

    void aMissingEndDoesNotSwallowTheNextProgram() {
        const std::string g = "def g():\n if True:\n  textmsg(\"x\")\nend\n";
        const std::string h = "def h():\n textmsg(\"the next program\")\nend\n";
        QCOMPARE(unitsOf(g + h), (Texts{g, h}));
        const CompileOutcome outcome = compile(g);
        QVERIFY(!outcome);
        QVERIFY2(outcome.error.text.find("syntax_error_on_line:4") == 0, outcome.error.text.c_str());
        // The last `end` is missing, a loop is not closed, and a secondary program follows.
        const std::string open = "def g():\n  textmsg(\"x\")\n";
        QCOMPARE(unitsOf(open + h), (Texts{open, h}));
        const std::string loop = "def g():\n\twhile True:\n\t\tsync()\nend\n";
        const std::string sec = "sec s():\n set_digital_out(0,True)\nend\n";
        QCOMPARE(unitsOf(loop + sec), (Texts{loop, sec}));
        QCOMPARE(unitsOf(loop + sec + h), (Texts{loop, sec, h}));
    }

    void programsWithoutIndentationAreNotSplit() {
        for (const std::string text :
             {"def p():\nif True:\ntextmsg(\"x\")\nend\nend\n",
              "def p():\ndef inner():\n textmsg(\"x\")\nend\ninner()\nend\n",
              "def p():\ndef inner():\ntextmsg(\"x\")\nend\ndef other():\nif True:\nend\nend\ninner()\nend\n",
              "def p():\n  def inner():\n    textmsg(\"x\")\n  end\n  inner()\nend\n",
              "def p():\n\n# a comment\ndef inner():\n  x=1\nend\nthread t():\n  sync()\nend\nend\n"}) {
            QCOMPARE(unitsOf(text + "def h():\nend\n"), (Texts{text, "def h():\nend\n"}));
        }
    }
};

QTEST_GUILESS_MAIN(TestUserPrograms)
#include "tst_user_programs.moc"
