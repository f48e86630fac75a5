// SPDX-License-Identifier: MIT
//
// Third-party software reads recordings: the MCAP library for Node.js, pandas, h5py. Tests are skipped if the
// software is not installed.

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "robot/recording/formats/open_recording.h"
#include "robot/recording/hdf5/hdf5_export.h"
#include "robot/recording/mcap/mcap_format.h"
#include "tests/unit/robot/recording/made_recording.h"

using namespace tiller;
using namespace tiller::recording;
using test::MadeSamples;

namespace {

constexpr int kWaitTimeoutMs = 100'000;
constexpr std::uint64_t kRows = 1500;
constexpr std::uint64_t kGap = 700;

/// Runs a program and returns its output as JSON.
QJsonObject answerOf(const QString& program, const QStringList& arguments, QString& complaint) {
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished(kWaitTimeoutMs)) {
        process.kill();
        process.waitForFinished();
    }
    complaint = QString::fromUtf8(process.readAllStandardError());
    return QJsonDocument::fromJson(process.readAllStandardOutput()).object();
}

}  // namespace

class TestOthersRead : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void officialLibraryReadsMcap();
    void pandasReadsCsv();
    void h5pyReadsHdf5();
    void octaveReadsCsv();
    void octaveReadsHdf5();

private:
    QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
    bool hasPython(const char* module) const {
        return QProcess::execute("/usr/bin/python3", {"-c", QStringLiteral("import ") + module}) == 0;
    }
    QTemporaryDir folder_;
};

void TestOthersRead::officialLibraryReadsMcap() {
    const QString modules = QStringLiteral(TILLER_NODE_MODULES);
    const QString node = QStandardPaths::findExecutable("node");
    if (node.isEmpty() || !QFileInfo::exists(modules + "/@mcap/core") ||
        !QFileInfo::exists(modules + "/@foxglove/rosmsg2-serialization")) {
        QSKIP(
            "Node.js or its packages are not installed (packaging/test installs the packages in build/npm)");
    }
    McapFormatOptions options;
    options.facts = {{"model", "UR5e"}};
    options.attachmentName = "cell.tiller";
    options.attachment = "{}";
    QVERIFY(test::writeFile(path("a.mcap"), test::madeFile(*mcapFormat(options), kRows, kGap)));
    QString complaint;
    const QJsonObject found =
        answerOf(node,
                 {QStringLiteral(TILLER_SOURCE_DIR "/tests/integration/recording/read_mcap.mjs"), modules,
                  path("a.mcap")},
                 complaint);
    QVERIFY2(!found.isEmpty(), qPrintable(complaint));
    QCOMPARE(found["profile"].toString(), QStringLiteral("ros2"));
    QVERIFY(found["done"].toBool());
    QCOMPARE(found["metadata"]["recording"]["model"].toString(), QStringLiteral("UR5e"));
    QCOMPARE(found["attachments"]["cell.tiller"].toString(), QStringLiteral("{}"));
    QCOMPARE(QString::number(found["streamed"].toInt()), found["messages"].toString());

    const QJsonObject topics = found["topics"].toObject();
    const QJsonObject states = topics["/robot_state"].toObject();
    QCOMPARE(states["count"].toInt(), int(kRows));
    QCOMPARE(states["schema"].toString(), QStringLiteral("tiller_msgs/msg/RobotState"));
    QCOMPARE(states["encoding"].toString(), QStringLiteral("cdr"));
    const MadeSamples samples;
    const QJsonObject last = states["last"].toObject();
    const auto value = [&](const char* component) {
        return samples.value(samples.layout->indexOfComponent(component).value(), kRows - 1);
    };
    QCOMPARE(last["timestamp"].toDouble(), value("timestamp"));
    QCOMPARE(last["actual_q"][4].toDouble(), value("actual_q_4"));
    QCOMPARE(last["actual_tcp_pose"][2].toDouble(), value("actual_TCP_pose_2"));
    QCOMPARE(last["robot_mode"].toDouble(), value("robot_mode"));
    QCOMPARE(last["joint_mode"][5].toDouble(), value("joint_mode_5"));
    QCOMPARE(last["actual_digital_input_bits"].toString(),
             QString::number(value("actual_digital_input_bits")));
    QCOMPARE(states["lastPublish"].toString(), QString::number(samples.utcNs(kRows - 1)));

    const QJsonObject joints = topics["/joint_states"].toObject();
    QCOMPARE(joints["count"].toInt(), int(kRows));
    QCOMPARE(joints["last"]["name"][1].toString(), QStringLiteral("shoulder_lift_joint"));
    QCOMPARE(joints["last"]["position"][1].toDouble(), value("actual_q_1"));
    QCOMPARE(joints["last"]["effort"][1].toDouble(), value("actual_current_1"));
    QCOMPARE(topics["/wrench"]["last"]["wrench"]["force"]["z"].toDouble(), value("actual_TCP_force_2"));
    const QJsonValue transform = topics["/tf"]["last"]["transforms"][0];
    QCOMPARE(transform["child_frame_id"].toString(), QStringLiteral("tool0_controller"));
    QCOMPARE(transform["transform"]["translation"]["y"].toDouble(), value("actual_TCP_pose_1"));
    const QJsonValue turn = transform["transform"]["rotation"];
    double length = 0;
    for (const char* part : {"x", "y", "z", "w"}) {
        length += turn[part].toDouble() * turn[part].toDouble();
    }
    QVERIFY(std::abs(length - 1) < 1e-12);
    QCOMPARE(topics["/rosout"]["last"]["msg"].toString(), QStringLiteral("half way"));
    const QJsonObject summary = topics["/robot_state/summary_32"].toObject();
    QCOMPARE(summary["count"].toInt(), int((kRows + 31) / 32));
    QCOMPARE(summary["last"]["max"].toArray().size(), qsizetype(samples.layout->size() + 1));
}

