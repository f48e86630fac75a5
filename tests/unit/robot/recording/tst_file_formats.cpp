// SPDX-License-Identifier: MIT
// A file is opened in the format in which it was written, regardless of its name. The test covers every
// format in the table.
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include "robot/recording/formats/export_recording.h"
#include "robot/recording/formats/file_formats.h"
#include "robot/recording/formats/open_recording.h"
#include "tests/unit/robot/recording/made_recording.h"

using namespace tiller;
using namespace tiller::recording;

class TestFileFormats : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void suffixesAndNamesAreUnique() {
        QSet<QString> seen;
        int others = 0;
        for (const FileFormat& format : fileFormats()) {
            QVERIFY(!format.suffixes.isEmpty());
            for (const QString& word : format.suffixes + QStringList{format.name}) {
                QVERIFY2(!seen.contains(word), qPrintable(word));
                seen.insert(word);
            }
            others += format.magic.isEmpty() ? 1 : 0;
        }
        QVERIFY2(others == 1, "exactly one format must be without magic bytes");
    }

    void recordedFilesCanBeOpened() {
        for (const FileFormat& format : fileFormats()) {
            const QString path = folder_.filePath("recorded." + format.suffixes.constFirst());
            if (format.recorder == nullptr) {
                QVERIFY(!formatForPath(path).ok());
                continue;
            }
            QVERIFY(test::writeFile(path, test::madeFile(*formatForPath(path).value(), 200)));
            expectFormat(path, format);
        }
    }

    void exportedFilesCanBeOpened() {
        const QString source = folder_.filePath("source.csv");
        QVERIFY(test::writeFile(source, test::madeFile(*csvFormat(), 200)));
        const auto recording = openRecording(source);
        QVERIFY(recording.ok());
        for (const FileFormat& format : fileFormats()) {
            for (const QString& suffix : format.suffixes) {
                ExportChoice choice;
                choice.path = folder_.filePath("exported." + suffix.toUpper());
                QVERIFY(canExportTo(choice.path));
                const auto report = exportRecording(*recording.value(), choice);
                if (TILLER_HAS_HDF5 == 0 && format.name == QLatin1String("HDF5")) {
                    const QString missing = QStringLiteral("built without libhdf5");
                    QVERIFY(report.error().toString().contains(missing));
                    QVERIFY(test::writeFile(choice.path, format.magic.toStdString()));
                    QVERIFY(openRecording(choice.path).error().toString().contains(missing));
                    continue;
                }
                QVERIFY2(report.ok(), qPrintable(choice.path));
                expectFormat(choice.path, format);
            }
        }
    }

    void otherSuffixesAreRefused() {
        QVERIFY(fileFormatOf("recording") == nullptr);
        QVERIFY(fileFormatOf("recording.csv.txt") == nullptr);
        QVERIFY(!canExportTo("recording.png"));
        QCOMPARE(suffixWords(FormatSet::Recorded), QString(".csv or .mcap"));
        QCOMPARE(suffixWords(FormatSet::All, "FILE"), QString("FILE.csv, FILE.h5 or FILE.mcap"));
    }

    void everySetHasItsFormats() {
        using Names = QStringList;
        const auto namesIn = [](FormatSet set) {
            QStringList names;
            for (const FileFormat* format : formatsIn(set)) {
                names << format->name;
            }
            return names;
        };
        QCOMPARE(namesIn(FormatSet::All), Names({"CSV", "HDF5", "MCAP"}));
        QCOMPARE(namesIn(FormatSet::Recorded), Names({"CSV", "MCAP"}));
        QCOMPARE(namesIn(FormatSet::Complete), Names({"MCAP"}));
        QCOMPARE(namesIn(FormatSet::Selected), Names({"CSV"}));
    }

    void everySuffixIsInHelpAndFileDialog() {
        QCOMPARE(suffixFilter(FormatSet::Recorded), QString("*.csv *.mcap"));
        QCOMPARE(suffixHelp(FormatSet::Recorded),
                 QString(".csv for pandas and spreadsheets, or .mcap for ROS tools"));
        for (const FileFormat& format : fileFormats()) {
            QVERIFY(!format.readers.isEmpty() && suffixHelp(FormatSet::All).contains(format.readers));
            QCOMPARE(format.label == nullptr, format.recorder == nullptr);
            for (const QString& suffix : format.suffixes) {
                QVERIFY(suffixHelp(FormatSet::All).contains(QLatin1Char('.') + suffix));
                QVERIFY(suffixFilter(FormatSet::All).contains(QStringLiteral("*.") + suffix));
            }
        }
    }

private:
    static void expectFormat(const QString& path, const FileFormat& format) {
        const auto opened = openRecording(path);
        QVERIFY2(opened.ok(), qPrintable(path));
        QCOMPARE(opened.value()->format(), format.name);
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestFileFormats)
#include "tst_file_formats.moc"
