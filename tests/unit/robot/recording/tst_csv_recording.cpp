// SPDX-License-Identifier: MIT
#include <QTemporaryDir>
#include <QTest>
#include <random>

#include "robot/recording/csv_reader.h"
#include "robot/recording/csv_recording.h"
#include "robot/recording/export.h"
#include "tests/unit/robot/recording/made_recording.h"

using namespace tiller;
using namespace tiller::recording;

Q_DECLARE_METATYPE(tiller::recording::TableFormat)

class TestCsvRecording : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void ownFilesAreReadWithUnitsAndGaps();
    void semicolonsAndDecimalCommasAreRead();
    void headingsInLatin1AreRead();
    void blankSeparatedCellsAreRead_data();
    void blankSeparatedCellsAreRead();
    void aBlankInASingleHeadingIsNotASeparator();
    void aLineOfUnitsIsRead();
    void unitsInTheHeadingAreRead();
    void foreignTablesAreRead_data();
    void foreignTablesAreRead();
    void undecidedTablesAreRefused_data();
    void undecidedTablesAreRefused();
    void tableFormatsDecide_data();
    void tableFormatsDecide();
    void stepsBackBeginASegment();
    void datesGiveTheStart();
    void timeContinuesAfterAClockRestart();
    void unsortedTablesHaveFewRestarts();
    void nonNumericCellsAreReported();
    void linesWithAWrongCellCountAreSkippedAndReported();
    void unterminatedLastLineIsReported();
    void nonTableFilesAreReported();
    void summariesKeepSpikes();
    void metadataIsAboveTheHeader();
    void metadataIsExported();
    void entriesOfMetadataAreChecked_data();
    void entriesOfMetadataAreChecked();
    void thousandMutationsDoNoHarm();

