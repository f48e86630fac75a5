// SPDX-License-Identifier: MIT
//
// The commands `tiller-cli run` and `tiller-cli script` as users type them, in simulation and on the
// simulated controller through its real ports.

#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "program_samples.h"
#include "robot/script/script_client.h"
#include "robot/simulator/simulator.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::program;

namespace {

constexpr int kProcessTimeoutMs = 60'000;

QString ownAddress() {
    const auto pid = static_cast<unsigned>(QCoreApplication::applicationPid());
    return QStringLiteral("127.%1.%2.23").arg(100 + pid % 100).arg((pid / 100) % 250);
}

struct Answer {
    int code = -1;
    QString out;
    QString err;
};

Answer finished(QProcess& process) {
    if (!process.waitForFinished(kProcessTimeoutMs)) {
        process.kill();
        process.waitForFinished();
    }
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2,
            QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

Answer run(const QStringList& arguments) {
    QProcess process;
    process.start(QStringLiteral(TILLER_CLI), arguments);
    return finished(process);
}

}  // namespace

class TestCliProgram : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        project_ = sampleProject();
        project_.programs.append(trayProgram(project_));
        project_.programs.append(makeProgram("wrong", {step("wait"), step("moveL")}));
        project_.programs.append(makeProgram(
            "to and fro", {step("loop", {{"times", 20}},
                                {step("moveL", {{"waypoint", waypointId(project_, "pick")}}),
                                 step("moveL", {{"waypoint", waypointId(project_, "place")}})})}));
        project_.programs.append(makeProgram(
            "short",
            {step("moveJ", {{"waypoint", waypointId(project_, "pick")}}), step("setOutput", {{"output", 2}}),
             step("moveL", {{"waypoint", waypointId(project_, "place")}})}));
        const auto assign = [](const char* variable, const char* type, const char* value) {
            return step("assign", {{"variable", variable}, {"type", type}, {"value", value}});
        };
        project_.programs.append(makeProgram(
            "counting",
            {assign("count", "whole", "1"), assign("fast", "flag", "False"), assign("label", "text", "\"a\""),
             step("wait", {{"time", 0.3}}),
             step("if", {{"condition", "count == 7 and fast"}}, {step("setOutput", {{"output", 3}})}),
             step("else", {}, {step("moveJ", {{"waypoint", waypointId(project_, "place")}})}),
             assign("count", "whole", "count + 1"), step("wait", {{"time", 0.3}}), step("comment")}));
        QVERIFY(project::saveProject(path(), project_).ok());
        simulator_ = std::make_unique<simulator::Simulator>(
            simulator::SimulatorOptions{.listenAddress = address_,
                                        .poweredOn = true,
                                        .startJoints = project_.waypoints.at(0).joints,
                                        .fastTransitions = true});
        QVERIFY(simulator_->start().ok());
    }

    void simulatesInVirtualTime() {
        const Answer answer =
            run({"run", path(), "--simulate", "--program", "Fill the tray", "--input", "DI0=on", "--json"});
        QVERIFY2(answer.code == 0, qPrintable(answer.out + answer.err));
        const QJsonObject result = QJsonDocument::fromJson(answer.out.toUtf8()).object();
        QVERIFY(result["completed"].toBool() && result["simulated"].toBool());
        QVERIFY(result["duration"].toDouble() > 20);
        QVERIFY(result["findings"].toArray().isEmpty());
        const QJsonArray steps = result["steps"].toArray();
        QCOMPARE(steps.size(), 18);
        QCOMPARE(steps[5]["count"].toInt(), 12);
        const Answer again =
            run({"run", path(), "--simulate", "--program", "Fill the tray", "--input", "DI0=on", "--json"});
        QCOMPARE(again.out, answer.out);
    }

    void recoverabilityIsPrintedForEachStep() {
        const Answer answer =
            run({"run", path(), "--simulate", "--program", "short", "--recoverability", "--json"});
        QVERIFY2(answer.code == 0, qPrintable(answer.out + answer.err));
        const QJsonObject result = QJsonDocument::fromJson(answer.out.toUtf8()).object();
        QVERIFY(result["completed"].toBool() && result["simulated"].toBool());
        const QJsonArray steps = result["steps"].toArray();
        QCOMPARE(steps.size(), 3);
        const QJsonObject last = steps[2].toObject();
        QCOMPARE(last["from"].toInt(), 3);
        QCOMPARE(last["stops"]["operatorStop"]["mark"].toString(), QString("moveBack"));
        QCOMPARE(last["stops"]["powerLoss"]["mark"].toString(), QString("unsafe"));
        QVERIFY(last["stops"]["powerLoss"]["reason"].toString().contains("DO 2"));
        QVERIFY(result["points"].toArray().size() > 5);
        const Answer text = run({"run", path(), "--simulate", "--program", "short", "--recoverability"});
        QVERIFY2(text.out.startsWith(
                     "simulated: the program can continue after a stop in 3 of the 3 steps that were "
                     "checked; the program has 3 steps"),
                 qPrintable(text.out));
    }

    // Recoverability is not checked for steps of a branch that is not taken, disabled steps, comments and
    // parallel watches.
    void stepsWithoutACheckAreCountedAndNamed() {
        project::ProgramStep disabled = step("wait");
        disabled.disabled = true;
        project::Project project = project_;
        project.programs.append(makeProgram(
            "branches", {step("comment", {{"text", "a remark"}}), disabled,
                         step("watch", {{"condition", "DI5"}}, {step("setOutput", {{"output", 1}})}),
                         step("if", {{"condition", "DI2"}}, {step("wait", {{"time", 0.1}})}),
                         step("else", {}, {step("folder", {}, {step("wait", {{"time", 0.1}})})}),
                         step("wait", {{"time", 0.1}})}));
        const QString file = folder_.filePath("branches.tiller");
        QVERIFY(project::saveProject(file, project).ok());
        const QStringList arguments{"run", file, "--simulate", "--program", "branches", "--recoverability"};
        const Answer text = run(arguments);
        QVERIFY2(text.code == 0, qPrintable(text.out + text.err));
        QVERIFY2(text.out.contains("of the 6 steps that were checked; the program has 10 steps"),
                 qPrintable(text.out));
        QVERIFY2(text.out.contains("   6  Wait                      not checked: the simulated program did "
                                   "not reach this step, or ended in it"),
                 qPrintable(text.out));
        const QJsonObject result =
            QJsonDocument::fromJson(run(arguments + QStringList{"--json"}).out.toUtf8()).object();
        QCOMPARE(result["total"].toInt(), 10);
        QCOMPARE(result["checked"].toInt(), 6);
        QStringList reasons;
        const QJsonArray unchecked = result["notChecked"].toArray();
        for (const QJsonValue& each : unchecked) {
            reasons << QStringLiteral("%1 %2").arg(each["number"].toInt()).arg(each["reason"].toString());
        }
        QCOMPARE(reasons, (QStringList{"1 comments have no effect", "2 the step is disabled",
                                       "4 runs in parallel with other steps",
                                       "6 the simulated program did not reach this step, or ended in it"}));
    }

    void variablesAreSetAndPrinted_data() {
        QTest::addColumn<QStringList>("target");
        QTest::newRow("simulated") << QStringList{"--simulate"};
        QTest::newRow("on a robot") << QStringList{"--robot", address_};
    }
    void variablesAreSetAndPrinted() {
        QFETCH(QStringList, target);
        const QStringList arguments = QStringList{"run",       path(),  "--program",   "counting",   "--set",
                                                  "count=7@4", "--set", "fast=true@4", "--variables"} +
                                      target;
        const JointPositions before = simulator_->truth().q;
        const Answer text = run(arguments);
        QVERIFY2(text.code == 0, qPrintable(text.out + text.err));
        QStringList expected{"count = 8", "fast = True", "label = \"a\""};
        if (target.size() > 1) {
            expected += {"count = 7", "step 4 (Wait)"};
            QVERIFY((simulator_->truth().digitalOutputs & 8U) != 0);
        }
        for (const QString& line : expected) {
            QVERIFY2(text.out.contains(line + '\n'), qPrintable(text.out));
        }
        const Answer json = run(arguments + QStringList{"--json"});
        QVERIFY2(json.code == 0, qPrintable(json.out + json.err));
        const QJsonObject result = QJsonDocument::fromJson(json.out.toUtf8()).object();
        QCOMPARE(result["simulated"].toBool(), target.size() == 1);
        QVERIFY(result["completed"].toBool());
        QCOMPARE(result["steps"].toArray().size(), 11);
        QCOMPARE(result["steps"][7]["count"].toInt(), 0);  // the move of the other branch
        QCOMPARE(result["variables"].toObject(), (QJsonObject{{"count", 8}, {"fast", true}, {"label", "a"}}));
        QVERIFY((simulator_->truth().q.values - before.values).cwiseAbs().maxCoeff() < 1e-3);
    }

    // The simulated run before the start uses the same values.
    void aValueThatCausesACollisionIsRefused() {
        project::Project project = project_;
        project::Waypoint folded = project.waypoints.at(0);
        folded.id = QUuid::createUuid();
        folded.name = "folded";
        folded.joints.values[2] = -2.9;
        folded.pose = kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, folded.joints);
        folded.priority = project::TargetKind::Joints;
        project.waypoints.append(folded);
        project.programs.append(makeProgram(
            "risky",
            {step("assign", {{"variable", "n"}, {"type", "number"}, {"value", "0.5"}}),
             step("if", {{"condition", "n > 1"}}, {step("moveJ", {{"waypoint", idText(folded.id)}})})}));
        const QString file = folder_.filePath("risky.tiller");
        QVERIFY(project::saveProject(file, project).ok());
        const QStringList arguments{"run", file, "--program", "risky", "--robot", address_};
        const JointPositions before = simulator_->truth().q;
        QCOMPARE(run(arguments).code, 0);
        const Answer refused = run(arguments + QStringList{"--set", "n=2@2"});
        QCOMPARE(refused.code, 1);
        QVERIFY2(refused.err.contains("too close to itself"), qPrintable(refused.err));
        QVERIFY((simulator_->truth().q.values - before.values).cwiseAbs().maxCoeff() < 1e-3);
    }

    void aStoppedRunIsReportedAsJson() {
        QProcess process;
        process.start(QStringLiteral(TILLER_CLI),
                      {"run", path(), "--robot", address_, "--program", "to and fro", "--json"});
        QTRY_VERIFY_WITH_TIMEOUT(simulator_->truth().tcpSpeed.linear.norm() > 0.1, kProcessTimeoutMs);
        process.terminate();
        const Answer answer = finished(process);
        QCOMPARE(answer.code, 1);
        const QJsonObject result = QJsonDocument::fromJson(answer.out.toUtf8()).object();
        QVERIFY2(result.contains("completed") && !result["completed"].toBool(), qPrintable(answer.out));
        QVERIFY(result["error"].toString().contains("Stopped") && result["lastStep"].toInt() > 1);
    }

    void findingsGiveAFailureExitCode() {
        const Answer answer =
            run({"run", path(), "--simulate", "--program", "to and fro", "--time-limit", "5"});
        QCOMPARE(answer.code, 1);
        QVERIFY2(answer.out.contains("did not end within 5 s"), qPrintable(answer.out));
    }

    void programsWithErrorsAreRefused() {
        for (const QStringList& target : {QStringList{"--simulate"}, QStringList{"--robot", address_}}) {
            const JointPositions before = simulator_->truth().q;
            const Answer answer = run(QStringList{"run", path(), "--program", "wrong"} + target);
            QCOMPARE(answer.code, 1);
            QVERIFY2(answer.err.contains("step 2 (MoveL): Set a waypoint"), qPrintable(answer.err));
            QVERIFY((simulator_->truth().q.values - before.values).cwiseAbs().maxCoeff() < 1e-3);
        }
    }

    void runsOnTheRobot() {
        const Answer answer = run({"run", path(), "--robot", address_, "--program", "short"});
        QVERIFY2(answer.code == 0, qPrintable(answer.out + answer.err));
        QVERIFY2(answer.out.contains("step 1 (MoveJ)") && answer.out.contains("step 3 (MoveL)"),
                 qPrintable(answer.out));
        const Pose place = *project::poseInBase(project_.waypoints.at(2), project_.frames);
        QVERIFY((simulator_->truth().tcpPose.position - place.position).norm() < 1e-3);
        QVERIFY((simulator_->truth().digitalOutputs & 4U) != 0);
    }

    // The check begins at the position at which the command stops the arm.
    void runsAfterTheMotionOfAnotherClient() {
        script::ScriptClient other(simulator_->listenAddress(), simulator_->ports().primary);
        QVERIFY(other.connect(test::testTimeout()).ok());
        QVERIFY(
            other.send("movej([-1.6, -1.7, -2.2, -0.8, 1.6, 3], a=2, v=0.5)\n", test::testTimeout()).ok());
        QTRY_VERIFY_WITH_TIMEOUT(simulator_->truth().qd.values.cwiseAbs().maxCoeff() > 0.4,
                                 kProcessTimeoutMs);
        const Answer answer = run({"run", path(), "--robot", address_, "--program", "short"});
        QVERIFY2(answer.code == 0, qPrintable(answer.out + answer.err));
    }

    void aStopOnTheRobotIsAFailure() {
        QProcess process;
        process.start(QStringLiteral(TILLER_CLI),
                      {"run", path(), "--robot", address_, "--program", "to and fro"});
        QTRY_VERIFY_WITH_TIMEOUT(simulator_->truth().tcpSpeed.linear.norm() > 0.1, kProcessTimeoutMs);
        script::ScriptClient pendant(simulator_->listenAddress(), simulator_->ports().primary);
        QVERIFY(pendant.connect(test::testTimeout()).ok());
        QVERIFY(pendant.send("stop program\n", test::testTimeout()).ok());
        const Answer answer = finished(process);
        QCOMPARE(answer.code, 1);
        QVERIFY2(answer.err.contains("ended on the robot"), qPrintable(answer.err));
    }

    // A killed process cannot stop the arm. The script ends the motion because of the missing heartbeat.
    void armStopsWithTheProcess_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("interrupted") << SIGINT;
        QTest::newRow("terminated") << SIGTERM;
        QTest::newRow("killed") << SIGKILL;
    }
    void armStopsWithTheProcess() {
        QFETCH(int, signal);
        QProcess process;
        process.start(QStringLiteral(TILLER_CLI),
                      {"run", path(), "--robot", address_, "--program", "to and fro"});
        QTRY_VERIFY_WITH_TIMEOUT(simulator_->truth().tcpSpeed.linear.norm() > 0.1, kProcessTimeoutMs);
        ::kill(static_cast<pid_t>(process.processId()), signal);
        const double killed = simulator_->truth().timestamp;
        double rest = 0;  // robot time at which the arm has stopped
        QTRY_VERIFY_WITH_TIMEOUT((rest = simulator_->truth().timestamp,
                                  simulator_->truth().qd.values.cwiseAbs().maxCoeff() < 1e-3),
                                 10'000);
        QVERIFY2(rest - killed < 0.25, qPrintable(QString::number(rest - killed)));
        QCOMPARE(finished(process).code == 0, false);
        QTest::qWait(300);
        QVERIFY(simulator_->truth().qd.values.cwiseAbs().maxCoeff() < 1e-3);
        QVERIFY(simulator_->truth().runtimeState == RuntimeState::Stopped);
    }

    void programsOfOtherModelsAreRefused() {
        project::Project other = project_;
        other.robot = RobotModelId::UR10e;
        const QString file = folder_.filePath("other.tiller");
        QVERIFY(project::saveProject(file, other).ok());
        const Answer answer = run({"run", file, "--robot", address_, "--program", "short"});
        QCOMPARE(answer.code, 1);
        QVERIFY2(answer.err.contains("the robot is a different model"), qPrintable(answer.err));
    }

    void writesTheScript() {
        const QString file = folder_.filePath("short.script");
        QCOMPARE(run({"script", path(), "--program", "short", "--out", file}).code, 0);
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const Answer printed = run({"script", path(), "--program", "short"});
        QCOMPARE(printed.code, 0);
        QCOMPARE(QString::fromUtf8(written.readAll()), printed.out);
        QVERIFY(printed.out.startsWith("def program_short():\n"));
        const Answer later = run({"script", path(), "--program", "short", "--from", "3"});
        QVERIFY(!later.out.contains("movej"));
        QVERIFY(later.out.contains("movel"));
    }

    void wrongArgumentsAreReported_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("text");
        const QString file = path();
        QTest::newRow("no file") << QStringList{"run", "--simulate"} << 2 << "one project file";
        QTest::newRow("nowhere") << QStringList{"run", file} << 2 << "--simulate or --robot";
        QTest::newRow("address") << QStringList{"run", file, "--robot", "a b"} << 2 << "not an address";
        QTest::newRow("input") << QStringList{"run", file, "--simulate", "--input", "TI2=on"} << 2
                               << "--input must have";
        QTest::newRow("recoverability")
            << QStringList{"run", file, "--robot", "127.0.0.1", "--recoverability"} << 2
            << "--recoverability requires --simulate";
        for (const char* set : {"count", "count=3", "count=@3", "3=3@3", "count=3@x"}) {
            QTest::newRow(set) << QStringList{"run", file, "--simulate", "--set", set} << 2
                               << "--set must have the form";
        }
        for (const auto& [set, text] :
             {std::pair("none=3@4", "step 4 (Wait): The program has no variable “none”"),
              std::pair("count=2.5@4", "not a whole number"), std::pair("label=b@4", "Only numbers"),
              std::pair("fast=1@4", "not True or False"),
              std::pair("count=3@11", "step 11 (Comment): The program cannot pause"),
              std::pair("count=3@12", "smaller step number with --set")}) {
            QTest::newRow(set) << QStringList{"run",      file,    "--simulate", "--program",
                                              "counting", "--set", set}
                               << 1 << text;
        }
        QTest::newRow("set and recoverability")
            << QStringList{"run", file, "--simulate", "--recoverability", "--set", "count=3@4"} << 2
            << "--from or --set";
        QTest::newRow("no name") << QStringList{"run", file, "--simulate"} << 1
                                 << "--program NAME is missing";
        QTest::newRow("name") << QStringList{"script", file, "--program", "x"} << 1 << "no program 'x'";
        QTest::newRow("step") << QStringList{"script", file, "--program", "short", "--from", "9"} << 1
                              << "has 3 steps";
        QTest::newRow("not a step") << QStringList{"script", file, "--program", "short", "--from", "x"} << 2
                                    << "--from must be";
        QTest::newRow("inside") << QStringList{"run",           file,     "--simulate", "--program",
                                               "Fill the tray", "--from", "6"}
                                << 1 << "top-level step";
        QTest::newRow("missing") << QStringList{"run", folder_.filePath("none.tiller"), "--simulate"} << 1
                                 << "none.tiller";
        QTest::newRow("silent robot")
            << QStringList{"run", file, "--robot", "127.0.0.1", "--port-offset", "9", "--program", "short"}
            << 1 << "ConnectionRefused";
    }
    void wrongArgumentsAreReported() {
        QFETCH(QStringList, arguments);
        QFETCH(int, code);
        QFETCH(QString, text);
        const Answer answer = run(arguments);
        QVERIFY2(answer.code == code, qPrintable(answer.out + answer.err));
        QVERIFY2(answer.err.contains(text), qPrintable(answer.err));
    }

    void helpIsPrinted() {
        QVERIFY(run({"run", "--help"}).out.contains("--simulate"));
        QVERIFY(run({"script", "--help"}).out.contains("--out"));
    }

    void importAddsAProgramAndItsWaypoints() {
        const QString project = copyOfProject("import.tiller");
        const QString file = written("two moves.script",
                                     "def two():\n  movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=1, v=1)\n"
                                     "  zero_ftsensor()\n  set_standard_digital_out(2, True)\nend\n");
        const Answer answer = run({"import", file, "--project", project, "--json"});
        QVERIFY2(answer.code == 0, qPrintable(answer.out + answer.err));
        const QJsonObject report = QJsonDocument::fromJson(answer.out.toUtf8()).object();
        QCOMPARE(report["program"].toString(), "two moves");
        QCOMPARE(report["steps"].toInt(), 2);
        QCOMPARE(report["texts"].toInt(), 1);
        QCOMPARE(report["rows"].toArray()[1].toObject()["line"].toInt(), 3);
        const auto read = project::loadProject(project);
        QVERIFY(read.ok());
        QCOMPARE(read->waypoints.size(), project_.waypoints.size() + 1);
        QCOMPARE(read->programs.size(), project_.programs.size() + 1);
        const Answer text = run({"import", file, "--project", project, "--program", "again"});
        QVERIFY2(text.code == 0 && text.out.contains("   2  movej(") && text.out.contains(": MoveJ\n"),
                 qPrintable(text.out + text.err));
        const Answer simulated = run({"run", project, "--program", "again", "--simulate"});
        QVERIFY2(simulated.code == 0, qPrintable(simulated.out + simulated.err));
    }

    void failedImportLeavesTheProjectUnchanged_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("message");
        QTest::newRow("existing name")
            << "short.script" << QByteArray("sleep(1)\n") << "already has a program 'short'";
        QTest::newRow("damaged script") << "a.script" << QByteArray("def a():\n  while True:\n")
                                        << "a.script: line 4: the block that begins on line 2";
        QTest::newRow("damaged program") << "a.urp" << QByteArray("<URProgram") << "a.urp: ";
        QTest::newRow("empty program")
            << "b.urpx" << QByteArray("{}") << "b.urpx: the program contains no URScript";
    }
    void failedImportLeavesTheProjectUnchanged() {
        QFETCH(QString, file);
        QFETCH(QByteArray, content);
        QFETCH(QString, message);
        const QString project = copyOfProject("unchanged.tiller");
        const QByteArray before = contentOf(project);
        const Answer answer = run({"import", written(file, content), "--project", project});
        QCOMPARE(answer.code, 1);
        QVERIFY2(answer.err.contains(message) && answer.out.isEmpty(), qPrintable(answer.out + answer.err));
        QCOMPARE(contentOf(project), before);
    }

    void importRequiresAFileAndAProject() {
        QCOMPARE(run({"import"}).code, 2);
        QCOMPARE(run({"import", "a.script"}).code, 2);
        QCOMPARE(run({"import", "missing.script", "--project", path()}).code, 1);
        QCOMPARE(run({"import", written("c.script", "sleep(1)\n"), "--project", "missing.tiller"}).code, 1);
    }

private:
    /// Copies the project file. Returns the path of the copy; empty if copying failed.
    QString copyOfProject(const QString& name) const {
        const QString copy = folder_.filePath(name);
        QFile::remove(copy);
        return QFile::copy(path(), copy) ? copy : QString();
    }
    QString written(const QString& name, const QByteArray& content) const {
        QFile file(folder_.filePath(name));
        return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() ? file.fileName()
                                                                                        : QString();
    }
    static QByteArray contentOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QString path() const { return folder_.filePath("cell.tiller"); }
    QTemporaryDir folder_;
    project::Project project_;
    const QString address_ = ownAddress();
    std::unique_ptr<simulator::Simulator> simulator_;
};

QTEST_GUILESS_MAIN(TestCliProgram)
#include "tst_cli_program.moc"
