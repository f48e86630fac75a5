// SPDX-License-Identifier: MIT
// Dashboard and files: loading and playing programs, installations, the log and reports.
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Converts to the file format of the teach pendant. qCompress() produces the same deflate data in another
/// container.
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

/// A robot that is ready to play wait_program.urp, which does not end.
struct Played {
    static simulator::SimulatorOptions options(const QString& folder) {
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

class TestDashboardFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aProgramFileIsLoadedPlayedPausedAndStopped() {
        QTemporaryDir folder;
        QFile file(folder.filePath("wait_program.urp"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("def wait_program():\n  while True:\n    sleep(1)\n  end\nend\n");
        file.close();
        auto options = VirtualRobot::poweredOff();
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
        // The arm is not powered yet.
        QCOMPARE(dashboard.ask("play"), QByteArray("Failed to execute: play\n"));
        dashboard.ask("brake release");
        QVERIFY(robot.untilMode(dashboard, "RUNNING"));
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
        QVERIFY(cell.robot.controller.inject("popup wait for me").ok());  // a blocking popup prevents playing
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Failed to execute: play\n"));
        cell.dashboard.ask("close popup");
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
    }

    void playWorksImmediatelyAfterStopAndLoad() {
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

    void stopAndPlayInOneSegmentAreBothExecuted() {
        Played cell;
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        cell.robot.controller.step(5);
        cell.dashboard.send("stop\nplay\n");
        QCOMPARE(cell.dashboard.line(), QByteArray("Stopped\n"));
        QCOMPARE(cell.dashboard.line(), QByteArray("Starting program\n"));
        cell.robot.controller.step(50);
        QCOMPARE(cell.dashboard.ask("programState"), QByteArray("PLAYING wait_program.urp\n"));
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
        write("forever.urp",
              gzipped(QByteArray(head).replace("<MainProgram>", "<MainProgram runOnlyOnce=\"false\">") +
                      "<Wait type=\"Sleep\"><waitTime>0.1</waitTime></Wait>" + tail));
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
        QCOMPARE(dashboard.ask("load forever.urp"), QByteArray("Loading program: forever.urp\n"));
        dashboard.ask("play");
        robot.controller.stepSeconds(1);
        QCOMPARE(dashboard.ask("programState"), QByteArray("PLAYING forever.urp\n"));
        QCOMPARE(dashboard.ask("load beside.urp"), QByteArray("Loading program: beside.urp\n"));
        dashboard.ask("play");
        robot.controller.step(10);
        QCOMPARE(robot.controller.truth().digitalOutputs, (quint64(1) << 2) | (quint64(1) << 5));
    }

    void loadingAnInstallationPowersOffTheArm() {
        Played cell;
        QFile file(cell.folder.filePath("cell.installation"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("x");
        file.close();
        QCOMPARE(cell.dashboard.ask("load installation cell.installation"),
                 QByteArray("Loading installation: cell.installation\n"));
        QVERIFY(cell.robot.untilMode(cell.dashboard, "POWER_OFF"));
        QCOMPARE(cell.dashboard.ask("load installation none"), QByteArray("File not found: none\n"));
    }

    void everyRobotHasItsDefaultInstallation() {
        VirtualRobot robot;  // a robot without a programs folder
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
        // A name that is not allowed for files. A Qt warning would fail the test.
        QTest::failOnWarning(QRegularExpression("."));
        QVERIFY(
            cell.dashboard.ask(QByteArray("load wait\0program.urp", 21)).startsWith("File not found: wait"));
    }

    void filesOutsideTheProgramsFolderAreNotLoaded_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<bool>("loads");
        QTest::newRow("absolute") << QByteArray("OUTSIDE/secret.urp") << false;
        QTest::newRow("up") << QByteArray("../secret.urp") << false;
        QTest::newRow("up from the robot's folder") << QByteArray("/programs/../secret.urp") << false;
        QTest::newRow("up from the vendor's") << QByteArray("/ursim/programs/../secret.urp") << false;
        QTest::newRow("deep and up") << QByteArray("sub/../../secret.urp") << false;
        QTest::newRow("a link to a file") << QByteArray("link.urp") << false;
        QTest::newRow("a link to a folder") << QByteArray("linked/secret.urp") << false;
        QTest::newRow("system's file") << QByteArray("/etc/hostname") << false;
        QTest::newRow("within, by its full path") << QByteArray("INSIDE/sub/deep.urp") << true;
        QTest::newRow("within") << QByteArray("sub/deep.urp") << true;
        QTest::newRow("robot's path") << QByteArray("/programs/sub/deep.urp") << true;
        QTest::newRow("vendor's path") << QByteArray("/ursim/programs/sub/deep.urp") << true;
        QTest::newRow("up and back") << QByteArray("sub/../sub/deep.urp") << true;
        QTest::newRow("a link within") << QByteArray("near.urp") << true;
    }
    void filesOutsideTheProgramsFolderAreNotLoaded() {
        QFETCH(QByteArray, name);
        QFETCH(bool, loads);
        QTemporaryDir place;
        const QDir outside(place.path());
        QVERIFY(outside.mkpath("programs/sub"));
        const auto write = [&](const char* path) {
            QFile file(outside.filePath(path));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("def p():\n  sleep(1)\nend\n");
        };
        write("secret.urp");
        write("programs/sub/deep.urp");
        QVERIFY(QFile::link(outside.filePath("secret.urp"), outside.filePath("programs/link.urp")));
        QVERIFY(QFile::link(outside.path(), outside.filePath("programs/linked")));
        QVERIFY(
            QFile::link(outside.filePath("programs/sub/deep.urp"), outside.filePath("programs/near.urp")));
        name.replace("OUTSIDE", outside.path().toUtf8());
        name.replace("INSIDE", outside.filePath("programs").toUtf8());
        auto options = VirtualRobot::options();
        options.programsFolder = outside.filePath("programs");
        VirtualRobot robot(options);
        RawDashboard dashboard = robot.dashboard();
        for (const QByteArray what : {"", "installation "}) {
            const QByteArray reply = dashboard.ask("load " + what + name);
            QVERIFY2(reply.startsWith("Loading") == loads, reply);
            QVERIFY2(loads || reply == "File not found: " + name + '\n', reply);
        }
        QCOMPARE(dashboard.ask("get loaded program") == "No program loaded\n", !loads);
    }

    // A file that is inside the folder when it is loaded may later be replaced by a link.
    void aLoadedProgramReplacedByALinkIsNotPlayed() {
        QTemporaryDir elsewhere;
        QFile secret(elsewhere.filePath("secret.script"));
        QVERIFY(secret.open(QIODevice::WriteOnly));
        secret.write("def p():\n  set_standard_digital_out(1, True)\nend\n");
        secret.close();
        Played cell;
        QVERIFY(QFile::remove(cell.folder.filePath("wait_program.urp")));
        QVERIFY(QFile::link(secret.fileName(), cell.folder.filePath("wait_program.urp")));
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Failed to execute: play\n"));
        // The script next to a program must not be a link to a file outside the folder either.
        QFile program(cell.folder.filePath("pair.urp"));
        QVERIFY(program.open(QIODevice::WriteOnly));
        program.write(
            "<URProgram name=\"p\"><children><MainProgram runOnlyOnce=\"true\"/></children></URProgram>");
        program.close();
        QVERIFY(QFile::link(secret.fileName(), cell.folder.filePath("pair.script")));
        QCOMPARE(cell.dashboard.ask("load pair.urp"), QByteArray("Loading program: pair.urp\n"));
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        cell.robot.controller.step(20);
        QCOMPARE(cell.robot.controller.truth().digitalOutputs, quint64(0));
    }

    void localControlRefusesNothingOnAnUngatedRobot() {
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
};

QTEST_GUILESS_MAIN(TestDashboardFiles)
#include "tst_dashboard_files.moc"