private:
    Result<std::unique_ptr<Recording>> open(const std::string& text, const TableFormat& format = {}) {
        test::writeFile(path_, text);
        return openCsv(path_, format);
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

void TestCsvRecording::headingsInLatin1AreRead() {
    const auto recording = open("Zeit [s];\xD6l-Druck [\xB5m];\xC3\x96l [°C]\n0,0;1;2\n0,1;3;4\n").value();
    QCOMPARE(recording->columns()[1].name, std::string("Öl-Druck"));
    QCOMPARE(recording->columns()[1].unit, std::string("µm"));
    QCOMPARE(recording->columns()[2].name, std::string("Öl"));
    QCOMPARE(recording->columns()[2].unit, std::string("°C"));
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
    const auto recording = open("Tool force [N]\n1.5\n2.5\n", {.rate = 500}).value();
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

// Each file has three rows that are 10 ms apart, with the forces 1.5, -2.5 and 3.5 in the last column.
void TestCsvRecording::foreignTablesAreRead_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("time");
    const auto row = [](const char* name, const QString& time, const QByteArray& text) {
        QTest::newRow(name) << text << time;
    };
    row("PlotJuggler", "__time",
        "__time,/joint/header/stamp,/ft/force/z\n1716969600.10,7,1.5\n1716969600.11,8,-2.5\n"
        "1716969600.12,9,3.5\n");
    row("rostopic", "%time",
        "%time,field.header.stamp,field.force\n1716969600100000000,1716969600000000000,1.5\n"
        "1716969600110000000,1716969600000000000,-2.5\n1716969600120000000,1716969600000000000,3.5\n");
    row("Unix milliseconds", "timestamp",
        "timestamp,F\n1716969600100,1.5\n1716969600110,-2.5\n1716969600120,3.5\n");
    row("Unix microseconds", "ts",
        "ts,F\n1716969600100000,1.5\n1716969600110000,-2.5\n1716969600120000,3.5\n");
    row("pandas dates", "time",
        "time,F\n2024-05-29 08:00:00.100000,1.5\n2024-05-29 08:00:00.110000,-2.5\n"
        "2024-05-29 08:00:00.120000,3.5\n");
    row("pandas dates in an unnamed index", "column 1",
        ",F\n2024-05-29 08:00:00.10,1.5\n2024-05-29 08:00:00.11,-2.5\n2024-05-29 08:00:00.12,3.5\n");
    row("ISO 8601 with zone", "stamp",
        "stamp;F\n2024-05-29T23:59:59.99+02:00;1,5\n2024-05-30T00:00:00,00+02:00;-2,5\n"
        "2024-05-29T22:00:00.01Z;3,5\n");
    row("milliseconds", "time_ms", "time_ms,F\n5000,1.5\n5010,-2.5\n5020,3.5\n");
    row("microseconds", "elapsed (us)", "elapsed (us),F\n5000,1.5\n15000,-2.5\n25000,3.5\n");
    row("a unit after a slash", "t / ms", "t / ms,F / N\n5000,1.5\n5010,-2.5\n5020,3.5\n");
    row("a line of units", "t", "t,F\nms,N\n5000,1.5\n5010,-2.5\n5020,3.5\n");
    row("seconds and nanoseconds", "stamp.sec",
        "stamp.sec,stamp.nanosec,F\n41,990000000,1.5\n42,0,-2.5\n42,10000000,3.5\n");
    row("German Excel", "Zeit",
        "\xEF\xBB\xBFsep=;\r\nZeit [s];Kraft [N]\r\n0,00;1,5\r\n0,01;-2,5\r\n0,02;3,5\r\n");
    row("numpy", "t", "# written by savetxt\n# t F\n0.00e+00 1.5e+00\n1.00e-02 -2.5e+00\n2.00e-02 3.5e+00\n");
    row("Octave", "time", "% a comment\ntime  F\n 0.00   1.5\n 0.01  -2.5\n# in between\n 0.02   3.5\n");
    row("a comment above the header", "elapsed",
        "# sensor 7, calibrated\n#\nelapsed\tF\n0.00\t1.5\n0.01\t-2.5\n0.02\t3.5\n");
    row("dates without header", "column 1",
        "2024-05-29T08:00:00.10Z,1.5\n2024-05-29T08:00:00.11Z,-2.5\n2024-05-29T08:00:00.12Z,3.5\n");
}

void TestCsvRecording::foreignTablesAreRead() {
    QFETCH(QByteArray, text);
    QFETCH(QString, time);
    const auto opened = open(text.toStdString());
    QVERIFY2(opened.ok(), opened.ok() ? "" : qPrintable(opened.error().toString()));
    const Recording& recording = **opened;
    QVERIFY2(recording.problems().isEmpty(), qPrintable(recording.problems().join(' ')));
    QVERIFY(recording.timeColumn());
    QCOMPARE(recording.columns()[*recording.timeColumn()].name, time.toStdString());
    QCOMPARE(recording.rows(), std::uint64_t(3));
    QCOMPARE(recording.read(std::vector{recording.columns().size() - 1}, {0, 3}).value().front(),
             (std::vector{1.5, -2.5, 3.5}));
    const std::vector<double> times = recording.times({0, 3}).value();
    for (std::size_t i = 0; i < times.size(); ++i) {
        QVERIFY2(std::abs(times[i] - 0.01 * static_cast<double>(i)) < 1e-6,
                 qPrintable(QString::number(times[i])));
    }
    QVERIFY(std::abs(recording.period() - 0.01) < 1e-6);
    QVERIFY(recording.events().empty());
}

void TestCsvRecording::undecidedTablesAreRefused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("words");  // parts of the message
    const auto row = [](const char* name, const char* text, const char* words) {
        QTest::newRow(name) << QByteArray(text) << QString(words);
    };
    row("no time column", "F,x\n1.5,2\n2.5,3\n", "\"F\", \"x\"|time-column NAME|table-rate");
    row("no header", "0.1,1.5\n0.2,2.5\n", "\"column 1\", \"column 2\"|time-column");
    row("an unnamed index", ",F\n0,1.5\n1,2.5\n", "\"column 1\", \"F\"|time-column");
    row("integers without a unit", "time,F\n0,1.5\n2,2.5\n4,3.5\n", "\"time\"|0, 2, 4|time-unit");
    row("time since the start of a device", "timestamp,F\n5023,1.5\n5033,2.5\n", "\"timestamp\"|time-unit");
    row("nanoseconds that could be Unix milliseconds", "t,F\n1000000000000,1\n1000002000000,2\n",
        "time-unit");
    row("another unit", "Zeit [min],F\n0.5,1.5\n0.6,2.5\n", "\"min\"|time-unit");
    row("two time columns", "time,elapsed,F\n0.1,0.2,1\n0.2,0.4,2\n", "\"time\", \"elapsed\"|time-column");
    row("times of day", "time,F\n08:00:01,1\n08:00:02,2\n", "\"time\"|time-column");
    row("a comma without header", "0,5\n1,5\n2,5\n", "0,5|table-separator|table-decimal");
}

