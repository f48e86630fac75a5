// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scripted demonstration, run by a new user without a display: the real application in a separate
// process.

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "robot/recording/csv_reader.h"

using namespace tiller;

class TestDemonstration : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        QProcess program;
        program.start(TILLER_PROGRAM, {"--simulator", "--demo", folder_.path()});
        QVERIFY(program.waitForFinished(150'000));
        output_ = program.readAllStandardOutput();
        QVERIFY2(program.exitStatus() == QProcess::NormalExit && program.exitCode() == 0,
                 (output_ + program.readAllStandardError()).constData());
    }

    void demonstrationCompletesEveryStepAndWritesItsFiles() {
        QVERIFY(!output_.contains("FAILED"));
        for (const char* line : {"jogged", "release to standstill", "packets", "recorded"}) {
            QVERIFY2(output_.contains(line), line);
        }

        for (const char* name : {"screenshot-light.png", "screenshot-dark.png"}) {
            const QImage picture(folder_.filePath(name));
            QCOMPARE(picture.size(), QSize(1920, 1080));
            // An image with a single colour means an empty window.
            QSet<QRgb> colours;
            for (int y = 0; y < picture.height(); y += 7) {
                for (int x = 0; x < picture.width(); x += 7) {
                    colours.insert(picture.pixel(x, y));
                }
            }
            QVERIFY(colours.size() > 50);
        }

        const Result<recording::CsvTable> table = recording::readCsv(folder_.filePath("recording.csv"));
        QVERIFY2(table.ok(), qPrintable(table.error().toString()));
        QCOMPARE(QString::fromStdString(table->columns.front()), QString("timestamp"));
        QVERIFY(table->indexOf("actual_q_5").has_value() && table->indexOf("actual_TCP_force_0").has_value());
        QVERIFY(table->rows() > 500);
        QVERIFY(QFile::exists(folder_.filePath("summary.txt")));

        const std::vector<double>& x = *table->column("actual_TCP_pose_0");
        const auto [low, high] = std::minmax_element(x.begin(), x.end());
        QVERIFY2(*high - *low > 0.049, "the recording does not contain the jog");
    }

    void pandasReadsTheRecordingUnmodified() {
        const QString python = QFile::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
        QProcess probe;
        probe.start(python, {"-c", "import pandas"});
        if (!probe.waitForFinished(60'000) || probe.exitCode() != 0) {
            QSKIP("pandas is not installed");
        }
        // The lines of listing 4 in the publication, which read the file.
        const char* script = R"(
import sys, pandas as pd
demo = pd.read_csv(sys.argv[1])
q = demo[['actual_q_0','actual_q_1','actual_q_2','actual_q_3','actual_q_4','actual_q_5']]
time = demo['timestamp']-demo['timestamp'].iloc[0]
tau = time.iloc[-1]
assert q.to_numpy().shape[1] == 6 and q.to_numpy().dtype == float
assert tau > 1.0 and (time.diff().dropna() > 0).all()
print(len(demo), tau)
)";
        QProcess reader;
        reader.start(python, {"-c", script, folder_.filePath("recording.csv")});
        QVERIFY(reader.waitForFinished(60'000));
        QVERIFY2(reader.exitCode() == 0, reader.readAllStandardError().constData());
    }

    void aFolderThatCannotBeCreatedIsReported() {
        QProcess program;
        program.start(TILLER_PROGRAM, {"--simulator", "--demo", "/proc/no/such/place"});
        QVERIFY(program.waitForFinished(60'000));
        QVERIFY(program.exitCode() != 0);
        QVERIFY2(program.readAllStandardOutput().contains("/proc/no/such/place"),
                 "the error does not name the folder");
    }

private:
    const QTemporaryDir folder_;  ///< output folder of the demonstration
    QByteArray output_;
};

QTEST_GUILESS_MAIN(TestDemonstration)
#include "tst_demonstration.moc"
