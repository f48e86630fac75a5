// SPDX-License-Identifier: MIT

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/integration/simulator/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

simulator::ControllerOptions poweredOff() {
    auto options = VirtualRobot::options();
    options.poweredOn = false;
    return options;
}

/// As the pendant saves its files: qCompress() gives the same deflated bytes in another frame.
QByteArray gzipped(const QByteArray& content) {
    quint32 sum = ~quint32(0);
    for (const char c : content) {
        sum ^= static_cast<unsigned char>(c);
        for (int i = 0; i < 8; ++i) {
            sum = (sum >> 1) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
        }
    }
    const QByteArray zlib = qCompress(content);
    QByteArray gzip("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10);
    gzip += zlib.mid(6, zlib.size() - 10);
    for (const quint32 word : {~sum, quint32(content.size())}) {
        for (int i = 0; i < 4; ++i) {
            gzip += static_cast<char>((word >> (8 * i)) & 0xFF);
        }
    }
    return gzip;
}

/// A robot ready to play wait_program.urp, which never ends.
struct Played {
    static simulator::ControllerOptions options(const QString& folder) {
        QFile file(folder + "/wait_program.urp");
        if (file.open(QIODevice::WriteOnly)) {
            file.write("def wait_program():\n  while True:\n    sleep(1)\n  end\nend\n");
        }
        auto options = VirtualRobot::options();
        options.programsFolder = folder;
        return options;
    }
    Played() { dashboard.ask("load wait_program.urp"); }

    QTemporaryDir folder;
    VirtualRobot robot{options(folder.path())};
    RawDashboard dashboard{robot.host(), robot.controller.ports().dashboard};
};

}  // namespace

class TestDashboardService : public QObject {
    Q_OBJECT