void TestOthersRead::pandasReadsCsv() {
    if (!hasPython("pandas")) {
        QSKIP("pandas is not installed (python3-pandas)");
    }
    QVERIFY(test::writeFile(path("a.mcap"), test::madeFile(*mcapFormat(), kRows, kGap)));
    const auto recording = openRecording(path("a.mcap")).value();
    exportCsv(*recording, {.path = path("plain.csv")}).value();
    exportCsv(*recording, {.path = path("german.csv")}, {';', ',', true}).value();
    const char* script =
        "import json, pandas, sys\n"
        "a = pandas.read_csv(sys.argv[1])\n"
        "b = pandas.read_csv(sys.argv[2], sep=';', decimal=',', skiprows=[1])\n"
        "units = open(sys.argv[2]).readlines()[1].strip().split(';')\n"
        "print(json.dumps({'rows': len(a), 'same': bool(a.equals(b)), 'q': a.actual_q_3.iloc[-1], 'lost': "
        "int(a.packages_lost.sum()),\n"
        "                  'unit': units[list(b.columns).index('actual_q_3')]}))\n";
    QString complaint;
    const QJsonObject found =
        answerOf("/usr/bin/python3", {"-c", script, path("plain.csv"), path("german.csv")}, complaint);
    QVERIFY2(!found.isEmpty(), qPrintable(complaint));
    const MadeSamples samples;
    QCOMPARE(found["rows"].toInt(), int(kRows));
    QVERIFY(found["same"].toBool());
    QVERIFY(std::abs(found["q"].toDouble() -
                     samples.value(samples.layout->indexOfComponent("actual_q_3").value(), kRows - 1)) <
            1e-15);
    QCOMPARE(found["lost"].toInt(), 5);
    QCOMPARE(found["unit"].toString(), QStringLiteral("rad"));
}

void TestOthersRead::h5pyReadsHdf5() {
    if (!hasPython("h5py")) {
        QSKIP("h5py is not installed (python3-h5py)");
    }
    QVERIFY(test::writeFile(path("a.mcap"),
                            test::madeFile(*mcapFormat({.facts = {{"model", "UR5e"}}}), kRows, kGap)));
    exportHdf5(*openRecording(path("a.mcap")).value(), {.path = path("a.h5")}).value();
    const char* script =
        "import h5py, json, sys\n"
        "f = h5py.File(sys.argv[1])\n"
        "text = lambda v: v.decode() if isinstance(v, bytes) else str(v)\n"
        "print(json.dumps({'shape': list(f['actual_q'].shape), 'q': f['actual_q'][-1, 3], 'unit': "
        "text(f['actual_q'].attrs['unit']),\n"
        "  'mode': str(f['robot_mode'].dtype), 'gaps': f['gaps'][:].tolist(), 'model': "
        "text(f.attrs['model']),\n"
        "  'time': f['time'][-1], 'note': text(f['notes/text'][0]), 'noted': f['notes/time'][0]}))\n";
    QString complaint;
    const QJsonObject found = answerOf("/usr/bin/python3", {"-c", script, path("a.h5")}, complaint);
    QVERIFY2(!found.isEmpty(), qPrintable(complaint));
    const MadeSamples samples;
    QCOMPARE(found["shape"].toArray(), (QJsonArray{int(kRows), 6}));
    QCOMPARE(found["q"].toDouble(),
             samples.value(samples.layout->indexOfComponent("actual_q_3").value(), kRows - 1));
    QCOMPARE(found["unit"].toString(), QStringLiteral("rad"));
    QCOMPARE(found["mode"].toString(), QStringLiteral("int32"));
    QCOMPARE(found["model"].toString(), QStringLiteral("UR5e"));
    QCOMPARE(found["gaps"][0][0].toInt(), int(kGap));
    QCOMPARE(found["gaps"][0][1].toInt(), 5);
    QVERIFY(std::abs(found["time"].toDouble() - (kRows - 1) * 0.002) < 1e-6);
    QCOMPARE(found["note"].toString(), QStringLiteral("half way"));
    QVERIFY(std::abs(found["noted"].toDouble() - kRows / 2 * 0.002) < 1e-6);
}

