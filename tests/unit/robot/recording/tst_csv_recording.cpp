// SPDX-License-Identifier: MIT
#include <QTemporaryDir>
#include <QTest>
#include <random>

#include "robot/recording/csv_recording.h"
#include "tests/unit/robot/recording/made_recording.h"

using namespace tiller;
using namespace tiller::recording;

class TestCsvRecording : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void ownFilesAreReadWithUnitsAndGaps();
    void semicolonsAndDecimalCommasAreRead();
    void blankSeparatedCellsAreRead_data();
    void blankSeparatedCellsAreRead();
    void aBlankInASingleHeadingIsNotASeparator();
    void aLineOfUnitsIsRead();
    void unitsInTheHeadingAreRead();
    void timeContinuesAfterAClockRestart();
    void unsortedTablesHaveFewRestarts();
    void nonNumericCellsAreReported();
    void linesWithAWrongCellCountAreSkippedAndReported();
    void unterminatedLastLineIsReported();
    void nonTableFilesAreReported();
    void summariesKeepSpikes();
    void thousandMutationsDoNoHarm();

private:
    Result<std::unique_ptr<Recording>> open(const std::string& text) {
        test::writeFile(path_, text);
        return openCsv(path_);
    }
    QTemporaryDir folder_;
    QString path_ = folder_.filePath("a.csv");
};

namespace {

std::vector<double> column(const Recording& recording, const char* name) {
    return recording.read(std::vector{recording.indexOf(name).value()}, {0, recording.rows()})
        .value()
        .front();
}

}  // namespace

void TestCsvRecording::ownFilesAreReadWithUnitsAndGaps() {
    const auto recording = open(test::madeFile(*csvFormat(), 1000, 600)).value();
    QVERIFY(recording->problems().isEmpty());
    QCOMPARE(recording->rows(), std::uint64_t(1000));
    QCOMPARE(recording->columns()[*recording->indexOf("actual_q_2")].unit, std::string("rad"));
    QVERIFY(recording->columns()[*recording->indexOf("robot_mode")].whole);
    QCOMPARE(recording->gaps().size(), std::size_t(1));
    QCOMPARE(recording->gaps().front().row, std::uint64_t(600));
    QVERIFY(std::abs(recording->period() - 0.002) < 1e-9);
    QCOMPARE(recording->rowAt(1.0).value(), std::uint64_t(500));
}

void TestCsvRecording::semicolonsAndDecimalCommasAreRead() {
    const auto recording = open("Time;Force\n0,000;1,5\n0,010;-2,5e-1\n0,020;\n").value();
    QCOMPARE(column(*recording, "Force")[1], -0.25);
    QVERIFY(std::isnan(column(*recording, "Force")[2]));
    QCOMPARE(recording->times({2, 1}).value().front(), 0.02);
}

void TestCsvRecording::blankSeparatedCellsAreRead_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("one blank") << QByteArray(
        "timestamp actual_q_0 actual_q_1\n0.000 1.5 -0.2\n0.008 1.6 -0.3\n0.016 1.7 -0.4\n");
    QTest::newRow("aligned") << QByteArray(
        "  timestamp   actual_q_0  actual_q_1 \n      0.000          1.5        -0.2\n      0.008          "
        "1.6  "
        "      -0.3\n      0.016          1.7        -0.4\n");
    QTest::newRow("comment sign and units") << QByteArray(
        "# timestamp [s] actual_q_0 [rad] actual_q_1 [rad]\n0.000 1.5 -0.2\n0.008 1.6 -0.3\n0.016 1.7 "
        "-0.4\n");
    QTest::newRow("Windows") << QByteArray(
        "timestamp actual_q_0 actual_q_1\r\n0.000 1.5 -0.2 \r\n0.008 1.6 -0.3 \r\n0.016 1.7 -0.4 \r\n");
    QTest::newRow("vertical bars") << QByteArray(
        "timestamp | actual_q_0 | actual_q_1\n0.000 | 1.5 | -0.2\n0.008 | 1.6 | -0.3\n0.016 | 1.7 | -0.4\n");
}

void TestCsvRecording::blankSeparatedCellsAreRead() {
    QFETCH(QByteArray, text);
    const auto opened = open(text.toStdString());
    QVERIFY2(opened.ok(), opened.ok() ? "" : qPrintable(opened.error().toString()));
    const Recording& recording = **opened;
    QCOMPARE(recording.rows(), std::uint64_t(3));
    QCOMPARE(recording.columns().size(), std::size_t(3));
    QVERIFY(recording.problems().isEmpty());
    QCOMPARE(column(recording, "actual_q_1"), (std::vector{-0.2, -0.3, -0.4}));
    QCOMPARE(recording.columns()[*recording.indexOf("actual_q_0")].unit, std::string("rad"));
}

void TestCsvRecording::aBlankInASingleHeadingIsNotASeparator() {
    const auto recording = open("Tool force [N]\n1.5\n2.5\n").value();
    QCOMPARE(recording->columns().size(), std::size_t(1));
    QCOMPARE(recording->columns()[0].name, std::string("Tool force"));
    QCOMPARE(recording->rows(), std::uint64_t(2));
}