void TestCsvRecording::undecidedTablesAreRefused() {
    QFETCH(QByteArray, text);
    QFETCH(QString, words);
    const auto opened = open(text.toStdString());
    QVERIFY(!opened.ok());
    QCOMPARE(opened.error().code, ErrorCode::InvalidArgument);
    for (const QString& word : words.split(QLatin1Char('|'))) {
        QVERIFY2(opened.error().controllerMessage.contains(word), qPrintable(opened.error().toString()));
    }
}

void TestCsvRecording::tableFormatsDecide_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<TableFormat>("format");
    QTest::addColumn<std::vector<double>>("times");  // empty: an error
    QTest::addColumn<std::vector<double>>("last");   // the last column
    const auto row = [](const char* name, const char* text, const TableFormat& format,
                        std::vector<double> times, std::vector<double> last) {
        QTest::newRow(name) << QByteArray(text) << format << std::move(times) << std::move(last);
    };
    row("rate", "F\n1.5\n2.5\n", {.rate = 4}, {0, 0.25}, {1.5, 2.5});
    row("no time column", "time,F\n9,1.5\n7,2.5\n", {.timeColumn = "", .rate = 4}, {0, 0.25}, {1.5, 2.5});
    row("no time column and no rate", "F\n1.5\n2.5\n", {.timeColumn = ""}, {}, {});
    row("rate and time column", "time [s],F\n0,1.5\n1,2.5\n", {.rate = 4}, {}, {});
    row("time column", "F,x\n1.5,0.5\n2.5,0.75\n", {.timeColumn = "x"}, {0, 0.25}, {0.5, 0.75});
    row("missing time column", "F,x\n1.5,0.5\n2.5,0.75\n", {.timeColumn = "y"}, {}, {});
    row("unit", "time,F\n0,1.5\n2,2.5\n", {.timeUnit = TimeUnit::Milliseconds}, {0, 0.002}, {1.5, 2.5});
    row("unit of a heading is replaced", "time [s],F\n0,1.5\n2,2.5\n", {.timeUnit = TimeUnit::Microseconds},
        {0, 2e-6}, {1.5, 2.5});
    row("no header", "1,2\n3,4\n5,6\n", {.separator = ',', .hasHeader = false, .rate = 1}, {0, 1, 2},
        {2, 4, 6});
    row("decimal comma", "0,5\n1,5\n", {.decimal = ',', .rate = 1}, {0, 1}, {0.5, 1.5});
    row("header of numbers", "1;2\n3;4\n", {.hasHeader = true, .rate = 1}, {0}, {4});
}

void TestCsvRecording::tableFormatsDecide() {
    QFETCH(QByteArray, text);
    QFETCH(TableFormat, format);
    QFETCH(std::vector<double>, times);
    QFETCH(std::vector<double>, last);
    const auto opened = open(text.toStdString(), format);
    if (times.empty()) {
        QVERIFY(!opened.ok());
        QCOMPARE(opened.error().code, ErrorCode::InvalidArgument);
        return;
    }
    QVERIFY2(opened.ok(), opened.ok() ? "" : qPrintable(opened.error().toString()));
    const Recording& recording = **opened;
    QCOMPARE(recording.times({0, recording.rows()}).value(), times);
    QCOMPARE(
        recording.read(std::vector{recording.columns().size() - 1}, {0, recording.rows()}).value().front(),
        last);
}