void TestOthersRead::octaveReadsCsv() {
    const QString octave = QStandardPaths::findExecutable(QStringLiteral("octave-cli"));
    if (octave.isEmpty()) {
        QSKIP("Octave is not installed (octave)");
    }
    QVERIFY(test::writeFile(path("b.mcap"), test::madeFile(*mcapFormat({}), kRows, kGap)));
    const auto recording = openRecording(path("b.mcap")).value();
    exportCsv(*recording, {.path = path("octave.csv")}).value();
    const QString script =
        QStringLiteral(
            "n = 'FILE'; a = dlmread(n, ',', 1, 0); f = fopen(n); h = strsplit(strtrim(fgetl(f)), ',');\n"
            "q = find(strcmp(h, 'actual_q_3')); lost = find(strcmp(h, 'packages_lost'));\n"
            "printf('{\"rows\": %d, \"q\": %.17g, \"lost\": %d}', rows(a), a(end, q), sum(a(:, lost)));\n")
            .replace(QStringLiteral("FILE"), path("octave.csv"));
    QString complaint;
    const QJsonObject found = answerOf(octave, {"--norc", "--eval", script}, complaint);
    QVERIFY2(!found.isEmpty(), qPrintable(complaint));
    const MadeSamples samples;
    QCOMPARE(found["rows"].toInt(), int(kRows));
    QCOMPARE(found["q"].toDouble(),
             samples.value(samples.layout->indexOfComponent("actual_q_3").value(), kRows - 1));
    QCOMPARE(found["lost"].toInt(), 5);
}

void TestOthersRead::octaveReadsHdf5() {
    const QString octave = QStandardPaths::findExecutable(QStringLiteral("octave-cli"));
    if (octave.isEmpty()) {
        QSKIP("Octave is not installed (octave)");
    }
    QVERIFY(test::writeFile(path("o.mcap"), test::madeFile(*mcapFormat({}), kRows, kGap)));
    exportHdf5(*openRecording(path("o.mcap")).value(), {.path = path("o.h5")}).value();
    // A row of the file is a column in Octave, which uses column-major order.
    const QString script =
        QStringLiteral(
            "s = load('-hdf5', 'FILE');\n"
            "printf('{\"rows\": %d, \"q\": %.17g, \"mode\": %d, \"lost\": %d, \"gap\": %d}', "
            "columns(s.actual_q), s.actual_q(4, end), s.robot_mode(end), sum(s.packages_lost), "
            "s.gaps(1, 1));\n")
            .replace(QStringLiteral("FILE"), path("o.h5"));
    QString complaint;
    const QJsonObject found = answerOf(octave, {"--norc", "--eval", script}, complaint);
    QVERIFY2(!found.isEmpty(), qPrintable(complaint));
    const MadeSamples samples;
    const auto value = [&](const char* component) {
        return samples.value(samples.layout->indexOfComponent(component).value(), kRows - 1);
    };
    QCOMPARE(found["rows"].toInt(), int(kRows));
    QCOMPARE(found["q"].toDouble(), value("actual_q_3"));
    QCOMPARE(found["mode"].toDouble(), value("robot_mode"));
    QCOMPARE(found["lost"].toInt(), 5);
    QCOMPARE(found["gap"].toInt(), int(kGap));
}

QTEST_GUILESS_MAIN(TestOthersRead)
#include "tst_others_read.moc"