    static bool reaches(VirtualRobot& robot, RawDashboard& dashboard, const QByteArray& robotMode) {
        return robot.stepUntil([&] { return dashboard.ask("robotmode") == "Robotmode: " + robotMode + '\n'; },
                               5);
    }

private Q_SLOTS:
    void repliesAreExact_data() {
        QTest::addColumn<QByteArray>("command");
        QTest::addColumn<QByteArray>("reply");
        const auto row = [](const char* command, const char* reply) {
            QTest::newRow(command) << QByteArray(command) << QByteArray(reply);
        };
        row("robotmode", "Robotmode: RUNNING");
        row("RobotMode", "Robotmode: RUNNING");
        row("safetymode", "Safetymode: NORMAL");
        row("safetystatus", "Safetystatus: NORMAL");
        row("running", "Program running: false");
        row("programState", "STOPPED <unnamed>");
        row("get loaded program", "No program loaded");
        row("load missing.urp", "File not found: missing.urp");
        row("load installation x.installation", "File not found: x.installation");
        row("play", "Failed to execute: play");
        row("pause", "Failed to execute: pause");
        row("stop", "Stopped");
        row("power on", "Powering on");
        row("brake release", "Brake releasing");
        row("unlock protective stop", "Protective stop releasing");
        row("close safety popup", "closing safety popup");
        row("popup hello there", "showing popup");
        row("close popup", "closing popup");
        row("addToLog something", "Added log message");
        row("addToLog", "No log message to add");
        row("saveLog", "Log saved to disk");
        row("PolyscopeVersion", "URSoftware 5.22.1.1214193 (Mar 12 2025)");
        row("version", "5.22.1.1214193");
        row("get robot model", "UR5");
        row("is in remote control", "true");
        row("set operational mode automatic", "Operational mode AUTOMATIC is set");
        row("set operational mode x", "Failed setting operational mode: x");
        row("get operational mode", "NONE");
        row("setUserRole programmer", "could not understand: 'setUserRole programmer'");
        row("make coffee", "could not understand: 'make coffee'");
        row("", "could not understand: ''");
        row("  robotmode \r", "Robotmode: RUNNING");
    }
    void repliesAreExact() {
        QFETCH(QByteArray, command);
        QFETCH(QByteArray, reply);
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.greeting, QByteArray("Connected: Universal Robots Dashboard Server\n"));
        QCOMPARE(dashboard.ask(command), reply + '\n');
    }

    void cb3KnowsUserRolesAndNoRemoteControl() {
        auto options = VirtualRobot::options();
        options.model = RobotModelId::UR5;
        options.software = {3, 15, 8, 106339};
        VirtualRobot robot(options);
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.ask("setUserRole operator"), QByteArray("Setting user role: operator\n"));
        QCOMPARE(dashboard.ask("getUserRole"), QByteArray("OPERATOR\n"));
        QVERIFY(dashboard.ask("is in remote control").startsWith("could not understand"));
        QCOMPARE(dashboard.ask("PolyscopeVersion"), QByteArray("URSoftware 3.15.8.106339 (Jun 20 2022)\n"));
    }

    void thePowerCycleOfTheClientLibrarysTests() {
        VirtualRobot robot(poweredOff());
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.ask("power off"), QByteArray("Powering off\n"));
        QVERIFY(reaches(robot, dashboard, "POWER_OFF"));
        QCOMPARE(dashboard.ask("power on"), QByteArray("Powering on\n"));
        QVERIFY(reaches(robot, dashboard, "POWER_ON"));
        QVERIFY(reaches(robot, dashboard, "BOOTING"));
        QVERIFY(reaches(robot, dashboard, "IDLE"));
        QCOMPARE(dashboard.ask("brake release"), QByteArray("Brake releasing\n"));
        QVERIFY(reaches(robot, dashboard, "RUNNING"));
        QCOMPARE(dashboard.ask("power on"), QByteArray("Powering on\n"));
        robot.controller.stepSeconds(1);
        QVERIFY(reaches(robot, dashboard, "RUNNING"));
        QCOMPARE(dashboard.ask("power off"), QByteArray("Powering off\n"));
        QVERIFY(reaches(robot, dashboard, "POWER_OFF"));
        QCOMPARE(dashboard.ask("brake release"), QByteArray("Brake releasing\n"));
        QVERIFY(reaches(robot, dashboard, "RUNNING"));
    }

    void aProtectiveStopIsUnlockedAfterFiveSecondsAndNotBefore() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        RawPrimary primary = robot.primary();
        primary.send("def p():\n  protective_stop()\nend\n");
        robot.controller.drainSockets();
        QVERIFY(robot.stepUntil(
            [&] { return dashboard.ask("safetymode") == "Safetymode: PROTECTIVE_STOP\n"; }, 1));
        QCOMPARE(dashboard.ask("safetystatus"), QByteArray("Safetystatus: PROTECTIVE_STOP\n"));
        QCOMPARE(dashboard.ask("robotmode"), QByteArray("Robotmode: RUNNING\n"));
        const QByteArray refusal =
            "Cannot unlock protective stop until 5s after occurrence. Always inspect cause of protective "
            "stop "
            "before unlocking\n";
        QCOMPARE(dashboard.ask("unlock protective stop"), refusal);
        robot.controller.stepSeconds(4.9);
        QCOMPARE(dashboard.ask("unlock protective stop"), refusal);
        QCOMPARE(dashboard.ask("safetymode"), QByteArray("Safetymode: PROTECTIVE_STOP\n"));
        robot.controller.stepSeconds(0.1);
        QCOMPARE(dashboard.ask("unlock protective stop"), QByteArray("Protective stop releasing\n"));
        QVERIFY(robot.stepUntil([&] { return dashboard.ask("safetymode") == "Safetymode: NORMAL\n"; }, 1));
        QCOMPARE(dashboard.ask("robotmode"), QByteArray("Robotmode: RUNNING\n"));
    }

    void aProgramFileIsLoadedPlayedPausedAndStopped() {
        QTemporaryDir folder;
        QFile file(folder.filePath("wait_program.urp"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("def wait_program():\n  while True:\n    sleep(1)\n  end\nend\n");
        file.close();
        auto options = poweredOff();
        options.programsFolder = folder.path();
        VirtualRobot robot(options);
        RawDashboard dashboard = robot.dashboard();
        const auto state = [&](const QByteArray& wanted) {
            return robot.stepUntil([&] { return dashboard.ask("programState") == wanted; }, 2);
        };
        QCOMPARE(dashboard.ask("load wait_program.urp"), QByteArray("Loading program: wait_program.urp\n"));
        QVERIFY(state("STOPPED wait_program.urp\n"));
        QCOMPARE(dashboard.ask("get loaded program"),
                 "Loaded program: " + folder.filePath("wait_program.urp").toUtf8() + '\n');
        QCOMPARE(dashboard.ask("isProgramSaved"), QByteArray("true wait_program.urp\n"));
        QCOMPARE(dashboard.ask("play"), QByteArray("Failed to execute: play\n"));  // no power yet
        dashboard.ask("brake release");
        QVERIFY(reaches(robot, dashboard, "RUNNING"));
        QCOMPARE(dashboard.ask("play"), QByteArray("Starting program\n"));
        QVERIFY(state("PLAYING wait_program.urp\n"));
        QCOMPARE(dashboard.ask("running"), QByteArray("Program running: true\n"));
        QCOMPARE(dashboard.ask("pause"), QByteArray("Pausing program\n"));
        QVERIFY(state("PAUSED wait_program.urp\n"));
        QCOMPARE(dashboard.ask("play"), QByteArray("Starting program\n"));
        QVERIFY(state("PLAYING wait_program.urp\n"));
        QCOMPARE(dashboard.ask("stop"), QByteArray("Stopped\n"));
        QVERIFY(state("STOPPED wait_program.urp\n"));
        QCOMPARE(dashboard.ask("running"), QByteArray("Program running: false\n"));
    }

    void aPopupThatDoesNotBlockDoesNotRefusePlay() {
        Played cell;
        QCOMPARE(cell.dashboard.ask("popup hello"), QByteArray("showing popup\n"));
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        cell.robot.controller.step(2);
        QCOMPARE(cell.dashboard.ask("programState"), QByteArray("PLAYING wait_program.urp\n"));
        cell.dashboard.ask("stop");
        QVERIFY(cell.robot.stepUntil([&] { return cell.robot.programState() == RuntimeState::Stopped; }, 2));
        QVERIFY(cell.robot.controller.inject("popup wait for me").ok());  // one that blocks does
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Failed to execute: play\n"));
        cell.dashboard.ask("close popup");
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
    }

    void playFollowsStopAndLoadAtOnce() {
        Played cell;
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        cell.robot.controller.step(5);
        QCOMPARE(cell.dashboard.ask("stop"), QByteArray("Stopped\n"));
        cell.robot.controller.step(1);
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        cell.robot.controller.step(50);
        QCOMPARE(cell.dashboard.ask("programState"), QByteArray("PLAYING wait_program.urp\n"));
        QCOMPARE(cell.dashboard.ask("load wait_program.urp"),
                 QByteArray("Loading program: wait_program.urp\n"));
        QCOMPARE(cell.dashboard.ask("programState"), QByteArray("STOPPED wait_program.urp\n"));
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        cell.robot.controller.step(50);
        QCOMPARE(cell.dashboard.ask("programState"), QByteArray("PLAYING wait_program.urp\n"));
    }

    void stopAndPlayInOneSegmentAreBothObeyed() {
        Played cell;
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        cell.robot.controller.step(5);
        cell.dashboard.send("stop\nplay\n");
        QCOMPARE(cell.dashboard.line(), QByteArray("Stopped\n"));
        QCOMPARE(cell.dashboard.line(), QByteArray("Starting program\n"));
        cell.robot.controller.step(50);
        QCOMPARE(cell.dashboard.ask("programState"), QByteArray("PLAYING wait_program.urp\n"));
    }

    void commandsExistFromTheirVersionOn_data() {
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::addColumn<QByteArray>("command");
        QTest::addColumn<bool>("exists");
        const auto row = [](int major, int minor, const char* command, bool exists) {
            QTest::addRow("%s in %d.%d", command, major, minor)
                << major << minor << QByteArray(command) << exists;
        };
        row(5, 3, "safetystatus", false);
        row(5, 4, "safetystatus", true);
        row(3, 10, "safetystatus", false);
        row(3, 11, "safetystatus", true);
        row(5, 5, "get serial number", false);
        row(5, 6, "get serial number", true);
        row(3, 12, "get robot model", true);
        row(3, 11, "get robot model", false);
        row(5, 5, "is in remote control", false);
        row(5, 6, "is in remote control", true);
        row(3, 15, "is in remote control", false);
        row(5, 0, "set operational mode manual", true);
        row(3, 15, "set operational mode manual", false);
        row(5, 5, "get operational mode", false);
        row(5, 7, "generate flight report", false);
        row(5, 8, "generate flight report", true);
        row(3, 13, "generate flight report", true);
        row(5, 8, "saveLog", true);
        row(3, 12, "saveLog", false);
        row(3, 6, "restart safety", false);
        row(3, 7, "restart safety", true);
        row(5, 0, "restart safety", false);
        row(5, 1, "restart safety", true);
        row(3, 15, "getUserRole", true);
        row(5, 22, "getUserRole", false);
        row(3, 15, "version", false);
        row(5, 0, "version", true);
    }
    void commandsExistFromTheirVersionOn() {
        QFETCH(int, major);
        QFETCH(int, minor);
        QFETCH(QByteArray, command);
        QFETCH(bool, exists);
        auto options = VirtualRobot::options();
        options.software = {quint32(major), quint32(minor), 0, 0};
        options.model = major == 3 ? RobotModelId::UR5 : RobotModelId::UR5e;
        VirtualRobot robot(options);
        const QByteArray reply = robot.dashboard().ask(command);
        QVERIFY2(reply.startsWith("could not understand") != exists, reply);
    }

    void aProgramOfThePendantIsReadFromItsFile() {
        QTemporaryDir folder;
        const auto write = [&folder](const char* name, const QByteArray& content) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(content);
        };
        const QByteArray head =
            "<?xml version=\"1.0\"?><URProgram name=\"p\" "
            "installation=\"default\"><children><MainProgram><children>";
        const QByteArray tail = "</children></MainProgram></children></URProgram>";
        const QByteArray nodes =
            "<Comment comment=\"first\"/><Script type=\"Line\"><expression><ExpressionChar character=\"x\"/>"
            "<ExpressionChar character=\"=\"/><ExpressionChar character=\"1\"/></expression></Script>"
            "<Folder name=\"f\"><children><Script type=\"File\"><cachedContents>set_digital_out(2, "
            "True)\n</cachedContents>"
            "</Script></children></Folder><Loop type=\"Counting\" count=\"3\"><children><Wait type=\"Sleep\">"
            "<waitTime>0.1</waitTime></Wait></children></Loop><Move motionType=\"MoveJ\" speed=\"1\" "
            "acceleration=\"2\">"
            "<children><Waypoint type=\"Fixed\" name=\"w\"><position><JointAngles angles=\"-1.5, -1.7, -2.2, "
            "-0.8, 1.6, 0\"/>"
            "</position></Waypoint></children></Move>";
        write("nodes.urp", gzipped(head + nodes + tail));
        write("unknown.urp", gzipped(head + "<Palletizing/>" + tail));
        write("broken.urp", gzipped(head + nodes).chopped(20));
        write("beside.urp", gzipped(head + "<Palletizing/>" + tail));
        write("beside.script", "def beside():\n  set_digital_out(5, True)\nend\n");
        auto options = VirtualRobot::options();
        options.programsFolder = folder.path();
        VirtualRobot robot(options);
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.ask("load unknown.urp"), QByteArray("Error while loading program: unknown.urp\n"));
        QCOMPARE(dashboard.ask("load broken.urp"), QByteArray("Error while loading program: broken.urp\n"));
        QCOMPARE(dashboard.ask("get loaded program"), QByteArray("No program loaded\n"));
        QCOMPARE(dashboard.ask("load \"nodes.urp\""), QByteArray("Loading program: \"nodes.urp\"\n"));
        const double begin = robot.controller.truth().timestamp;
        QCOMPARE(dashboard.ask("play"), QByteArray("Starting program\n"));
        robot.controller.step(5);
        QCOMPARE(dashboard.ask("programState"), QByteArray("PLAYING nodes.urp\n"));
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 10));
        QCOMPARE(robot.controller.truth().digitalOutputs, quint64(1) << 2);
        QVERIFY(robot.controller.truth().timestamp - begin > 0.3);
        QVERIFY(std::abs(robot.controller.truth().q[0] - -1.5) < 1e-3);
        QCOMPARE(dashboard.ask("load beside.urp"), QByteArray("Loading program: beside.urp\n"));
        dashboard.ask("play");
        robot.controller.step(10);
        QCOMPARE(robot.controller.truth().digitalOutputs, (quint64(1) << 2) | (quint64(1) << 5));
    }

    void anInstallationIsLoadedAndTakesThePower() {
        Played cell;
        QFile file(cell.folder.filePath("cell.installation"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("x");
        file.close();
        QCOMPARE(cell.dashboard.ask("load installation cell.installation"),
                 QByteArray("Loading installation: cell.installation\n"));
        QVERIFY(reaches(cell.robot, cell.dashboard, "POWER_OFF"));
        QCOMPARE(cell.dashboard.ask("load installation none"), QByteArray("File not found: none\n"));
    }

    void everyRobotHasItsDefaultInstallation() {
        VirtualRobot robot;  // without a programs folder even
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.ask("load installation default.installation"),
                 QByteArray("Loading installation: default.installation\n"));
    }

    void programsAreFoundByTheirPathOnARobot_data() {
        QTest::addColumn<QByteArray>("path");
        QTest::newRow("vendor's simulator") << QByteArray("/ursim/programs/wait_program.urp");
        QTest::newRow("robot") << QByteArray("/programs/wait_program.urp");
    }
    void programsAreFoundByTheirPathOnARobot() {
        QFETCH(QByteArray, path);
        Played cell;
        QCOMPARE(cell.dashboard.ask("load " + path), "Loading program: " + path + '\n');
        QCOMPARE(cell.dashboard.ask("load /ursim/programs/none.urp"),
                 QByteArray("File not found: /ursim/programs/none.urp\n"));
        QCOMPARE(cell.dashboard.ask("programState"), QByteArray("STOPPED wait_program.urp\n"));
        // A name no file can have; a warning of Qt's would fail the test.
        QTest::failOnWarning(QRegularExpression("."));
        QVERIFY(
            cell.dashboard.ask(QByteArray("load wait\0program.urp", 21)).startsWith("File not found: wait"));
    }

    void remoteControlTurnedOffRefusesNothingWhereItIsNotGated() {
        Played cell;
        QVERIFY(cell.robot.controller.inject("remote off").ok());
        QCOMPARE(cell.dashboard.ask("is in remote control"), QByteArray("false\n"));
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        RawPrimary primary = cell.robot.primary();
        primary.send("sec out():\n  set_standard_digital_out(3, True)\nend\n");
        QVERIFY(cell.robot.stepUntil([&] { return cell.robot.controller.truth().digitalOutputs == 8; }, 1));
    }

    void theLogIsWrittenToDisk() {
        Played cell;
        cell.dashboard.ask("addToLog first of all");
        cell.dashboard.ask("addToLog and then");
        QCOMPARE(cell.dashboard.ask("saveLog"), QByteArray("Log saved to disk\n"));
        QFile log(cell.folder.filePath("log_history.txt"));
        QVERIFY(log.open(QIODevice::ReadOnly));
        QVERIFY(log.readLine().endsWith(" first of all\n"));
        QVERIFY(log.readLine().endsWith(" and then\n"));
    }

    void reportsAreGenerated() {
        Played cell;
        QCOMPARE(cell.dashboard.ask("generate flight report system"),
                 QByteArray("Flight Report generated with id:1\n"));
        QCOMPARE(cell.dashboard.ask("generate flight report"),
                 QByteArray("Flight Report generated with id:2\n"));
        QVERIFY(cell.dashboard.ask("generate flight report weather").startsWith("Error"));
        const QByteArray made = cell.dashboard.ask("generate support file .");
        QVERIFY2(made.startsWith("Completed successfully:ur_20"), made);
        QFile zip(cell.folder.filePath(QString::fromUtf8(made.mid(23)).trimmed()));
        QVERIFY(zip.open(QIODevice::ReadOnly));
        QVERIFY(zip.readAll().startsWith("PK\x03\x04"));
        QVERIFY(cell.dashboard.ask("generate support file ../..").startsWith("Error:"));
        QVERIFY(cell.dashboard.ask("generate support file nowhere").startsWith("Error:"));
    }

    void stopEndsAProgramSentOverASocket() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        RawPrimary primary = robot.primary();
        primary.send("def p():\n  sleep(100)\nend\n");
        robot.controller.drainSockets();
        robot.controller.step(2);
        QCOMPARE(dashboard.ask("running"), QByteArray("Program running: true\n"));
        QCOMPARE(dashboard.ask("programState"),
                 QByteArray("STOPPED <unnamed>\n"));  // speaks of the loaded program
        QCOMPARE(dashboard.ask("stop"), QByteArray("Stopped\n"));
        QVERIFY(robot.stepUntil([&] { return robot.programState() == RuntimeState::Stopped; }, 1));
    }

    void theOperationalModeIsSetAndCleared() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.ask("set operational mode AUTOMATIC"),
                 QByteArray("Operational mode AUTOMATIC is set\n"));
        QCOMPARE(dashboard.ask("get operational mode"), QByteArray("AUTOMATIC\n"));
        QVERIFY(dashboard.ask("clear operational mode")
                    .startsWith("No longer controlling the operational mode."));
        QCOMPARE(dashboard.ask("get operational mode"), QByteArray("NONE\n"));
    }

    void violationAndFaultEndWithARestartOfTheSafetySystem() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        robot.controller.fault();
        robot.controller.step(2);
        QCOMPARE(dashboard.ask("safetymode"), QByteArray("Safetymode: FAULT\n"));
        QCOMPARE(dashboard.ask("robotmode"), QByteArray("Robotmode: POWER_OFF\n"));
        dashboard.ask("power on");
        robot.controller.stepSeconds(3);
        QCOMPARE(dashboard.ask("robotmode"), QByteArray("Robotmode: POWER_OFF\n"));
        QCOMPARE(dashboard.ask("restart safety"), QByteArray("Restarting safety\n"));
        robot.controller.step(2);
        QCOMPARE(dashboard.ask("safetymode"), QByteArray("Safetymode: NORMAL\n"));
        dashboard.ask("brake release");
        QVERIFY(reaches(robot, dashboard, "RUNNING"));
    }

    void localControlIsRefusedWhereItIsGated() {
        auto options = VirtualRobot::options();
        options.remoteControl = false;
        options.gateLocalControl = true;
        {
            VirtualRobot robot(options);  // clients on the controller itself are exempt
            QCOMPARE(robot.dashboard().ask("power off"), QByteArray("Powering off\n"));
        }
        options.gateLoopbackClients = true;
        VirtualRobot robot(options);
        RawDashboard dashboard = robot.dashboard();
        const QByteArray refusal =
            "Command is not allowed due to safety reasons, please switch robot to Remote Control mode and "
            "reconnect to port 29999\n";
        for (const char* command : {"power on", "power off", "brake release", "unlock protective stop",
                                    "play", "stop", "pause", "load x.urp", "restart safety", "shutdown"}) {
            QCOMPARE(dashboard.ask(command), refusal);
        }
        QCOMPARE(dashboard.ask("is in remote control"), QByteArray("false\n"));
        QCOMPARE(dashboard.ask("popup x"), QByteArray("showing popup\n"));
        robot.controller.setRemoteControl(true);
        robot.controller.drainSockets();
        QCOMPARE(dashboard.ask("power on"), refusal);  // rights are those of the connection
        RawDashboard remote = robot.dashboard();
        QCOMPARE(remote.ask("power on"), QByteArray("Powering on\n"));
        // The switch takes them away, and turning it back does not bring them again.
        robot.controller.setRemoteControl(false);
        robot.controller.drainSockets();
        QCOMPARE(remote.ask("power on"), refusal);
        robot.controller.setRemoteControl(true);
        robot.controller.drainSockets();
        QCOMPARE(remote.ask("power on"), refusal);
        QCOMPARE(robot.dashboard().ask("power on"), QByteArray("Powering on\n"));
    }

    void quitEndsThisConnectionAndNoOther() {
        VirtualRobot robot;
        RawDashboard leaving = robot.dashboard();
        RawDashboard staying = robot.dashboard();
        QCOMPARE(leaving.ask("quit"), QByteArray("Disconnected\n"));
        QVERIFY(leaving.waitClosed());
        QCOMPARE(staying.ask("robotmode"), QByteArray("Robotmode: RUNNING\n"));
    }

    void shutdownEndsEverything() {
        VirtualRobot robot;
        RawRtde rtde = robot.rtde();
        QVERIFY(rtde.useVersion());
        RawDashboard dashboard = robot.dashboard();
        QCOMPARE(dashboard.ask("shutdown"), QByteArray("Shutting down\n"));
        QVERIFY(dashboard.waitClosed());
        QVERIFY(rtde.waitClosed());
    }

    void aLineWithoutEndIsNotKeptForEver() {
        VirtualRobot robot;
        RawDashboard dashboard = robot.dashboard();
        dashboard.send(QByteArray(100'000, 'x'));
        QVERIFY(dashboard.waitClosed());
    }
};

QTEST_GUILESS_MAIN(TestDashboardService)
#include "tst_dashboard_service.moc"
