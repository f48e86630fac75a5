// SPDX-License-Identifier: GPL-3.0-or-later
//
// File names of recordings: the pattern is expanded, and no recording overwrites another recording.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include "robot/station/link/recording_choice.h"

using namespace tiller;

namespace {

const QDateTime kNow(QDate(2024, 9, 17), QTime(14, 2, 11));

}  // namespace

class TestRecordingChoice : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;

    QString name(const QString& pattern, const QString& robot = QStringLiteral("Lab UR5e")) {
        return QFileInfo(recordingPath({.folder = folder_.path(), .pattern = pattern}, robot, kNow))
            .fileName();
    }

private Q_SLOTS:
    void aPatternIsFilledIn() {
        QCOMPARE(name("{date}_{time}"), QString("2024-09-17_14-02-11.csv"));
        QCOMPARE(name("{robot} {date}"), QString("Lab UR5e 2024-09-17.csv"));
        QCOMPARE(name("gluing"), QString("gluing.csv"));
        QCOMPARE(name(" gluing.CSV "), QString("gluing.csv"));
        // The name of a robot may contain characters that are not permitted in file names.
        QCOMPARE(name("{robot}", "../cell 7: \"left\""), QString("_.._cell 7_ _left_.csv"));
    }

    void theSuffixDeterminesTheFormat() {
        RecordingChoice choice{.folder = folder_.path(), .pattern = "weld.csv"};
        choice.format = "mcap";
        QCOMPARE(QFileInfo(recordingPath(choice, {}, kNow)).fileName(), QString("weld.mcap"));
        choice.pattern = "weld.MCAP";
        QCOMPARE(QFileInfo(recordingPath(choice, {}, kNow)).fileName(), QString("weld.mcap"));
        QCOMPARE(recordingFormat("mcap").name, QString("MCAP"));
        QCOMPARE(recordingFormat("of another time").name, QString("CSV"));
        choice.format = "h5";  // a format that the recorder cannot write
        QCOMPARE(choice.sane().format, QString("csv"));
        QCOMPARE((RecordingChoice{.keepFree = -1}.sane().keepFree), 0);
    }

    void metadataKeepsItsTemplate() {
        const RecordingChoice choice{.metadata = {"operator=Ann", "sample=", "sample=7", "model=UR5e",
                                                  "no sign", "=x", "a:b=c", "note= two words "}};
        QCOMPARE(choice.sane().metadata, (QStringList{"operator=Ann", "sample=", "note= two words "}));
        QCOMPARE(choice.facts(), (recording::Metadata{{"operator", "Ann"}, {"note", "two words"}}));
        QVERIFY(RecordingChoice().facts().empty());
        QCOMPARE(RecordingChoice().sane().metadata.size(), 3);
        QCOMPARE((RecordingChoice{.metadata = {}}.sane().metadata), QStringList());
    }

    void triggersAreChecked() {
        QCOMPARE(triggerProblem({}), QString());
        QCOMPARE(triggerProblem("norm(actual_TCP_force_0, actual_TCP_force_1) > 4 and program starts"),
                 QString());
        QVERIFY(triggerProblem("robot_mode = 7 and force > x").contains("“force > x”"));
        QVERIFY(triggerProblem("actual_TCP_force > 3").contains("actual_TCP_force”"));
        QCOMPARE(triggerFields("actual_q_0 > 1 or actual_q_5 < 3 and robot_mode = 7"),
                 (QStringList{"actual_q", "robot_mode"}));
        RecordingChoice choice{.trigger = " robot_mode  = 7", .before = -1, .after = 1e9, .fileMinutes = -1};
        QCOMPARE(choice.sane().trigger, QString("robot_mode = 7"));
        QCOMPARE(choice.sane().before, 0.0);
        QCOMPARE(choice.sane().after, RecordingChoice::kMaxAfter);
        QCOMPARE(choice.sane().fileMinutes, 0);
        choice.trigger = "nothing";
        QCOMPARE(choice.sane().trigger, QString());
    }

    void everyRecordableFormatHasADescription() {
        for (const recording::FileFormat* format : recording::formatsIn(recording::FormatSet::Recorded)) {
            const RecordingFormatWords words = recordingFormatWords(*format);
            for (const QString& text : {words.choice, words.button, words.buttonHint}) {
                QVERIFY2(text.contains(format->name) && text != format->name, qPrintable(format->name));
            }
        }
    }

    void noHiddenFileNamesAreCreated() {
        QCOMPARE(name("{robot}", ""), QString("_.csv"));
        QCOMPARE(name("{robot}", ".."), QString("_...csv"));
        QCOMPARE(name("{robot} {number}", ".cell"), QString("_.cell 001.csv"));
    }

    void existingFilesAreNotOverwritten() {
        for (const char* expected : {"gluing.csv", "gluing_2.csv", "gluing_3.csv"}) {
            QCOMPARE(name("gluing"), QString(expected));
            QFile made(folder_.filePath(expected));
            QVERIFY(made.open(QIODevice::WriteOnly));
        }
        for (const char* expected : {"run 001.csv", "run 002.csv"}) {
            QCOMPARE(name("run {number}"), QString(expected));
            QFile made(folder_.filePath(expected));
            QVERIFY(made.open(QIODevice::WriteOnly));
        }
    }

    void theFirstFreeNumberIsUsed() {
        for (const char* there : {"lot 001.csv", "LOT 002.csv", "lot 003.csv", "lot 005.csv"}) {
            QFile made(folder_.filePath(there));
            QVERIFY(made.open(QIODevice::WriteOnly));
        }
        // A dangling link also reserves its name.
        QVERIFY(QFile::link(folder_.filePath("no such file"), folder_.filePath("lot 004.csv")));
        QCOMPARE(name("lot {number}"), QString("lot 006.csv"));
    }

    void invalidFileNamesAreReported_data() {
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<bool>("good");
        QTest::newRow("usual") << QString("{date}_{time}") << true;
        QTest::newRow("words") << QString("gluing on line 2") << true;
        QTest::newRow("empty") << QString("  ") << false;
        QTest::newRow("ending only") << QString(".csv") << false;
        QTest::newRow("hidden") << QString(".gluing") << false;
        QTest::newRow("folder") << QString("a/b") << false;
        QTest::newRow("backslash") << QString("a\\b") << false;
        QTest::newRow("too long") << QString(200, 'x') << false;
    }
    void invalidFileNamesAreReported() {
        QFETCH(QString, pattern);
        QFETCH(bool, good);
        QCOMPARE(patternProblem(pattern).isEmpty(), good);
        const RecordingChoice choice = RecordingChoice{.pattern = pattern}.sane();
        QCOMPARE(choice.pattern, good ? pattern : RecordingChoice::defaultPattern());
    }

    void invalidValuesAreCorrected() {
        const QStringList all = recordableFields();
        QVERIFY(all.contains("actual_q") && !all.contains("timestamp"));
        const RecordingChoice choice =
            RecordingChoice{.fields = {"actual_q", "no_such_field", "actual_q"}, .every = -3}.sane();
        QCOMPARE(choice.fields, QStringList("actual_q"));
        QCOMPARE(choice.every, 1);
        QCOMPARE((RecordingChoice{.every = 100'000}.sane().every), RecordingChoice::kMaxDecimation);
        QVERIFY2(RecordingChoice{.fields = all}.sane().fields.isEmpty(),
                 "a selection of all fields is stored as a list");
        QVERIFY(!recordingFolder().isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestRecordingChoice)
#include "tst_recording_choice.moc"