void TestCsvRecording::aLineOfUnitsIsRead() {
    const auto recording = open("timestamp,Force\ns,N\n0,1\n0.1,2\n").value();
    QCOMPARE(recording->columns()[1].unit, std::string("N"));
    QCOMPARE(recording->rows(), std::uint64_t(2));
    QVERIFY(recording->problems().isEmpty());
}

void TestCsvRecording::unitsInTheHeadingAreRead() {
    const auto recording = open(
                               "\xEF\xBB\xBF"
                               "# t [s]\t\"a; b [mm]\"\n0\t1\n")
                               .value();
    QCOMPARE(recording->columns()[1].name, std::string("a; b"));
    QCOMPARE(recording->columns()[1].unit, std::string("mm"));
}

void TestCsvRecording::timeContinuesAfterAClockRestart() {
    const auto recording = open("timestamp,a\n100,1\n100.5,2\n101,3\n0,4\n0.5,5\n").value();
    QCOMPARE(recording->times({0, 5}).value(), (std::vector<double>{0, 0.5, 1, 1.5, 2}));
}

void TestCsvRecording::unsortedTablesHaveFewRestarts() {
    const auto rows = [](const std::string& time) {
        std::string text = time + ",value\n";
        for (int i = 0; i < 2000; ++i) {
            text += std::to_string(i % 2 == 0 ? 1000 + i : i) + ",1\n";
        }
        return text;
    };
    QVERIFY(open(rows("time")).value()->events().empty());
    QVERIFY(open(rows("timestamp")).value()->events().size() <= 100);
}

void TestCsvRecording::nonNumericCellsAreReported() {
    const auto recording = open("timestamp,a\n0,1\n1,abc\n2,def\n3,True\n").value();
    QCOMPARE(recording->rows(), std::uint64_t(4));
    QVERIFY(std::isnan(column(*recording, "a")[1]));
    QCOMPARE(column(*recording, "a")[3], 1.0);
    QVERIFY(recording->problems().join(' ').contains("2 cells are not numbers"));
}

void TestCsvRecording::linesWithAWrongCellCountAreSkippedAndReported() {
    std::string text = "timestamp,a\n0,1\n";
    for (int i = 0; i < 50; ++i) {
        text += "1\n";
    }
    const auto recording = open(text + "2,3\n").value();
    QCOMPARE(recording->rows(), std::uint64_t(2));
    QVERIFY(recording->problems().front().contains("Line 3"));
    QVERIFY(recording->problems().last().contains("30 more"));
}

void TestCsvRecording::unterminatedLastLineIsReported() {
    const auto recording = open("timestamp,a\n0,1\n1,2").value();
    QCOMPARE(recording->rows(), std::uint64_t(2));
    QCOMPARE(recording->problems().size(), 1);
}

void TestCsvRecording::nonTableFilesAreReported() {
    QCOMPARE(open("").error().code, ErrorCode::FileCorrupt);
    QCOMPARE(open(std::string("\x89PNG\r\n\x1a\n\0\0", 10)).error().code, ErrorCode::FileCorrupt);
    QCOMPARE(open("hello\nworld\nthis is text\n").error().code, ErrorCode::FileCorrupt);
    QCOMPARE(openCsv(folder_.filePath("none.csv")).error().code, ErrorCode::FileNotReadable);
    QCOMPARE(openCsv(folder_.path()).error().code, ErrorCode::FileNotReadable);
    QVERIFY(open("timestamp,a\n").ok());  // a recording that has just started
}

void TestCsvRecording::summariesKeepSpikes() {
    std::string text = "timestamp,a\n";
    for (int i = 0; i < 1000; ++i) {
        text += std::to_string(i) + (i == 777 ? ",50\n" : ",1\n");
    }
    const auto recording = open(text).value();
    const auto summary = recording->summaries(std::vector<std::size_t>{1}, {0, 1000}, 10).value().front();
    QCOMPARE(summary.rowsEach, std::uint64_t(100));
    QCOMPARE(summary.max[7], 50.0);
    QCOMPARE(summary.max[6], 1.0);
    QCOMPARE(summary.mean[7], 1.49);
}

void TestCsvRecording::thousandMutationsDoNoHarm() {
    const std::string whole = test::madeFile(*csvFormat(), 20);
    std::mt19937 random(11);
    for (int i = 0; i < 1000; ++i) {
        std::string text = whole;
        for (unsigned change = 0; change < 1 + random() % 6; ++change) {
            const std::size_t at = random() % text.size();
            if (random() % 2 == 0) {
                text[at] = static_cast<char>(random());
            } else {
                text.erase(at, random() % 200);
            }
        }
        if (const auto recording = open(text)) {
            QVERIFY((*recording)->rows() <= 40);
            QVERIFY((*recording)->times({0, 40}).ok());
        }
    }
}

QTEST_GUILESS_MAIN(TestCsvRecording)
#include "tst_csv_recording.moc"
