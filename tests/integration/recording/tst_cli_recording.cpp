// SPDX-License-Identifier: MIT
//
// The commands `tiller-cli record`, `info` and `export` as users type them, with the simulated controller.

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "robot/recording/csv_reader.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/simulator/simulator.h"

using namespace tiller;
using namespace tiller::recording;

namespace {

constexpr int kWaitTimeoutMs = 60'000;

QString ownAddress() {
    const auto pid = static_cast<unsigned>(QCoreApplication::applicationPid());
    return QStringLiteral("127.%1.%2.19").arg(100 + pid % 100).arg((pid / 100) % 250);
}

struct Answer {
    int code = -1;
    QString out;
    QString err;
};

Answer run(const QStringList& arguments) {
    QProcess process;
    process.start(QStringLiteral(TILLER_CLI), arguments);
    if (!process.waitForFinished(kWaitTimeoutMs)) {
        process.kill();
        process.waitForFinished();
    }
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2,
            QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

}  // namespace

class TestCliRecording : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        simulator_ = std::make_unique<simulator::Simulator>(simulator::SimulatorOptions{
            .listenAddress = address_, .poweredOn = true, .fastTransitions = true});
        QVERIFY(simulator_->start().ok());
    }
    void recordsForATimeAndDescribesTheFile();
    void metadataIsInEveryFormat();
    void namesFilesInAFolder();
    void endsCleanlyOnASignal();
    void aKilledRecorderLosesAtMostHalfASecond();
    void exportsATimeRangeAndColumns();
    void findsThePushThatCausedAStop();
    void tablesOfOtherProgramsNeedOptions();
    void wrongArgumentsAreReported_data();
    void wrongArgumentsAreReported();
    void unreadableFilesAreReported();
    void missingRobotIsAFailure();
    void helpIsPrinted_data();
    void helpIsPrinted();

private:
    QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
    QTemporaryDir folder_;
    const QString address_ = ownAddress();
    std::unique_ptr<simulator::Simulator> simulator_;
};

void TestCliRecording::recordsForATimeAndDescribesTheFile() {
    const Answer recorded = run({"record", address_, "--out", path("a.mcap"), "--duration", "1"});
    QCOMPARE(recorded.err, QString());
    QCOMPARE(recorded.code, 0);
    QVERIFY2(recorded.out.contains("rows"), qPrintable(recorded.out));
    const Answer reported = run({"info", path("a.mcap"), "--json"});
    QCOMPARE(reported.code, 0);
    const QJsonObject info = QJsonDocument::fromJson(reported.out.toUtf8()).object();
    QCOMPARE(info["format"].toString(), QStringLiteral("MCAP"));
    QVERIFY(info["rows"].toInt() > 0);
    QCOMPARE(info["period"].toDouble(), 0.002);
    QCOMPARE(info["facts"]["robot"].toString(), address_);
    QCOMPARE(info["facts"]["model"].toString(), QStringLiteral("UR5e"));
    QCOMPARE(info["facts"]["serial_number"].toString(), QString(simulator_->options().serialNumber));
    QVERIFY(info["columns"].toArray().size() > 100);
    QVERIFY(run({"info", path("a.mcap")}).out.contains("actual_q_0 [rad]"));
    // A .csv file contains the selected fields, the timestamp and the number of lost packages.
    QCOMPARE(
        run({"record", address_, "--out", path("a.csv"), "--duration", "0.3", "--fields", "actual_q"}).code,
        0);
    QCOMPARE(readCsv(path("a.csv")).value().columns,
             (std::vector<std::string>{"timestamp", "actual_q_0", "actual_q_1", "actual_q_2", "actual_q_3",
                                       "actual_q_4", "actual_q_5", "packages_lost"}));
}