void TestCsvRecording::stepsBackBeginASegment() {
    const auto recording = open("t [ms],a\n100,1\n110,2\n120,3\n50,4\n60,5\n").value();
    QCOMPARE(recording->times({0, 5}).value(), (std::vector<double>{0, 0.01, 0.02, 0.03, 0.04}));
    QCOMPARE(recording->events().size(), std::size_t(1));
    QVERIFY(recording->events().front().text.contains("0.120 s to 0.050 s"));
    QCOMPARE(recording->gaps().size(), std::size_t(1));
    QCOMPARE(recording->gaps().front().row, std::uint64_t(3));
}

void TestCsvRecording::datesGiveTheStart() {
    constexpr std::int64_t kStart = 1'716'969'600'500'000'000;
    for (const char* rows : {"2024-05-29T08:00:00.5Z,1\n2024-05-29T08:00:01Z,2\n",
                             "2024-05-29T10:00:00.5+0200,1\n2024-05-29T10:00:01+0200,2\n",
                             "1716969600500,1\n1716969601000,2\n"}) {
        const auto recording = open(std::string("time,a\n") + rows).value();
        QCOMPARE(recording->startUtcNs(), std::optional(kStart));
        QCOMPARE(recording->times({1, 1}).value().front(), 0.5);
    }
    QVERIFY(!open("time,a\n2024-05-29T08:00:00,1\n2024-05-29T08:00:01,2\n").value()->startUtcNs());
    // The first number with a decimal separator selects the separator: with a comma, 1.234 is not a number.
    const auto mixed = open("t;a\n0,25;1.234\n0,50;1,5\n").value();
    QVERIFY(mixed->problems().join(' ').contains("1 cells are not numbers"));
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
    for (const char* time : {"time [s]", "timestamp [s]"}) {
        const std::size_t events = open(rows(time)).value()->events().size();
        QVERIFY(events > 0 && events <= 100);
    }
}

void TestCsvRecording::nonNumericCellsAreReported() {
    const auto recording = open("timestamp [s],a\n0,1\n1,abc\n2,def\n3,True\n").value();
    QCOMPARE(recording->rows(), std::uint64_t(4));
    QVERIFY(std::isnan(column(*recording, "a")[1]));
    QCOMPARE(column(*recording, "a")[3], 1.0);
    QVERIFY(recording->problems().join(' ').contains("2 cells are not numbers"));
}

void TestCsvRecording::linesWithAWrongCellCountAreSkippedAndReported() {
    std::string text = "timestamp [s],a\n0,1\n";
    for (int i = 0; i < 50; ++i) {
        text += "1\n";
    }
    const auto recording = open(text + "2,3\n").value();
    QCOMPARE(recording->rows(), std::uint64_t(2));
    QVERIFY(recording->problems().front().contains("Line 3"));
    QVERIFY(recording->problems().last().contains("30 more"));
}

