// SPDX-License-Identifier: MIT
//
// The commands `tiller-cli project info`, `check` and `convert` as users type them.

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/project_file.h"

using namespace tiller;

namespace {

constexpr int kTimeoutMs = 60'000;
const QString kSamples = QStringLiteral(TILLER_SOURCE_DIR "/resources/samples");

struct Answer {
    int code = -1;
    QString out;
    QString err;
};

Answer run(const QStringList& arguments) {
    QProcess process;
    process.start(QStringLiteral(TILLER_CLI), QStringList{"project"} + arguments);
    if (!process.waitForFinished(kTimeoutMs)) {
        process.kill();
        process.waitForFinished();
    }
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2,
            QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

project::Waypoint waypoint(const QString& name, double base) {
    project::Waypoint point;
    point.id = QUuid::createUuid();
    point.name = name;
    point.joints.values << base, -1.5708, 1.5708, -1.5708, -1.5708, 0;
    point.pose = kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, point.joints);
    return point;
}

}  // namespace

class TestCliProject : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void samplesHaveNoError_data() {
        QTest::addColumn<QString>("file");
        for (const QString& file : QDir(kSamples).entryList({"*.tiller"})) {
            QTest::newRow(qPrintable(file)) << kSamples + '/' + file;
        }
    }
    void samplesHaveNoError() {
        QFETCH(QString, file);
        const Answer answer = run({"check", file});
        QVERIFY2(answer.code == 0, qPrintable(answer.out + answer.err));
    }

    void checkNamesWaypointPathAndReason() {
        project::Project cell;
        cell.robot = RobotModelId::UR5e;
        cell.waypoints.append(waypoint("pick", 0));
        cell.waypoints.append(waypoint("place", 1.5708));
        project::Waypoint far = waypoint("far", 0);
        far.priority = project::TargetKind::Pose;
        far.pose.position.x() = 3;
        cell.waypoints.append(far);
        project::CellBox crate;
        crate.id = QUuid::createUuid();
        crate.name = QStringLiteral("crate");
        crate.pose.position = waypoint({}, 0.7854).pose.position;
        crate.size.setConstant(0.05);
        cell.cell.boxes.append(crate);
        QVERIFY(project::saveProject(path("bad.tiller"), cell).ok());

        const Answer text = run({"check", path("bad.tiller")});
        QCOMPARE(text.code, 1);
        QVERIFY2(
            text.out.contains("error: path 1 “pick” to 2 “place”: ") && text.out.contains("“crate” after"),
            qPrintable(text.out));
        QVERIFY2(text.out.contains("error: waypoint 3 “far”: Out of reach."), qPrintable(text.out));
        QVERIFY2(text.out.contains("2 errors, 0 warnings"), qPrintable(text.out));

        const Answer json = run({"check", path("bad.tiller"), "--json"});
        QCOMPARE(json.code, 1);
        const QJsonObject report = QJsonDocument::fromJson(json.out.toUtf8()).object();
        QCOMPARE(report["errors"].toInt(), 2);
        QCOMPARE(report["findings"].toArray().size(), 2);
        QCOMPARE(report["model"].toString(), QStringLiteral("UR5e"));
    }

    void checkNamesAnObjectWhoseFrameIsMissing() {
        project::Project cell;
        cell.robot = RobotModelId::UR5e;
        cell.waypoints.append(waypoint("pick", 0));
        project::CellBox crate;
        crate.id = QUuid::createUuid();
        crate.name = QStringLiteral("crate");
        crate.frame = QUuid::createUuid();
        cell.cell.boxes.append(crate);
        QVERIFY(project::saveProject(path("frame.tiller"), cell).ok());
        const Answer answer = run({"check", path("frame.tiller")});
        QCOMPARE(answer.code, 1);
        QVERIFY2(answer.out.contains("error: cell “crate”: ") && answer.out.contains("frame"),
                 qPrintable(answer.out + answer.err));
    }

    void infoListsTheContent() {
        project::Project cell;
        cell.robot = RobotModelId::UR10e;
        cell.waypoints.append(waypoint("pick", 0));
        QVERIFY(project::saveProject(path("info.tiller"), cell).ok());
        const Answer text = run({"info", path("info.tiller")});
        QCOMPARE(text.code, 0);
        QVERIFY2(text.out.contains("UR10e, 1 waypoints") && text.out.contains("pick"), qPrintable(text.out));
        const QJsonObject info =
            QJsonDocument::fromJson(run({"info", path("info.tiller"), "--json"}).out.toUtf8()).object();
        QCOMPARE(info["model"].toString(), QStringLiteral("UR10e"));
        QCOMPARE(info["waypoints"].toArray().at(0)["name"].toString(), QStringLiteral("pick"));
    }

    void convertsToATableAndBack() {
        project::Project cell;
        cell.robot = RobotModelId::UR5e;
        cell.waypoints.append(waypoint("pick, left", 0.5));
        QVERIFY(project::saveProject(path("a.tiller"), cell).ok());
        QCOMPARE(run({"convert", path("a.tiller"), "--out", path("a.csv")}).code, 0);
        const Answer again = run({"convert", path("a.csv"), "--out", path("b.tiller")});
        QCOMPARE(again.code, 2);  // the robot is not specified
        QCOMPARE(run({"convert", path("a.csv"), "--out", path("b.tiller"), "--model", "ur5e"}).code, 0);
        const auto back = project::loadProject(path("b.tiller"));
        QVERIFY(back.ok());
        QCOMPARE(back->robot, std::optional(RobotModelId::UR5e));
        QCOMPARE(back->waypoints.at(0).name, QStringLiteral("pick, left"));
        QVERIFY(
            (back->waypoints.at(0).joints.values - cell.waypoints.at(0).joints.values).cwiseAbs().maxCoeff() <
            1e-4);
        // An existing file is replaced only with --force.
        QCOMPARE(run({"convert", path("a.tiller"), "--out", path("a.csv")}).code, 2);
        QCOMPARE(run({"convert", path("a.tiller"), "--out", path("a.csv"), "--force"}).code, 0);
    }

    void wrongArgumentsAreRefused_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("code");
        const QString sample = kSamples + "/gluing.tiller";
        QTest::newRow("nothing") << QStringList{} << 2;
        QTest::newRow("no file") << QStringList{"check"} << 2;
        QTest::newRow("no such action") << QStringList{"improve", sample} << 2;
        QTest::newRow("no such model") << QStringList{"check", sample, "--model", "ur99"} << 2;
        QTest::newRow("convert to nothing") << QStringList{"convert", sample} << 2;
        QTest::newRow("no such file") << QStringList{"check", "/nonexistent.tiller"} << 1;
        QTest::newRow("no project") << QStringList{"info", QStringLiteral(TILLER_CLI)} << 1;
        QTest::newRow("help") << QStringList{"--help"} << 0;
    }
    void wrongArgumentsAreRefused() {
        QFETCH(QStringList, arguments);
        QFETCH(int, code);
        const Answer answer = run(arguments);
        QCOMPARE(answer.code, code);
        QCOMPARE(answer.err.isEmpty(), code == 0);
    }

    void aProjectWithoutAModelRequiresTheModelOption() {
        project::Project cell;
        cell.waypoints.append(waypoint("pick", 0));
        QVERIFY(project::saveProject(path("none.tiller"), cell).ok());
        QCOMPARE(run({"check", path("none.tiller")}).code, 2);
        QCOMPARE(run({"check", path("none.tiller"), "--model", "ur5e"}).code, 0);
    }

private:
    QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestCliProject)
#include "tst_cli_project.moc"
