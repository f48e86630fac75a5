// SPDX-License-Identifier: MIT
// Descriptions of the recordings in a folder, in every format.
#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "robot/recording/formats/export_recording.h"
#include "robot/recording/formats/file_formats.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/formats/recording_overview.h"
#include "tests/unit/robot/recording/made_recording.h"

using namespace tiller;
using namespace tiller::recording;

class TestRecordingOverview : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyFormatIsDescribed_data() {
        QTest::addColumn<QString>("suffix");
        for (const FileFormat& format : fileFormats()) {
            if (TILLER_HAS_HDF5 != 0 || format.name != QLatin1String("HDF5")) {
                QTest::newRow(qPrintable(format.name)) << format.suffixes.constFirst();
            }
        }
    }

    // Metadata, notes and duration survive recording and export to each format.
    void everyFormatIsDescribed() {
        QFETCH(QString, suffix);
        const QTemporaryDir folder;
        McapFormatOptions extras;
        extras.facts = {{"operator", "Ann"}, {"sample", "7 b"}, {"model", "UR5e"}};
        const auto format = mcapFormat(extras);
        test::MadeSamples samples({"timestamp", "actual_TCP_force", "robot_mode"});
        const auto encoder =
            format->encoder({samples.layout, {"timestamp", "actual_TCP_force", "robot_mode"}, false});
        constexpr std::uint64_t kRows = 501;
        for (std::uint64_t row = 0; row < kRows; ++row) {
            encoder->add(samples.at(row), 0, samples.utcNs(row));
        }
        encoder->add({samples.utcNs(100), 20, kNoteSource, "sample touched"});
        encoder->add({samples.utcNs(200), 20, kTriggerSource, "Trigger: robot_mode = 7 (7)"});
        encoder->add({samples.utcNs(300), 20, "operator", "not a note"});
        const QString source = folder.filePath("source.mcap");
        QVERIFY(test::writeFile(source, encoder->take(RecordingEncoder::Close::Last).bytes));
        const auto recorded = openRecording(source).value();
        ExportChoice choice;
        choice.path = folder.filePath("run." + suffix);
        CsvStyle style;
        style.head = true;
        QVERIFY(exportRecording(*recorded, choice, style).ok());

        const auto made = recordingOverview(choice.path);
        QVERIFY2(made.ok(), qPrintable(made.error().toString()));
        const RecordingOverview& overview = *made;
        QCOMPARE(overview.path, QString(choice.path));
        QCOMPARE(overview.rows, kRows);
        QVERIFY2(std::abs(overview.seconds - 1.0) < 1e-6, qPrintable(QString::number(overview.seconds)));
        QCOMPARE(overview.bytes, QFileInfo(overview.path).size());
        QCOMPARE(overview.start.toMSecsSinceEpoch(), test::kMadeStartNs / 1'000'000);
        QCOMPARE(overview.metadataText(), QString("operator=Ann, sample=7 b"));
        QCOMPARE(overview.notes, (QStringList{"sample touched", "Trigger: robot_mode = 7 (7)"}));
        QCOMPARE(overview.signal, QString("actual_TCP_force_2"));
        QVERIFY(overview.low.size() >= 60 && overview.low.size() == overview.high.size());
        const double low = *std::min_element(overview.low.begin(), overview.low.end());
        const double high = *std::max_element(overview.high.begin(), overview.high.end());
        const std::size_t force = *samples.layout->indexOfComponent("actual_TCP_force_2");
        double expectedLow = INFINITY;
        double expectedHigh = -INFINITY;
        for (std::uint64_t row = 0; row < kRows; ++row) {
            expectedLow = std::min(expectedLow, samples.value(force, row));
            expectedHigh = std::max(expectedHigh, samples.value(force, row));
        }
        QVERIFY(std::abs(low - expectedLow) < 1e-6 && std::abs(high - expectedHigh) < 1e-6);

        for (const char* words : {"", "ann", "OPERATOR=ANN 7", "ur5e", "touched run", "2026-01"}) {
            QVERIFY2(overview.matches(words), words);
        }
        QVERIFY(!overview.matches("ann bob"));
    }

    void aFolderListsItsRecordingsNewestFirst() {
        const QTemporaryDir folder;
        const auto write = [&](const char* name, int age) {
            const QString path = folder.filePath(name);
            QVERIFY(test::writeFile(path, test::madeFile(*csvFormat(), 3)));
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadWrite));
            QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-age),
                                     QFileDevice::FileModificationTime));
        };
        write("b.csv", 10);
        write("a.MCAP", 30);
        write("c.h5", 20);
        write("b.notes.csv", 1);
        write("d.txt", 1);
        QVERIFY(QDir(folder.path()).mkdir("e.csv"));
        QStringList names;
        for (const QString& path : recordingsIn(folder.path())) {
            names << QFileInfo(path).fileName();
        }
        QCOMPARE(names, (QStringList{"b.csv", "c.h5", "a.MCAP"}));
        QCOMPARE(recordingsIn(folder.filePath("missing")), QStringList());
    }

    void aDamagedFileGivesTheReason() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("damaged.mcap");
        QVERIFY(test::writeFile(path, "\x89MCAP"));
        const auto made = recordingOverview(path);
        QVERIFY(!made.ok());
        QCOMPARE(made.error().code, ErrorCode::FileCorrupt);
    }
};

QTEST_GUILESS_MAIN(TestRecordingOverview)
#include "tst_recording_overview.moc"