void TestCliRecording::metadataIsInEveryFormat() {
    const QStringList metadata{"--meta", "operator=Änne", "--meta", "sample=a = 7"};
    for (const char* name : {"meta.mcap", "meta.csv"}) {
        const Answer recorded =
            run(QStringList{"record", address_, "--out", path(name), "--duration", "0.3"} + metadata);
        QCOMPARE(recorded.err, QString());
        QCOMPARE(recorded.code, 0);
    }
    QCOMPARE(run({"export", path("meta.mcap"), "--out", path("meta.h5")}).code, 0);
    QCOMPARE(run({"export", path("meta.h5"), "--out", path("meta2.csv"), "--head"}).code, 0);
    QCOMPARE(run({"export", path("meta.csv"), "--out", path("meta2.mcap")}).code, 0);
    for (const char* name : {"meta.mcap", "meta.csv", "meta.h5", "meta2.csv", "meta2.mcap"}) {
        const Answer described = run({"info", path(name), "--json"});
        QCOMPARE(described.code, 0);
        const QJsonObject info = QJsonDocument::fromJson(described.out.toUtf8()).object();
        QCOMPARE(info["facts"]["operator"].toString(), QStringLiteral("Änne"));
        QCOMPARE(info["facts"]["sample"].toString(), QStringLiteral("a = 7"));
        QCOMPARE(info["facts"]["serial_number"].toString(), QString(simulator_->options().serialNumber));
        QVERIFY2(info["start"].toString().startsWith("20"), name);
    }
    QVERIFY(run({"info", path("meta.csv")}).out.contains("operator: Änne"));
}

void TestCliRecording::namesFilesInAFolder() {
    const QString folder = path("named");
    QVERIFY(QDir().mkpath(folder));
    // The recordings probably start within one second. Each file must have a new name.
    for (int i = 0; i < 3; ++i) {
        const Answer recorded = run({"record", "--out-folder", folder, "--duration", "0.1", "--", address_});
        QCOMPARE(recorded.err, QString());
        QCOMPARE(recorded.code, 0);
    }
    const QStringList files = QDir(folder).entryList(QDir::Files);
    QCOMPARE(files.size(), 3);
    for (const QString& file : files) {
        QVERIFY2(file.startsWith(address_ + QLatin1String("-20")) && file.endsWith(QLatin1String(".mcap")),
                 qPrintable(file));
        QVERIFY(openRecording(folder + QLatin1Char('/') + file).ok());
    }
}

void TestCliRecording::endsCleanlyOnASignal() {
    QProcess process;
    process.start(QStringLiteral(TILLER_CLI), {"record", address_, "--out", path("signal.mcap")});
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(path("signal.mcap")).size() > 20'000, kWaitTimeoutMs);
    ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(kWaitTimeoutMs));
    QCOMPARE(process.exitCode(), 0);
    const auto recording = openRecording(path("signal.mcap")).value();
    QVERIFY(recording->problems().isEmpty());
    QVERIFY(recording->rows() > 0);
}

void TestCliRecording::aKilledRecorderLosesAtMostHalfASecond() {
    QProcess process;
    process.start(QStringLiteral(TILLER_CLI), {"record", address_, "--out", path("killed.mcap")});
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(path("killed.mcap")).size() > 100'000, kWaitTimeoutMs);
    ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
    QVERIFY(process.waitForFinished(kWaitTimeoutMs));
    const auto recording = openRecording(path("killed.mcap")).value();
    QVERIFY(recording->rows() > 0);
    const auto stamps =
        recording->read(std::vector{recording->indexOf("timestamp").value()}, {0, recording->rows()})
            .value()
            .front();
    const auto lost =
        recording->read(std::vector{recording->indexOf("packages_lost").value()}, {0, recording->rows()})
            .value()
            .front();
    for (std::size_t i = 1; i < stamps.size(); ++i) {
        // Packages are in order, and each package is either present or reported as missing.
        QCOMPARE(std::round((stamps[i] - stamps[i - 1]) * 500), 1 + lost[i]);
    }
}

