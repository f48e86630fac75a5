// SPDX-License-Identifier: MIT
// Programs as saved by the teach pendant. Variables are defined once and then referenced. The tests also
// cover sequences, branches, loops, threads, and waypoints given by a variable.
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/support/primary_listener.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Returns the saved form of an expression, character by character. `@path@` is a reference to a variable
/// defined elsewhere in the file.
QString signs(const QString& text) {
    QString xml;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (text[i] == '@') {
            const qsizetype end = text.indexOf('@', i + 1);
            xml +=
                QStringLiteral("<ExpressionVariable><ProgramVariable reference=\"%1\"/></ExpressionVariable>")
                    .arg(text.mid(i + 1, end - i - 1));
            i = end;
            continue;
        }
        xml += QStringLiteral("<ExpressionChar character=\"%1\"/>").arg(QString(text[i]).toHtmlEscaped());
    }
    return xml;
}
QString expression(const QString& text) {
    return "<expression>" + signs(text) + "</expression>";
}
QString line(const QString& text) {
    return "<Script type=\"Line\">" + expression(text) + "</Script>";
}
QString withChildren(const QString& open, const QString& nodes, const QString& before = {}) {
    return '<' + open + '>' + before + "<children>" + nodes + "</children></" + open.section(' ', 0, 0) + '>';
}
QString branch(const char* type, const QString& condition, const QString& nodes) {
    return withChildren(QStringLiteral("If type=\"%1\" checkContinuously=\"false\"").arg(QLatin1String(type)),
                        nodes, condition.isEmpty() ? QString() : expression(condition));
}
QString assign(const QString& variable, const QString& value) {
    return "<Assignment valueSource=\"Expression\"><variable " + variable + "/>" + expression(value) +
           "</Assignment>";
}
QString mainProgram(const QString& nodes, bool once = true) {
    return withChildren(QStringLiteral("MainProgram runOnlyOnce=\"%1\"").arg(once ? "true" : "false"), nodes);
}
QString program(const QString& parts) {
    return withChildren(QStringLiteral("URProgram name=\"p\" createdIn=\"5.11.0\""), parts);
}

/// A robot with one loaded program in its folder.
struct Loaded {
    /// beside      other files of the folder, by name
    /// assumption  NAME=VALUE; empty: the defaults
    explicit Loaded(const QString& xml, const QMap<QString, QString>& beside = {},
                    const QString& assumption = {})
        : assumed(assumption) {
        write("p.urp", xml);
        for (auto file = beside.begin(); file != beside.end(); ++file) {
            write(file.key(), file.value());
        }
        reply = dashboard.ask("load p.urp");
    }
    void write(const QString& name, const QString& content) const {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::WriteOnly)) {
            file.write(content.toUtf8());
        }
    }
    bool play() { return dashboard.ask("play") == "Starting program\n"; }
    bool ends() {
        robot.controller.step(2);
        return robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 10);
    }
    quint64 outputs() const { return robot.controller.truth().digitalOutputs; }

    QString assumed;
    QTemporaryDir folder;
    VirtualRobot robot{[this] {
        auto options = VirtualRobot::options();
        options.programsFolder = options.urcapsFolder = folder.path();
        if (!assumed.isEmpty() && !simulator::assume(options.assumptions, assumed)) {
            qFatal("%s", qPrintable(assumed));
        }
        return options;
    }()};
    RawDashboard dashboard = robot.dashboard();
    QByteArray reply;
};

}  // namespace

class TestProgramFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // The program of the RTDE control loop example from Universal Robots. A thread reads setpoints into a
    // variable defined in Before Start. On command, the program moves to the setpoint and reports its
    // arrival.
    void aProgramFollowsSetpointsOfAnRtdeClient() {
        const QString goal = QStringLiteral("SpecialSequence/children/Assignment/variable");
        const QString up = QStringLiteral("../");
        const QString before = assign("name=\"goal\" prefersPersistentValue=\"false\"", "p[0,0,0,0,0,0]") +
                               line("rtde_set_watchdog(\"input_int_register_0\", 1, \"PAUSE\")") +
                               line("write_output_integer_register(0, 1)");
        const QString move =
            withChildren("Move motionType=\"MoveL\" speed=\"0.25\" acceleration=\"1.2\"",
                         "<Waypoint type=\"Variable\" name=\"w\"><motionParameters/><variable reference=\"" +
                             up.repeated(8) + goal + "\"/></Waypoint>",
                         "<feature class=\"GeomFeatureReference\" referencedName=\"Joint_0_name\"/>");
        const QString wait =
            withChildren("Loop type=\"While\"", line("sync()"),
                         expression(QStringLiteral("read_input_integer_register(0)\u225F1")));
        const QString go = branch("If",
                                  QStringLiteral("read_input_integer_register(0)\u225F1 and @") +
                                      up.repeated(6) + goal + QStringLiteral("@\u2260p[0, 0, 0, 0, 0, 0]"),
                                  "<Comment comment=\"a setpoint was received\"/>" + move +
                                      line("write_output_integer_register(0, 0)") + wait +
                                      line("write_output_integer_register(0, 1)"));
        QString reading = assign("name=\"read\"", "p[0,0,0,0,0,0]");
        for (int i = 0; i < 6; ++i) {
            reading += line(QStringLiteral("read[%1] = read_input_float_register(%1)").arg(i));
        }
        reading += assign("reference=\"" + up.repeated(6) + goal + '"', "read") + line("sync()");
        Loaded cell(program(withChildren("SpecialSequence type=\"BeforeStart\"", before) +
                            mainProgram(go + line("sync()"), false) +
                            withChildren("Thread name=\"Thread 1\" runOnlyOnce=\"false\"",
                                         withChildren("Loop type=\"Forever\"", reading))));
        QCOMPARE(cell.reply, QByteArray("Loading program: p.urp\n"));
        RawRtde rtde = cell.robot.rtde();
        QVERIFY(rtde.useVersion());
        QCOMPARE(rtde.setupOutputs(500, "output_int_register_0,actual_TCP_pose,runtime_state"),
                 QByteArray("\1INT32,VECTOR6D,UINT32"));
        QCOMPARE(rtde.setupInputs("input_double_register_0,input_double_register_1,input_double_register_2,"
                                  "input_double_register_3,input_double_register_4,input_double_register_5"),
                 QByteArray("\1DOUBLE,DOUBLE,DOUBLE,DOUBLE,DOUBLE,DOUBLE"));
        QCOMPARE(rtde.setupInputs("input_int_register_0"), QByteArray("\2INT32"));
        QVERIFY(rtde.start());
        QVERIFY(cell.play());
        QByteArray state;
        const auto until = [&](int announced, int command) {
            return cell.robot.stepUntil(
                [&] {
                    rtde.sendPackage('U', '\2' + bigEndian(qint32(command)));
                    cell.robot.controller.drainSockets();
                    cell.robot.controller.step();
                    state = rtde.next().payload;
                    return intAt(state, 1) == announced;
                },
                20);
        };
        for (const double z : {0.14, 0.21}) {
            QVERIFY(until(1, 0));
            QByteArray values("\1");
            for (const double v : {-0.12, -0.43, z, 0.0, 3.11, 0.04}) {
                values += bigEndian(v);
            }
            rtde.sendPackage('U', values);
            QVERIFY(until(1, 0));  // the thread has read the setpoints
            QVERIFY(until(0, 1));
            QVERIFY(std::abs(doubleAt(state, 5 + 16) - z) < 1e-3);
        }
        // Without the client, the watchdog performs the configured action.
        QVERIFY(cell.robot.stepUntil([&] { return cell.robot.programState() == RuntimeState::Paused; }, 3));
    }

    void programRepeatsUnlessItRunsOnce_data() {
        QTest::addColumn<bool>("once");
        QTest::newRow("once") << true;
        QTest::newRow("again") << false;
    }
    void programRepeatsUnlessItRunsOnce() {
        QFETCH(bool, once);
        Loaded cell(program(withChildren("SpecialSequence type=\"BeforeStart\"", assign("name=\"n\"", "0")) +
                            mainProgram(line("n = n + 1") + line("write_output_integer_register(3, n)") +
                                            "<Wait type=\"Sleep\"><waitTime>0.01</waitTime></Wait>",
                                        once)));
        QVERIFY(cell.play());
        cell.robot.controller.stepSeconds(0.5);
        RawRtde rtde = cell.robot.rtde();
        QVERIFY(rtde.useVersion());
        rtde.setupOutputs(500, "output_int_register_3");
        QVERIFY(rtde.start());
        cell.robot.controller.step();
        const qint32 rounds = intAt(rtde.next().payload, 1);
        QVERIFY(once ? rounds == 1 : rounds > 10);
        QCOMPARE(cell.robot.programState() == RuntimeState::Stopped, once);
    }

    void branchesWorkNextToAndInsideTheirIf_data() {
        QTest::addColumn<int>("n");
        QTest::addColumn<quint64>("outputs");
        QTest::newRow("if") << 1 << quint64(0b10001);
        QTest::newRow("else if") << 2 << quint64(0b01010);
        QTest::newRow("else") << 3 << quint64(0b01100);
    }
    void branchesWorkNextToAndInsideTheirIf() {
        QFETCH(int, n);
        QFETCH(quint64, outputs);
        const auto set = [](int output) {
            return line(QStringLiteral("set_digital_out(%1, True)").arg(output));
        };
        Loaded cell(program(mainProgram(
            assign("name=\"n\"", QString::number(n)) + branch("If", QStringLiteral("n\u225F1"), set(0)) +
            branch("ElseIf", QStringLiteral("n\u225F2"), set(1)) + branch("Else", {}, set(2)) +
            branch("If", QStringLiteral("n\u22641"), set(4) + branch("Else", {}, set(3))) + "<Halt/>" +
            set(7))));
        QVERIFY(cell.play());
        QVERIFY(cell.ends());
        QCOMPARE(cell.outputs(), outputs);
    }

    void variablesHaveTheirInitialValues() {
        Loaded cell(program(
            "<InitVariablesNode/>" +
            mainProgram(
                "<Assignment valueSource=\"Expression\"><variable name=\"seven\"><initializeExpression>" +
                signs("5+2") + "</initializeExpression></variable>" + expression("seven") +
                "</Assignment><Timer action=\"Start\"><variable name=\"timer_1\"/></Timer>" +
                branch("If", QStringLiteral("seven\u225F7"), line("set_digital_out(6, True)")))));
        QVERIFY(cell.play());
        QVERIFY(cell.ends());
        QCOMPARE(cell.outputs(), quint64(1) << 6);
    }

    // The nodes used by published pendant programs. Each program sets output 1 and no other output if the
    // node works.
    void theNodesOfThePendantRun_data() {
        QTest::addColumn<QString>("parts");
        QTest::addColumn<quint64>("outputs");
        const auto set = [](int output) {
            return line(QStringLiteral("set_digital_out(%1, True)").arg(output));
        };
        const auto row = [](const char* name, const QString& parts, quint64 outputs = 0b10) {
            QTest::newRow(name) << parts << outputs;
        };
        const QString sub = withChildren("SubProgram name=\"Sub 1\" keepHidden=\"false\"", set(1));
        const QString call =
            "<CallSubProgram><subprogram reference=\"../../../../SubProgram\"/></CallSubProgram>";
        row("InitVariablesNode", "<InitVariablesNode/>" + mainProgram(set(1)));
        row("SpecialSequence",
            withChildren("SpecialSequence type=\"BeforeStart\"", set(1)) + mainProgram("<Halt/>"));
        row("SuppressedNode", mainProgram("<SuppressedNode>" + set(0) + "</SuppressedNode>" + set(1)));
        row("SuppressedNode with children",
            mainProgram(withChildren("SuppressedNode", set(0) + "<Palletizing/>") + set(1)));
        row("suppressed node that cannot be identified",
            mainProgram("<SuppressedNode><Palletizing/></SuppressedNode>" + set(1)));
        row("suppressed variable that cannot be identified",
            mainProgram("<SuppressedNode><Assignment><variable name=\"x\"><initializeExpression>"
                        "<ExpressionRiddle/></initializeExpression></variable></Assignment>"
                        "</SuppressedNode>" +
                        set(1)));
        row("suppressed part", mainProgram(set(1)) + "<SuppressedNode><Event/></SuppressedNode>");
        row("suppressed between if and else",
            mainProgram(branch("If", "False", set(0)) + "<SuppressedNode>" +
                        branch("ElseIf", "True", set(2)) + "</SuppressedNode>" + branch("Else", {}, set(1))));
        row("SubProgram called", mainProgram(call) + sub);
        row("SubProgram not called",
            mainProgram(set(1)) + withChildren("SubProgram name=\"s\"", set(0) + "<Palletizing/>"));
        row("SubProgram reported where it is called",
            mainProgram("<CallSubProgram>" + withChildren("subprogram name=\"s\"", set(1)) +
                        "</CallSubProgram>") +
                "<SubProgram reference=\"../MainProgram/children/CallSubProgram/subprogram\"/>");
        row("two of one name",
            mainProgram(call + "<CallSubProgram><subprogram reference=\"../../../../SubProgram[2]\"/>"
                               "</CallSubProgram>") +
                sub + withChildren("SubProgram name=\"Sub_1\"", set(2)),
            0b110);
        row("one calls another",
            mainProgram("<CallSubProgram><subprogram reference=\"../../../../SubProgram[2]\"/>"
                        "</CallSubProgram>") +
                sub +
                withChildren("SubProgram name=\"outer\"",
                             "<CallSubProgram><subprogram reference=\"../../../../SubProgram\"/>"
                             "</CallSubProgram>" +
                                 set(2)),
            0b110);
        row("called from a thread and in a loop",
            mainProgram(
                withChildren("Loop type=\"Counting\" count=\"3\"",
                             "<CallSubProgram><subprogram reference=\"../../../../../../SubProgram\"/>"
                             "</CallSubProgram>") +
                "<Wait type=\"Sleep\"><waitTime>0.02</waitTime></Wait>") +
                withChildren("SubProgram name=\"s\"",
                             line("n = n + 1") + branch("If", QStringLiteral("n\u225F4"), set(1))) +
                withChildren("SpecialSequence type=\"BeforeStart\"", assign("name=\"n\"", "0")) +
                withChildren("Thread name=\"t\" runOnlyOnce=\"true\"", call));
        row("Script Line", mainProgram(set(1)));
        row("Script File",
            mainProgram("<Script type=\"File\"><cachedContents>set_digital_out(1, True)\n"
                        "</cachedContents><file resolves-to=\"file\">gone.script</file></Script>"));
        row("Assignment", mainProgram(assign("name=\"a\"", "1") + line("set_digital_out(a, True)")));
        row("If", mainProgram(branch("If", "True", set(1))));
        row("Else", mainProgram(branch("If", "False", set(0) + branch("Else", {}, set(1)))));
        row("Loop While", mainProgram(assign("name=\"a\"", "0") +
                                      withChildren("Loop type=\"While\"", line("a = a + 1") + line("sync()"),
                                                   expression("a < 3")) +
                                      branch("If", QStringLiteral("a\u225F3"), set(1))));
        row("Loop Forever", mainProgram(withChildren("Loop type=\"Forever\"", set(1) + "<Halt/>")));
        row("Popup",
            mainProgram(set(1) + "<Popup message=\"a &quot;word&quot;&#10;more\" haltProgram=\"true\"/>"));
        row("Halt", mainProgram(set(1) + "<Halt/>" + set(0)));
        row("Comment", mainProgram("<Comment comment=\"end\"/>" + set(1)));
        row("Folder", mainProgram(withChildren("Folder name=\"f\"", set(1))));
        row("Wait Sleep", mainProgram("<Wait type=\"Sleep\"><waitTime>0.01</waitTime></Wait>" + set(1)));
        row("Timer", mainProgram("<Timer action=\"Start\"><variable name=\"t\"/></Timer>" +
                                 branch("If", QStringLiteral("t\u225F0"), set(1))));
        row("Thread", mainProgram("<Wait type=\"Sleep\"><waitTime>0.02</waitTime></Wait>") +
                          withChildren("Thread name=\"Thread_1\" runOnlyOnce=\"true\"", set(1)));
        row("ExpressionToken", mainProgram("<If type=\"If\"><expression><ExpressionToken token=\"not\"/>"
                                           "<ExpressionToken token=\"False\"/></expression><children>" +
                                           set(1) + "</children></If>"));
        row("ExpressionVariable", mainProgram(assign("name=\"a\"", "1") +
                                              branch("If", "@../../../../Assignment/variable@ < 2", set(1))));
        const QString io = "<ExpressionIO><pin class=\"com.ur.Pin\" referencedName=\"%1\"/></ExpressionIO>";
        row("ExpressionIO",
            mainProgram("<If type=\"If\"><expression><ExpressionToken token=\" not \"/>" +
                        io.arg("digital_in[7]") + "</expression><children>" + set(1) + "</children></If>"));
        row("ExpressionIO of outputs",
            mainProgram(set(1) + "<If type=\"If\"><expression>" + io.arg("digital_out[1]") +
                        "</expression><children>" + set(2) + "</children></If>"),
            0b110);
        row("ExpressionIO reported elsewhere",
            mainProgram(
                "<Assignment><variable name=\"a\"/><expression>" + io.arg("config_in[0]") +
                "</expression></Assignment><If type=\"If\"><expression><ExpressionToken token=\"not\"/>"
                "<ExpressionIO><pin reference=\"../../../../Assignment/expression/ExpressionIO/pin\"/>"
                "</ExpressionIO></expression><children>" +
                set(1) + "</children></If>"));
        QString every;
        for (const char* pin :
             {"digital_in[0]", "digital_out[7]", "config_in[7]", "config_out[0]", "tool_in[1]", "tool_out[1]",
              "analog_in[1]", "analog_out[1]", "tool_analog_in[1]", "GP_bool_in[127]", "GP_int_in[47]",
              "GP_float_in[0]", "GP_bool_out[64]", "GP_int_out[24]", "GP_float_out[24]"}) {
            every +=
                "<Assignment><variable name=\"v\"/><expression>" + io.arg(pin) + "</expression></Assignment>";
        }
        every.replace("name=\"v\"", "name=\"v%1\"");
        for (int i = 0; every.contains("%1"); ++i) {
            every.replace(every.indexOf("%1"), 2, QString::number(i));
        }
        row("ExpressionIO of every kind", mainProgram(every + set(1)));
    }
    void theNodesOfThePendantRun() {
        QFETCH(QString, parts);
        QFETCH(quint64, outputs);
        Loaded cell(program(parts));
        RawPrimary primary = cell.robot.primary();
        QCOMPARE(cell.reply, QByteArray("Loading program: p.urp\n"));
        QVERIFY(cell.play());
        QVERIFY(cell.ends());
        const Heard heard(primary);
        QVERIFY2(heard.exceptions.empty(), heard.exceptions.empty() ? "" : heard.exceptions[0].mid(8));
        QCOMPARE(cell.outputs(), outputs);
    }

    void movesEndWhereTheirWaypointsAre_data() {
        QTest::addColumn<QString>("node");
        QTest::addColumn<double>("base");
        const QString position =
            "<position><JointAngles angles=\"%1, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310\"/>"
            "<TCPOffset pose=\"0,0,0,0,0,0\"/><Kinematics status=\"NOT_INITIALIZED\" validChecksum=\"false\">"
            "<deltaTheta value=\"0,0,0,0,0,0\"/></Kinematics></position>"
            "<BaseToFeature pose=\"0,0,0,0,0,0\"/>";
        const QString fixed =
            "<Waypoint type=\"Fixed\" name=\"w\" kinematicsFlags=\"4\">%2" + position + "</Waypoint>";
        const auto move = [](const char* type, const QString& waypoints) {
            return withChildren(QStringLiteral("Move motionType=\"%1\" speed=\"0.5\" acceleration=\"1.2\" "
                                               "useActiveTCP=\"false\"")
                                    .arg(QLatin1String(type)),
                                waypoints);
        };
        QTest::newRow("MoveJ") << move("MoveJ", fixed.arg("-1.5", "<motionParameters/>")) << -1.5;
        QTest::newRow("MoveL") << move("MoveL", fixed.arg("-1.55", "<motionParameters/>")) << -1.55;
        QTest::newRow("parameters of its own")
            << move("MoveJ", fixed.arg("-1.3",
                                       "<motionParameters jointSpeed=\"1.05\" "
                                       "jointAcceleration=\"1.4\" blendRadius=\"0.01\"/>") +
                                 fixed.arg("-1.4", "<motionParameters/>"))
            << -1.4;
        QTest::newRow("suppressed waypoint")
            << move("MoveJ", fixed.arg("-1.5", "") + "<SuppressedNode>" + fixed.arg("1.0", "") +
                                 "</SuppressedNode><Comment comment=\"c\"/>")
            << -1.5;
        QTest::newRow("SafeHome") << "<SafeHome/>" << 0.0;
        QTest::newRow("SafeHome with its position")
            << "<SafeHome speed=\"0.8\" acceleration=\"1\">" + position.arg("-1.2") + "</SafeHome>" << -1.2;
        QTest::newRow("SafeHome in a move")
            << move("MoveJ", "<SafeHome>" + position.arg("-1.25") + "</SafeHome>") << -1.25;
    }
    void movesEndWhereTheirWaypointsAre() {
        QFETCH(QString, node);
        QFETCH(double, base);
        Loaded cell(program(mainProgram(node)));
        QCOMPARE(cell.reply, QByteArray("Loading program: p.urp\n"));
        QVERIFY(cell.play());
        QVERIFY(cell.ends());
        QVERIFY2(std::abs(cell.robot.controller.truth().q[0] - base) < 1e-3,
                 qPrintable(QString::number(cell.robot.controller.truth().q[0])));
    }

    // Scripts and subprograms in separate files are read from the programs folder.
    void referencedFilesAreReadFromTheFolder_data() {
        QTest::addColumn<QString>("node");
        const auto script = [](const char* file) {
            return QStringLiteral("<Script type=\"File\"><file resolves-to=\"file\">%1</file></Script>")
                .arg(QLatin1String(file));
        };
        const auto sub = [](const char* file) {
            return QStringLiteral(
                       "<CallSubProgram><subprogram name=\"s\"><file resolves-to=\"file\">%1</file>"
                       "</subprogram></CallSubProgram>")
                .arg(QLatin1String(file));
        };
        QTest::newRow("script") << script("one.script");
        QTest::newRow("script by the robot's path") << script("/programs/one.script");
        QTest::newRow("script by the vendor's path") << script("/ursim/programs/one.script");
        QTest::newRow("sub program") << sub("one.urp");
        QTest::newRow("sub program by the robot's path") << sub("/programs/one.urp");
        QTest::newRow("sub program that calls itself") << sub("round.urp");
        QTest::newRow("twice") << sub("one.urp") + sub("/programs/one.urp");
    }
    void referencedFilesAreReadFromTheFolder() {
        QFETCH(QString, node);
        const QString one =
            mainProgram("<Assignment><variable name=\"out\"><initializeExpression>" + signs("1") +
                        "</initializeExpression></variable>" + expression("out") + "</Assignment>" +
                        line("set_digital_out(out, True)"));
        const QString round = mainProgram(
            branch("If", "not get_digital_out(1)",
                   line("set_digital_out(1, True)") +
                       "<CallSubProgram><subprogram name=\"r\"><file>round.urp</file></subprogram>"
                       "</CallSubProgram>"));
        Loaded cell(program(mainProgram(node)), {{"one.script", "set_digital_out(1, True)\n"},
                                                 {"one.urp", program(one)},
                                                 {"round.urp", program(round)}});
        QCOMPARE(cell.reply, QByteArray("Loading program: p.urp\n"));
        QVERIFY(cell.play());
        QVERIFY(cell.ends());
        QCOMPARE(cell.outputs(), quint64(0b10));
    }

    void untranslatableProgramIsRefusedWithTheReason_data() {
        QTest::addColumn<QString>("xml");
        QTest::addColumn<QString>("why");
        const QString good = line("sync()");
        const auto row = [](const char* name, const QString& parts, const char* why) {
            QTest::newRow(name) << program(parts) << QString::fromLatin1(why);
        };
        row("no main program", "<InitVariablesNode/>", "MainProgram is missing");
        row("unknown node", mainProgram(good + "\n\n<Palletizing name=\"tray\"/>"),
            "line 3, Palletizing 'tray': this node is not simulated");
        row("node of a URCap", mainProgram("<Contributed strategyURCapName=\"Welding\"/>"), "Welding");
        row("unknown part", mainProgram(good) + "<Riddle/>", "Riddle");
        row("variable from nowhere",
            mainProgram(assign("reference=\"../../../../../../nothing/variable\"", "1")),
            "is not a variable");
        row("variable waypoint in another frame",
            mainProgram(withChildren("Move motionType=\"MoveL\" speed=\"1\" acceleration=\"1\"",
                                     "<Waypoint type=\"Variable\" name=\"w1\"><variable "
                                     "name=\"w\"/></Waypoint>",
                                     "<feature referencedName=\"table\"/>")),
            "Waypoint 'w1'");
        row("speed that is none",
            mainProgram(withChildren("Move motionType=\"MoveJ\" speed=\"fast\"",
                                     "<Waypoint type=\"Variable\"><variable "
                                     "name=\"w\"/></Waypoint>")),
            "speed is not a number");
        row("circular move", mainProgram("<Move motionType=\"MoveC\"/>"), "MoveC");
        row("pin with a name of an installation",
            mainProgram("<Assignment><variable name=\"a\"/><expression><ExpressionIO><pin "
                        "referencedName=\"part present\"/></ExpressionIO></expression></Assignment>"),
            "pin 'part present'");
        row("pin there is none of",
            mainProgram("<Assignment><variable name=\"a\"/><expression><ExpressionIO><pin "
                        "referencedName=\"digital_in[8]\"/></ExpressionIO></expression></Assignment>"),
            "digital_in[8]");
        row("wait of another kind", mainProgram("<Wait type=\"Riddle\"/>"), "Riddle");
        row("sub program from nowhere",
            mainProgram("<CallSubProgram><subprogram reference=\"../nowhere\"/></CallSubProgram>"),
            "is not a subprogram");
        row("sub program that cannot be identified",
            mainProgram("<CallSubProgram>" + withChildren("subprogram name=\"s\"", "<Palletizing/>") +
                        "</CallSubProgram>"),
            "Palletizing");
        row("script outside", mainProgram("<Script type=\"File\"><file>../one.script</file></Script>"),
            "'../one.script'");
        row("script elsewhere", mainProgram("<Script type=\"File\"><file>/etc/hostname</file></Script>"),
            "'/etc/hostname'");
        row("sub program outside",
            mainProgram(
                "<CallSubProgram><subprogram name=\"s\"><file>/programs/../one.urp</file></subprogram>"
                "</CallSubProgram>"),
            "'/programs/../one.urp'");
        row("sub program that is none",
            mainProgram("<CallSubProgram><subprogram name=\"s\"><file>other.xml</file></subprogram>"
                        "</CallSubProgram>"),
            "'other.xml' is not a program");
        QTest::newRow("saved before PolyScope 3") << "<gui.program.ProgramRootNode serialization=\"custom\"/>"
                                                  << "before PolyScope 3";
        QTest::newRow("no XML") << "<URProgram><children>"
                                << "line 1: ";
        QTest::newRow("too deep") << "<URProgram>" + QString("<a>").repeated(500) << "too deep";
    }
    void untranslatableProgramIsRefusedWithTheReason() {
        QFETCH(QString, xml);
        QFETCH(QString, why);
        Loaded cell(program(mainProgram({})), {{"other.xml", "<Installation/>"}});
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("^Error while loading program: p\\.urp: .*" +
                                                              QRegularExpression::escape(why)));
        RawPrimary primary = cell.robot.primary();
        cell.robot.controller.drainSockets();
        cell.robot.controller.step();
        primary.takeAll();
        cell.write("p.urp", xml);
        QCOMPARE(cell.dashboard.ask("load p.urp"), QByteArray("Error while loading program: p.urp\n"));
        cell.robot.controller.step();
        const Heard heard(primary);
        QCOMPARE(heard.texts.size(), qsizetype(1));
        QVERIFY2(heard.texts[0].contains(why.toUtf8()), heard.texts[0]);
        QVERIFY2(heard.texts[0].startsWith("Error while loading program: p.urp: "), heard.texts[0]);
    }

    // As on the teach pendant, an unfinished program can be edited but not played.
    void anUnfinishedProgramLoadsAndDoesNotPlay_data() {
        QTest::addColumn<QString>("parts");
        QTest::addColumn<QString>("why");
        const auto row = [](const char* name, const QString& nodes, const char* why) {
            QTest::newRow(name) << mainProgram(nodes) << QString::fromLatin1(why);
        };
        row("if without condition", branch("If", {}, line("sync()")), "line 1, If: the condition is missing");
        row("loop without condition", withChildren("Loop type=\"While\"", line("sync()")), "Loop");
        row("no pin",
            "<Assignment><variable name=\"a\"/><expression><ExpressionIO/></expression></Assignment>",
            "name of the pin is missing");
        row("wait for no input", "<Wait type=\"DigitalInput\"/>", "Wait");
        row("set of no output", "<Set type=\"DigitalOutput\"/>", "Set");
        row("assignment to nothing", "<Assignment/>", "the variable is missing");
        row("waypoint without position",
            "<Move motionType=\"MoveJ\"><children><Waypoint type=\"Fixed\" name=\"w\"/></children></Move>",
            "Waypoint 'w': the position is missing");
        row("call of nothing", "<CallSubProgram/>", "CallSubProgram");
        row("placeholder", "<Placeholder/>", "Placeholder");
        QTest::newRow("event without condition") << mainProgram(line("sync()")) + "<Event/>"
                                                 << "Event";
    }
    void anUnfinishedProgramLoadsAndDoesNotPlay() {
        QFETCH(QString, parts);
        QFETCH(QString, why);
        Loaded cell(program(parts));
        QCOMPARE(cell.reply, QByteArray("Loading program: p.urp\n"));
        QTest::ignoreMessage(QtWarningMsg,
                             QRegularExpression("is incomplete.*" + QRegularExpression::escape(why)));
        QVERIFY(!cell.play());
    }

    // Reduced versions of users' programs with old syntax, references, and elements of the installation.
    void programsOfUsersRun_data() {
        QTest::addColumn<QString>("parts");
        QTest::addColumn<QString>("text");  ///< text that the program reports
        QTest::addColumn<quint64>("outputs");
        QTest::addColumn<double>("base");  ///< final position of the base joint; NaN if it does not move
        const QString joints =
            "<position><JointAngles angles=\"%1, -1.5, 1.5, -1.5, -1.5, 0.0\"/></position>";
        const auto waypoint = [&joints](const char* name, const char* base) {
            return QStringLiteral("<Waypoint type=\"Fixed\" name=\"%1\"><motionParameters/>").arg(name) +
                   joints.arg(QLatin1String(base)) + "</Waypoint>";
        };
        const auto move = [](const QString& nodes, const char* type = "MoveJ", const QString& feature = {}) {
            return withChildren(QStringLiteral("Move motionType=\"%1\" speed=\"1.0\" acceleration=\"1.4\" "
                                               "blendRadius=\"0.01\" useActiveTCP=\"true\"")
                                    .arg(QLatin1String(type)),
                                nodes, feature);
        };
        const QString base = "<feature class=\"GeomFeatureReference\" referencedName=\"Joint_0_name\"/>";
        const auto row = [](const char* name, const QString& parts, const char* text = "",
                            quint64 outputs = 0, double end = qQNaN()) {
            QTest::newRow(name) << parts << QString::fromLatin1(text) << outputs << end;
        };
        row("position in attributes",
            mainProgram(move(
                "<Waypoint type=\"Fixed\" name=\"W1\" kinematicsFlags=\"4\"><motionParameters/><position "
                "joints=\"0.3, -1.5, 1.5, -1.5, -1.5, 0.0\" pose=\"-0.1, -0.3, 0.4, 0.0, 3.1, "
                "0.0\"/></Waypoint>")),
            "", 0, 0.3);
        row("feature by reference",
            mainProgram(move(waypoint("W1", "0.1"), "MoveJ", base) +
                        assign("name=\"goal\"", "[0.2, -1.5, 1.5, -1.5, -1.5, 0]") +
                        move("<Waypoint type=\"Variable\" name=\"V\"><motionParameters/><variable "
                             "reference=\"../../../../Assignment/variable\"/></Waypoint>",
                             "MoveJ",
                             "<feature class=\"GeomFeatureReference\" reference=\"../../Move/feature\"/>")),
            "", 0, 0.2);
        row("feature variable",
            mainProgram("<Assignment valueSource=\"Expression\"><variable "
                        "name=\"a\"/><expression><ExpressionVariable>"
                        "<GeomFeatureVariable "
                        "featureName=\"Stack\"/></ExpressionVariable></expression></Assignment>" +
                        line("textmsg(a)")),
            "p[0.3,0.2,0.1,0,0,0]");
        row("initial values",
            "<InitVariablesNode><variables><variable name=\"armed\"><expression><ExpressionToken token=\" "
            "True "
            "\"/></expression></variable></variables></InitVariablesNode>" +
                withChildren("MainProgram runOnlyOnce=\"true\" InitVariablesNode=\"true\"",
                             line("textmsg(armed)")),
            "True");
        row("set an output",
            mainProgram("<Set type=\"DigitalOutput\"><pin referencedName=\"digital_out[1]\"/><digitalValue>1"
                        "</digitalValue></Set>"),
            "", 0b10);
        row("set an output with a name of the installation",
            mainProgram("<Set type=\"DigitalOutput\"><pin referencedName=\"lamp\"/><digitalValue>1"
                        "</digitalValue></Set>"),
            "", 0b100);
        row("circle in a process move",
            mainProgram(move(waypoint("W1", "0.0")) +
                        move(withChildren("CircleMove OrientationMode=\"FIXED\"",
                                          waypoint("Via", "0.05") + waypoint("End", "0.1")),
                             "MoveP")),
            "", 0, 0.1);
        row("force",
            mainProgram(
                "<Force type=\"Frame\">" + base +
                "<selection value=\"0, 0, 1, 0, 0, 0\"/><wrench value=\"0.0, 0.0, -2.0, 0.0, 0.0, 0.0\"/>"
                "<limitsForce value=\"0.15, 0.15, 0.15, 1.0, 1.0, 1.0\"/><limitsMotion value=\"0.1, 0.1, "
                "0.1, "
                "0.3, 0.3, 0.3\"/><children><Wait type=\"Sleep\"><waitTime>0.3</waitTime></Wait></children>"
                "</Force>" +
                line("textmsg(1)")),
            "1");
        row("wait for an input",
            mainProgram("<Wait type=\"DigitalInput\"><pin referencedName=\"digital_in[0]\"/><digitalValue>0"
                        "</digitalValue></Wait>" +
                        line("textmsg(2)")),
            "2");
        row("node within a move",
            mainProgram(move(waypoint("W1", "0.2") + "<Wait type=\"Sleep\"><waitTime>0.2</waitTime></Wait>" +
                             line("textmsg(3)"))),
            "3", 0, 0.2);
        row("name of a waypoint", mainProgram(move(waypoint("W1", "0.5")) + line("textmsg(W1_q[0])")), "0.5",
            0, 0.5);
        row("event",
            mainProgram("<Wait type=\"Sleep\"><waitTime>1.0</waitTime></Wait>" + line("textmsg(4)")) +
                "<Event><expression><ExpressionToken token=\" True \"/></expression><children><Halt/>"
                "</children></Event>");
        row("popup that ends the program",
            mainProgram("<Popup type=\"Error\" haltProgram=\"true\" message=\"m\" inputType=\"Text\"/>" +
                        line("textmsg(5)")));
    }
    void programsOfUsersRun() {
        QFETCH(QString, parts);
        QFETCH(QString, text);
        QFETCH(quint64, outputs);
        QFETCH(double, base);
        Loaded cell(
            program(parts),
            {{"default.installation",
              "<Installation><IOs><DigitalOutputNames value=\", , lamp, , , , , \"/></IOs><Features>"
              "<GeomPoseNode><GeomPoseNode isVariable=\"true\" name=\"Stack\"><toolPosition value=\"0.3, "
              "0.2, "
              "0.1\"/><toolAxisAngle value=\"0.0, 0.0, 0.0\"/></GeomPoseNode></GeomPoseNode></Features>"
              "</Installation>"}});
        RawPrimary primary = cell.robot.primary();
        QCOMPARE(cell.reply, QByteArray("Loading program: p.urp\n"));
        QVERIFY(cell.play());
        QVERIFY(cell.ends());
        const Heard heard(primary);
        QVERIFY2(heard.exceptions.empty(), heard.exceptions.empty() ? "" : heard.exceptions[0].mid(8));
        QCOMPARE(heard.texts.join('|'), text.toUtf8());
        QCOMPARE(cell.outputs(), outputs);
        const double start = simulator::kHomeJoints[0];
        QVERIFY(std::abs(cell.robot.controller.truth().q[0] - (std::isnan(base) ? start : base)) < 1e-3);
    }

    // The program continues when the operator confirms the popup.
    void aPopupWaitsForTheOperator() {
        Loaded cell(program(mainProgram(
            "<Popup type=\"Message\" haltProgram=\"false\" message=\"hands off?\" inputType=\"Text\"/>" +
            line("textmsg(7)"))));
        RawPrimary primary = cell.robot.primary();
        QVERIFY(cell.play());
        cell.robot.controller.stepSeconds(1);
        QCOMPARE(Heard(primary).texts, QByteArrayList());
        cell.dashboard.ask("close popup");
        QVERIFY(cell.ends());
        QCOMPARE(Heard(primary).texts, QByteArrayList{"7"});
    }

    void eachNodeReportsItsLineOfTheProgram() {
        Loaded cell(program(mainProgram(
            withChildren("Folder name=\"pick\"", "<Wait type=\"Sleep\"><waitTime>0.1</waitTime></Wait>") +
            "<SuppressedNode>" + line("sync()") + "</SuppressedNode><Halt/>")));
        RawPrimary primary = cell.robot.primary();
        QVERIFY(cell.play());
        QVERIFY(cell.ends());
        QByteArrayList labels;
        for (const QByteArray& body : primary.messages(1)) {
            labels << QByteArray::number(intAt(body, 0)) + ' ' + body.mid(4);
        }
        QCOMPARE(labels, (QByteArrayList{"1 Robot Program", "2 pick", "3 Wait: 0.1", "5 Halt"}));
    }

    void aUrcapNodeRunsItsStandInOrTheChosenOption_data() {
        QTest::addColumn<QString>("nodeClass");
        QTest::addColumn<QString>("assumption");
        QTest::addColumn<QByteArray>("texts");
        QTest::newRow("stand-in") << "com.example.WeldNode"
                                  << "" << QByteArray("12.5bead|True|end");
        QTest::newRow("skip") << "com.example.Other"
                              << "unknown-urcap=skip"
                              << QByteArray("Other (Example) is not simulated and was skipped|end");
        QTest::newRow("ask") << "com.example.Other"
                             << "unknown-urcap=ask" << QByteArray("end");
    }
    void aUrcapNodeRunsItsStandInOrTheChosenOption() {
        QFETCH(QString, nodeClass);
        QFETCH(QString, assumption);
        QFETCH(QByteArray, texts);
        const QString node = QStringLiteral(
                                 "<Contributed strategyClass=\"%1\" strategyProgramNodeType=\"Other\" "
                                 "strategyURCapName=\"Example\"><dataModel><data key=\"current\" "
                                 "value=\"12.5\"/><data key=\"on\" value=\"true\"/></dataModel>"
                                 "</Contributed>")
                                 .arg(nodeClass);
        const QString standIn =
            "# class: WeldNode\n# default shape: bead\n# setup\ndef weld(a, b, c):\n  textmsg(a, b)\n  "
            "textmsg(c)\nend\n# node\nweld({current}, {shape}, {on})\n";
        Loaded cell(program(mainProgram(node + line("textmsg(\"end\")"))), {{"weld.script", standIn}},
                    assumption);
        QCOMPARE(cell.reply, QByteArray("Loading program: p.urp\n"));
        RawPrimary primary = cell.robot.primary();
        QVERIFY(cell.play());
        cell.robot.controller.stepSeconds(0.5);
        QCOMPARE(cell.robot.programState() == RuntimeState::Stopped, !assumption.endsWith("ask"));
        cell.dashboard.ask("close popup");
        QVERIFY(cell.ends());
        QCOMPARE(Heard(primary).texts.join('|'), texts);
    }

    // "Level" is the default, so the event runs again while its condition is true.
    void anEventRunsOnceWhenItNeedsAnEdge_data() {
        QTest::addColumn<QString>("assumption");
        QTest::addColumn<bool>("again");
        QTest::newRow("level") << "event-node=level" << true;
        QTest::newRow("edge") << "event-node=edge" << false;
    }
    void anEventRunsOnceWhenItNeedsAnEdge() {
        QFETCH(QString, assumption);
        QFETCH(bool, again);
        Loaded cell(program(mainProgram("<Wait type=\"Sleep\"><waitTime>0.5</waitTime></Wait>") +
                            "<Event><expression><ExpressionToken token=\" True \"/></expression><children>" +
                            line("textmsg(1)") +
                            "<Wait type=\"Sleep\"><waitTime>0.1</waitTime></Wait></children></Event>"),
                    {}, assumption);
        RawPrimary primary = cell.robot.primary();
        QVERIFY(cell.play());
        QVERIFY(cell.ends());
        QCOMPARE(Heard(primary).texts.size() > 1, again);
    }

    // The first event whose condition is true runs. With "level", the conditions stay true, so the second
    // event never runs.
    void anEarlierEventComesFirst_data() {
        QTest::addColumn<QString>("assumption");
        QTest::addColumn<bool>("secondRuns");
        QTest::newRow("level") << "event-node=level" << false;
        QTest::newRow("edge") << "event-node=edge" << true;
    }
    void anEarlierEventComesFirst() {
        QFETCH(QString, assumption);
        QFETCH(bool, secondRuns);
        const auto event = [](const QString& node) {
            return "<Event><expression><ExpressionToken token=\" True \"/></expression><children>" + node +
                   "<Wait type=\"Sleep\"><waitTime>0.1</waitTime></Wait></children></Event>";
        };
        Loaded cell(program(mainProgram("<Wait type=\"Sleep\"><waitTime>0.5</waitTime></Wait>") +
                            event(line("textmsg(1)")) + event(line("textmsg(2)"))),
                    {}, assumption);
        RawPrimary primary = cell.robot.primary();
        QVERIFY(cell.play());
        QVERIFY(cell.ends());
        const QList<QByteArray> texts = Heard(primary).texts;
        QCOMPARE(texts.front(), QByteArray("1"));
        QCOMPARE(texts.contains("2"), secondRuns);
    }

    // A subprogram that is called only by a script is also part of the program.
    void aScriptMayCallASubProgram() {
        Loaded cell(program(mainProgram(line("Sub_1()")) +
                            withChildren("SubProgram name=\"Sub 1\"", line("set_digital_out(3, True)"))));
        QVERIFY(cell.play());
        QVERIFY(cell.ends());
        QCOMPARE(cell.outputs(), quint64(0b1000));
    }

    // The file may be damaged between load and play.
    void playReportsWhyTheProgramNoLongerLoads() {
        Loaded cell(program(mainProgram(line("sync()"))));
        RawPrimary primary = cell.robot.primary();
        cell.write("p.urp", program(mainProgram("<Palletizing/>")));
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("Palletizing"));
        QVERIFY(!cell.play());
        cell.robot.controller.step();
        const Heard heard(primary);
        QCOMPARE(heard.texts.size(), qsizetype(1));
        QVERIFY2(heard.texts[0].contains("Palletizing"), heard.texts[0]);
    }
};

QTEST_GUILESS_MAIN(TestProgramFiles)
#include "tst_program_files.moc"