void TestCsvRecording::unterminatedLastLineIsReported() {
    const auto recording = open("timestamp [s],a\n0,1\n1,2").value();
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
    std::string text = "timestamp [s],a\n";
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

void TestCsvRecording::metadataIsAboveTheHeader() {
    const auto format = csvFormat({{"operator", "Änne"}, {"sample no", "a: \"7\", b\nc"}});
    const std::string text = test::madeFile(*format, 20);
    const std::string expected =
        "# start: 2026-01-01T00:00:00.000000000Z\n# operator: Änne\n# sample no: a: \"7\", b c\n# units: "
        "s,rad,";
    QCOMPARE(text.substr(0, expected.size()), expected);
    const auto recording = open(text).value();
    QVERIFY2(recording->problems().isEmpty(), qPrintable(recording->problems().join(' ')));
    QCOMPARE(recording->rows(), std::uint64_t(20));
    QCOMPARE(recording->startUtcNs(), std::optional(test::kMadeStartNs));
    QCOMPARE(recording->facts(), (Metadata{{"operator", "Änne"}, {"sample no", "a: \"7\", b c"}}));
    const auto plain = open(test::madeFile(*csvFormat(), 20)).value();
    QVERIFY(plain->facts().empty());
    QVERIFY(!plain->startUtcNs());
    QCOMPARE(recording->columns().size(), plain->columns().size());
    for (std::size_t i = 0; i < plain->columns().size(); ++i) {
        QCOMPARE(recording->columns()[i].name, plain->columns()[i].name);
        QCOMPARE(recording->columns()[i].unit, plain->columns()[i].unit);
    }
    test::writeFile(path_, text);
    QCOMPARE(readCsv(path_).value().rows(), std::size_t(20));

    // A part without the header that was written incompletely. Only its complete rows are kept.
    test::MadeSamples samples;
    const auto encoder = format->encoder({samples.layout, {"actual_q"}, false});
    QVERIFY(encoder->take(RecordingEncoder::Close::WhenDue).bytes.empty());
    encoder->add(samples.at(0), 0, samples.utcNs(0));
    encoder->add(samples.at(1), 0, samples.utcNs(1));
    const std::string part = encoder->take(RecordingEncoder::Close::WhenDue).bytes;
    std::uint64_t rows = 0;
    QCOMPARE(encoder->keepOf(std::string_view(part).substr(0, part.size() - 3), rows),
             part.rfind('\n', part.size() - 2) + 1);
    QCOMPARE(rows, std::uint64_t(1));
    // A recording without rows is also complete.
    const auto empty = format->encoder({samples.layout, {"actual_q"}, false});
    QVERIFY(empty->take(RecordingEncoder::Close::Last).bytes.ends_with("packages_lost\n"));
}

void TestCsvRecording::metadataIsExported() {
    const auto source =
        open(
            "# start: 2026-11-27T14:00:00.000000250Z\n# sample: 7\n# units: ms;mm;-\n# a remark\n"
            "stamp;height;count\n0;1,5;1\n10;2,5;2\n20;3,5;3\n")
            .value();
    QCOMPARE(source->columns()[1].unit, std::string("mm"));
    QCOMPARE(source->columns()[2].unit, std::string());
    QCOMPARE(source->facts(), (Metadata{{"sample", "7"}}));
    QTemporaryDir folder;
    const QString path = folder.filePath("part.csv");
    exportCsv(*source, {.path = path, .from = 0.01}, {.separator = ';', .decimal = ',', .head = true})
        .value();
    const auto back = openCsv(path).value();
    QCOMPARE(back->rows(), std::uint64_t(2));
    QCOMPARE(*back->startUtcNs(), *source->startUtcNs() + 10'000'000);
    QCOMPARE(*source->startUtcNs() % 1000, std::int64_t(250));
    QCOMPARE(back->facts(), source->facts());
    for (std::size_t i = 0; i < 3; ++i) {
        QCOMPARE(back->columns()[i].unit, source->columns()[i].unit);
    }
    QCOMPARE(column(*back, "height"), (std::vector{2.5, 3.5}));
}

void TestCsvRecording::entriesOfMetadataAreChecked_data() {
    QTest::addColumn<QString>("entry");
    QTest::addColumn<bool>("isValid");
    for (const char* entry :
         {"operator=Ann", "sample no: 7", "formula=a=b", "url = http://x", "Prüfer=Änne"}) {
        QTest::newRow(entry) << QString(entry) << true;
    }
    for (const char* entry : {"", "operator", "operator=", "=Ann", "a\"b=c", "robot=other", "units=mm",
                              "start: now", "incident=x", "a=b\nc", "# x=1"}) {
        QTest::newRow(entry) << QString(entry) << false;
    }
    QTest::newRow("long value") << "a=" + QString(10'001, 'x') << false;
    QTest::newRow("long name") << QString(61, 'x') + "=1" << false;
}

void TestCsvRecording::entriesOfMetadataAreChecked() {
    QFETCH(QString, entry);
    QFETCH(bool, isValid);
    Metadata metadata;
    const auto added = addMetadata(metadata, entry);
    QCOMPARE(added.ok(), isValid);
    QCOMPARE(metadata.size(), std::size_t(isValid ? 1 : 0));
    if (!isValid) {
        QCOMPARE(added.error().code, ErrorCode::InvalidArgument);
    }
}

void TestCsvRecording::thousandMutationsDoNoHarm() {
    const std::string whole = test::madeFile(*csvFormat({{"operator", "Ann"}}), 20);
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