void TestCliRecording::exportsATimeRangeAndColumns() {
    QCOMPARE(run({"record", address_, "--out", path("whole.mcap"), "--duration", "1"}).code, 0);
    const Answer text =
        run({"export", path("whole.mcap"), "--out", path("part.csv"), "--columns", "actual_q,robot_mode",
             "--from", "0.1", "--until", "0.2", "--separator", ";", "--decimal", ",", "--units"});
    QCOMPARE(text.err, QString());
    QCOMPARE(text.code, 0);
    QFile file(path("part.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readLine(),
             QByteArray(
                 "timestamp;actual_q_0;actual_q_1;actual_q_2;actual_q_3;actual_q_4;actual_q_5;robot_mode\n"));
    QCOMPARE(file.readLine(), QByteArray("s;rad;rad;rad;rad;rad;rad;-\n"));
    QVERIFY(file.readLine().contains(','));
    QCOMPARE(run({"export", path("whole.mcap"), "--out", path("all.h5")}).code, 0);
    const auto whole = openRecording(path("whole.mcap")).value();
    const auto all = openRecording(path("all.h5")).value();
    QCOMPARE(all->format(), QStringLiteral("HDF5"));
    QCOMPARE(all->rows(), whole->rows());
    QCOMPARE(run({"export", path("whole.mcap"), "--out", path("all.h5")}).code, 2);
    QCOMPARE(run({"export", path("all.h5"), "--out", path("again.csv"), "--quiet"}).code, 0);
    QCOMPARE(run({"export", path("all.h5"), "--out", path("again.mcap"), "--quiet"}).code, 0);
    QCOMPARE(openRecording(path("again.mcap")).value()->rows(), whole->rows());
    QCOMPARE(openRecording(path("again.csv")).value()->rows(), whole->rows());
}

void TestCliRecording::findsThePushThatCausedAStop() {
    QProcess process;
    process.start(QStringLiteral(TILLER_CLI), {"record", address_, "--out", path("pushed.mcap")});
    const auto goesOn = [this](double seconds) {
        const double until = simulator_->truth().timestamp + seconds;
        return QTest::qWaitFor([&] { return simulator_->truth().timestamp > until; }, kWaitTimeoutMs);
    };
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(path("pushed.mcap")).size() > 100'000, kWaitTimeoutMs);
    simulator_->pressHand({{0, 0, -80}, {0, 0, 0}});
    QVERIFY(goesOn(0.3));
    simulator_->protectiveStop();
    QVERIFY(goesOn(0.3));
    simulator_->pressHand({});
    ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(kWaitTimeoutMs));

    const auto recording = openRecording(path("pushed.mcap")).value();
    const auto column = [&](const char* name) {
        return recording->read(std::vector{recording->indexOf(name).value()}, {0, recording->rows()})
            .value()
            .front();
    };
    const std::vector<double> forces = column("actual_TCP_force_2");
    const std::vector<double> modes = column("safety_mode");
    const auto push = std::find_if(forces.begin(), forces.end(), [](double z) { return z < -60; });
    const auto stop = std::find(modes.begin(), modes.end(), 3.0);
    QVERIFY(push != forces.end() && stop != modes.end());
    QVERIFY(push - forces.begin() < stop - modes.begin());

    const Answer reported = run({"divergence", path("pushed.mcap"), "--json"});
    QCOMPARE(reported.err, QString());
    QCOMPARE(reported.code, 1);
    const QJsonObject first = QJsonDocument::fromJson(reported.out.toUtf8()).object()["first"].toObject();
    QCOMPARE(first["row"].toInt(), static_cast<int>(push - forces.begin()));
    const QString seconds = QString::number(first["seconds"].toDouble() - 0.01);
    QCOMPARE(run({"divergence", path("pushed.mcap"), "--until", seconds}).code, 0);
    const Answer text = run({"divergence", path("pushed.mcap")});
    QVERIFY2(text.out.contains("arm and model differ starting at"), qPrintable(text.out));
    QCOMPARE(run({"divergence", path("pushed.mcap"), "--force", "0", "--current", "0"}).code, 0);
    const Answer other = run({"divergence", path("pushed.mcap"), "--model", "ur20"});
    QVERIFY2(other.out.contains("The arm deviates from the model from the start"), qPrintable(other.out));
}

