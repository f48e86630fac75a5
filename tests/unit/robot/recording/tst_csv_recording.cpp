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
    void oursIsReadWithUnitsAndGaps();
    void semicolonsAndDecimalCommas();
    void aLineOfUnits();
    void unitsInTheHeading();
    void aClockThatStartsAnewGoesOn();
    void whatIsNoNumberIsSaid();
    void linesOfAnotherLengthAreLeftOutAndSaid();
    void aLastLineWithoutEndIsSaid();
    void whatIsNoTableSaysSo();
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

void TestCsvRecording::oursIsReadWithUnitsAndGaps() {
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

void TestCsvRecording::semicolonsAndDecimalCommas() {
    const auto recording = open("Time;Force\n0,000;1,5\n0,010;-2,5e-1\n0,020;\n").value();
    QCOMPARE(column(*recording, "Force")[1], -0.25);
    QVERIFY(std::isnan(column(*recording, "Force")[2]));
    QCOMPARE(recording->times({2, 1}).value().front(), 0.02);
}

void TestCsvRecording::aLineOfUnits() {
    const auto recording = open("timestamp,Force\ns,N\n0,1\n0.1,2\n").value();
    QCOMPARE(recording->columns()[1].unit, std::string("N"));
    QCOMPARE(recording->rows(), std::uint64_t(2));
    QVERIFY(recording->problems().isEmpty());
}

void TestCsvRecording::unitsInTheHeading() {
    const auto recording = open(
                               "\xEF\xBB\xBF"
                               "# t [s]\t\"a; b [mm]\"\n0\t1\n")
                               .value();
    QCOMPARE(recording->columns()[1].name, std::string("a; b"));
    QCOMPARE(recording->columns()[1].unit, std::string("mm"));
}

void TestCsvRecording::aClockThatStartsAnewGoesOn() {
    const auto recording = open("timestamp,a\n100,1\n100.5,2\n101,3\n0,4\n0.5,5\n").value();
    QCOMPARE(recording->times({0, 5}).value(), (std::vector<double>{0, 0.5, 1, 1.5, 2}));
}

void TestCsvRecording::whatIsNoNumberIsSaid() {
    const auto recording = open("timestamp,a\n0,1\n1,abc\n2,def\n3,True\n").value();
    QCOMPARE(recording->rows(), std::uint64_t(4));
    QVERIFY(std::isnan(column(*recording, "a")[1]));
    QCOMPARE(column(*recording, "a")[3], 1.0);
    QVERIFY(recording->problems().join(' ').contains("2 cells are not numbers"));
}

void TestCsvRecording::linesOfAnotherLengthAreLeftOutAndSaid() {
    std::string text = "timestamp,a\n0,1\n";
    for (int i = 0; i < 50; ++i) {
        text += "1\n";
    }
    const auto recording = open(text + "2,3\n").value();
    QCOMPARE(recording->rows(), std::uint64_t(2));
    QVERIFY(recording->problems().front().contains("Line 3"));
    QVERIFY(recording->problems().last().contains("30 more"));
}

void TestCsvRecording::aLastLineWithoutEndIsSaid() {
    const auto recording = open("timestamp,a\n0,1\n1,2").value();
    QCOMPARE(recording->rows(), std::uint64_t(2));
    QCOMPARE(recording->problems().size(), 1);
}

void TestCsvRecording::whatIsNoTableSaysSo() {
    QCOMPARE(open("").error().code, ErrorCode::FileCorrupt);
    QCOMPARE(open(std::string("\x89PNG\r\n\x1a\n\0\0", 10)).error().code, ErrorCode::FileCorrupt);
    QCOMPARE(open("hello\nworld\nthis is text\n").error().code, ErrorCode::FileCorrupt);
    QCOMPARE(openCsv(folder_.filePath("none.csv")).error().code, ErrorCode::FileNotReadable);
    QCOMPARE(openCsv(folder_.path()).error().code, ErrorCode::FileNotReadable);
    QVERIFY(open("timestamp,a\n").ok());  // a recording that had just begun
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
