// SPDX-License-Identifier: MIT
// Programs of the pendant, as it saves them: variables that are told once and referred to, sequences,
// branches, loops, threads, waypoints given by a variable.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// An expression as it is saved, sign by sign. `@path@` in it stands for a variable told elsewhere.
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

/// A robot with one program in its folder, loaded.
struct Loaded {
    explicit Loaded(const QString& xml) {
        QFile file(folder.filePath("p.urp"));
        if (file.open(QIODevice::WriteOnly)) {
            file.write(xml.toUtf8());
        }
        file.close();
        reply = dashboard.ask("load p.urp");
    }
    bool play() { return dashboard.ask("play") == "Starting program\n"; }
    bool ends() {
        robot.controller.step(2);
        return robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 10);
    }
    quint64 outputs() const { return robot.controller.truth().digitalOutputs; }

    QTemporaryDir folder;
    VirtualRobot robot{[this] {
        auto options = VirtualRobot::options();
        options.programsFolder = folder.path();
        return options;
    }()};
    RawDashboard dashboard = robot.dashboard();
    QByteArray reply;
};

}  // namespace

class TestProgramFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // What the vendor's RTDE client comes with for its control loop: a thread reads set points into a
    // variable told before the start, the program moves there on command and says when it is there.
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
                                  "<Comment comment=\"a set point has come\"/>" + move +
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
            QVERIFY(until(1, 0));  // the thread takes them in
            QVERIFY(until(0, 1));
            QVERIFY(std::abs(doubleAt(state, 5 + 16) - z) < 1e-3);
        }
        // Without the client the watchdog acts as it was told to.
        QVERIFY(cell.robot.stepUntil([&] { return cell.robot.programState() == RuntimeState::Paused; }, 3));
    }

    void aProgramBeginsAnewAtItsEndUnlessItRunsOnce_data() {
        QTest::addColumn<bool>("once");
        QTest::newRow("once") << true;
        QTest::newRow("again") << false;
    }
    void aProgramBeginsAnewAtItsEndUnlessItRunsOnce() {
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

    void branchesAreTakenWhereTheyStandBesideOrWithinTheirIf_data() {
        QTest::addColumn<int>("n");
        QTest::addColumn<quint64>("outputs");
        QTest::newRow("if") << 1 << quint64(0b10001);
        QTest::newRow("else if") << 2 << quint64(0b01010);
        QTest::newRow("else") << 3 << quint64(0b01100);
    }
    void branchesAreTakenWhereTheyStandBesideOrWithinTheirIf() {
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

    void whatCannotBeToldIsRefusedAsAWhole_data() {
        QTest::addColumn<QString>("parts");
        const QString good = line("sync()");
        QTest::newRow("no main program") << QString("<InitVariablesNode/>");
        QTest::newRow("unknown node") << mainProgram(good + "<Palletizing/>");
        QTest::newRow("subprogram") << mainProgram(good) + withChildren("SubProgram name=\"s\"", good);
        QTest::newRow("variable from nowhere")
            << mainProgram(assign("reference=\"../../../../../../nothing/variable\"", "1"));
        QTest::newRow("if without condition") << mainProgram(branch("If", {}, good));
        QTest::newRow("loop over nothing") << mainProgram(withChildren("Loop type=\"While\"", good));
        QTest::newRow("variable waypoint in another frame")
            << mainProgram(withChildren("Move motionType=\"MoveL\" speed=\"1\" acceleration=\"1\"",
                                        "<Waypoint type=\"Variable\"><variable name=\"w\"/></Waypoint>",
                                        "<feature referencedName=\"table\"/>"));
    }
    void whatCannotBeToldIsRefusedAsAWhole() {
        QFETCH(QString, parts);
        Loaded cell(program(parts));
        QCOMPARE(cell.reply, QByteArray("Error while loading program: p.urp\n"));
    }
};

QTEST_GUILESS_MAIN(TestProgramFiles)
#include "tst_program_files.moc"