void TestCliRecording::tablesOfOtherProgramsNeedOptions() {
    QFile file(path("foreign.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("tick|F\n0|1,5\n20|2,5\n") > 0);
    file.close();
    for (const QStringList& command : {QStringList{"info"},
                                       {"export", "--out", path("foreign_out.csv")},
                                       {"divergence"},
                                       {"episodes", "--out", path("foreign.h5")}}) {
        const Answer refused = run(command + QStringList{file.fileName()});
        QCOMPARE(refused.code, 2);
        QVERIFY2(refused.err.contains("--time-column NAME") && refused.err.contains("--table-rate"),
                 qPrintable(refused.err));
    }
    const QStringList options{"--time-column",     "tick", "--time-unit",     "ms",
                              "--table-separator", "|",    "--table-decimal", ","};
    const Answer reported = run(QStringList{"info", "--json", file.fileName()} + options);
    QCOMPARE(reported.code, 0);
    const QJsonObject info = QJsonDocument::fromJson(reported.out.toUtf8()).object();
    QCOMPARE(info["period"].toDouble(), 0.02);
    QCOMPARE(info["time_column"].toString(), QStringLiteral("tick"));
    QCOMPARE(run(QStringList{"export", "--out", path("foreign_out.csv"), "--columns", "F", file.fileName()} +
                 options)
                 .code,
             0);
    QCOMPARE(readCsv(path("foreign_out.csv")).value().columns, (std::vector<std::string>{"tick [ms]", "F"}));
    const Answer noTime =
        run({"info", "--json", file.fileName(), "--time-column", "none", "--table-rate", "4"});
    QCOMPARE(QJsonDocument::fromJson(noTime.out.toUtf8()).object()["period"].toDouble(), 0.25);
}

void TestCliRecording::wrongArgumentsAreReported_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("said");
    QTest::newRow("no address") << QStringList{"record", "--out", "a.csv"} << "address";
    QTest::newRow("no file") << QStringList{"record", address_} << "--out";
    QTest::newRow("no format") << QStringList{"record", address_, "--out", "a.txt"} << ".mcap";
    QTest::newRow("no field") << QStringList{"record",      address_,   "--out",
                                             path("b.csv"), "--fields", "actual_qq"}
                              << "did you mean";
    QTest::newRow("no condition") << QStringList{"record",      address_,    "--out",
                                                 path("b.csv"), "--trigger", "force"}
                                  << "COLUMN";
    QTest::newRow("no number") << QStringList{"record",      address_,     "--out",
                                              path("b.csv"), "--duration", "long"}
                               << "--duration";
    QTest::newRow("metadata without a value")
        << QStringList{"record", address_, "--out", path("b.csv"), "--meta", "operator"} << "operator=Ann";
    QTest::newRow("metadata with a name of the recorder")
        << QStringList{"record", address_, "--out", path("b.csv"), "--meta", "robot=x"} << "robot";
    QTest::newRow("no option") << QStringList{"record", address_, "--inp", "b.csv"} << "inp";
    QTest::newRow("info of nothing") << QStringList{"info"} << "file";
    QTest::newRow("export of nothing") << QStringList{"export", "--out", "a.csv"} << "recording";
    QTest::newRow("divergence of nothing") << QStringList{"divergence"} << "recording";
    QTest::newRow("divergence of no arm") << QStringList{"divergence", "a.mcap", "--model", "kr6"} << "UR5e";
    QTest::newRow("divergence by no limit")
        << QStringList{"divergence", "a.mcap", "--joint", "-1"} << "--joint";
    QTest::newRow("time in an unknown unit")
        << QStringList{"info", "a.csv", "--time-unit", "min"} << "--time-unit";
    QTest::newRow("unknown separator")
        << QStringList{"info", "a.csv", "--table-separator", "x"} << "--table-separator";
    QTest::newRow("export to a picture") << QStringList{"export", "a.mcap", "--out", "a.png"} << ".h5";
}

void TestCliRecording::wrongArgumentsAreReported() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, said);
    const Answer answer = run(arguments);
    QCOMPARE(answer.code, 2);
    QVERIFY2(answer.err.contains(said), qPrintable(answer.err));
}

void TestCliRecording::unreadableFilesAreReported() {
    QFile file(path("broken.mcap"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("hello\1\2") > 0);
    file.close();
    for (const QStringList& arguments :
         {QStringList{"info", path("broken.mcap")}, QStringList{"divergence", path("broken.mcap")},
          QStringList{"export", path("broken.mcap"), "--out", path("x.csv")}}) {
        const Answer answer = run(arguments);
        QCOMPARE(answer.code, 1);
        QVERIFY2(answer.err.contains("not a table of numbers"), qPrintable(answer.err));
    }
    QVERIFY(!QFileInfo::exists(path("x.csv")));
}

void TestCliRecording::missingRobotIsAFailure() {
    const Answer answer =
        run({"record", "127.0.0.1", "--port-offset", "13", "--out", path("none.csv"), "--wait", "0.2"});
    QCOMPARE(answer.code, 1);
    QVERIFY2(answer.err.contains("no data from"), qPrintable(answer.err));
    QVERIFY(!QFileInfo::exists(path("none.csv")));
}

void TestCliRecording::helpIsPrinted_data() {
    QTest::addColumn<QString>("command");
    for (const char* command : {"record", "info", "export", "serve", "divergence"}) {
        QTest::newRow(command) << command;
    }
}

void TestCliRecording::helpIsPrinted() {
    QFETCH(QString, command);
    const Answer answer = run({command, "--help"});
    QCOMPARE(answer.code, 0);
    QVERIFY(answer.out.startsWith("tiller-cli " + command));
    QVERIFY(answer.out.contains("Exit code"));
    for (const QString& line : answer.out.split('\n')) {
        QVERIFY2(line.size() <= 110, qPrintable(line));
    }
}

QTEST_GUILESS_MAIN(TestCliRecording)
#include "tst_cli_recording.moc"
