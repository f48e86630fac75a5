// SPDX-License-Identifier: MIT
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <clocale>
#include <cmath>
#include <limits>

#include "robot/receive/sample.h"
#include "robot/recording/csv_reader.h"
#include "robot/recording/detail/csv_writer.h"
#include "robot/recording/recorder.h"

using namespace tiller;
using namespace tiller::recording;

namespace {

QString write(const QTemporaryDir& folder, const QByteArray& content) {
    const QString path = folder.filePath(QStringLiteral("file.csv"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) {
        qFatal("cannot write the test's own file");
    }
    return path;
}

receive::Sample sampleOf(const std::shared_ptr<const receive::SampleLayout>& layout) {
    receive::Sample sample(layout);
    sample.sequence = 1;
    return sample;
}

}  // namespace

class TestCsv : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void columnsAreNamedAsInRecordings();
    void onlyTheRequestedColumnsAreWritten();
    void numbersRoundTripExactly();
    void absentValuesAreEmptyCells();
    void commaLocalesChangeNothing();
    void defaultFieldsAreInTheDefaultRecipe();
    void readsFilesOfOtherPrograms();
    void anUnterminatedLineIsSkipped();
    void corruptFilesAreExplained_data();
    void corruptFilesAreExplained();
    void missingFileIsAnError();
};

void TestCsv::columnsAreNamedAsInRecordings() {
    const receive::SampleLayout layout({"actual_q", "timestamp", "robot_mode"});
    // The timestamp is always the first column. Fields that the receiver does not deliver are omitted.
    const CsvWriter writer(layout, {"robot_mode", "actual_q", "ft_raw_wrench", "timestamp", "robot_mode"});
    QCOMPARE(
        QByteArray::fromStdString(writer.header()),
        QByteArray("timestamp,robot_mode,actual_q_0,actual_q_1,actual_q_2,actual_q_3,actual_q_4,actual_q_5,"
                   "packages_lost\n"));
    QCOMPARE(writer.columns(), std::size_t(8));
}

void TestCsv::onlyTheRequestedColumnsAreWritten() {
    const auto layout = std::make_shared<receive::SampleLayout>(
        std::vector<std::string>{"timestamp", "robot_mode", "actual_q"});
    const CsvWriter writer(*layout, {"robot_mode", "timestamp"}, true);
    receive::Sample sample = sampleOf(layout);
    sample.values = {1.5, 7, 1, 2, 3, 4, 5, 6};
    std::string text = writer.header();
    writer.append(text, sample, 17);
    QCOMPARE(text, std::string("robot_mode,timestamp\n7,1.5\n"));
    QCOMPARE(CsvWriter(*layout, {"ft_raw_wrench"}, true).columns(), std::size_t(0));
}

void TestCsv::numbersRoundTripExactly() {
    const auto layout =
        std::make_shared<receive::SampleLayout>(std::vector<std::string>{"timestamp", "actual_q"});
    const CsvWriter writer(*layout, {"timestamp", "actual_q"});
    receive::Sample sample = sampleOf(layout);
    sample.values = {0.1 + 0.2, 1.0 / 3, -1e-300, 123456789.123456789, 5e-324, 1e22, -0.0};
    std::string text = writer.header();
    writer.append(text, sample, 17);
    const QTemporaryDir folder;
    const auto table = readCsv(write(folder, QByteArray::fromStdString(text)));
    QVERIFY2(table.ok(), qPrintable(table.error().toString()));
    QCOMPARE(table->rows(), std::size_t(1));
    for (std::size_t i = 0; i < sample.values.size(); ++i) {
        QVERIFY(table->values[i][0] == sample.values[i]);
    }
    QCOMPARE(table->column("packages_lost")->at(0), 17.0);
    QVERIFY(text.find("0.30000000000000004,") != std::string::npos);
}

void TestCsv::absentValuesAreEmptyCells() {
    const auto layout =
        std::make_shared<receive::SampleLayout>(std::vector<std::string>{"timestamp", "payload"});
    const CsvWriter writer(*layout, {"timestamp", "payload"});
    receive::Sample sample = sampleOf(layout);
    sample.values = {1.5, receive::kAbsent};
    std::string text;
    writer.append(text, sample, 0);
    QCOMPARE(text, std::string("1.5,,0\n"));
}

void TestCsv::commaLocalesChangeNothing() {
    // On machines without this locale, the test still checks the default locale.
    const char* before = std::setlocale(LC_ALL, nullptr);
    const std::string saved = before == nullptr ? "C" : before;
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "da_DK.UTF-8"}) {
        if (std::setlocale(LC_ALL, name) != nullptr) {
            break;
        }
    }
    QLocale::setDefault(QLocale(QLocale::German));
    const auto layout = std::make_shared<receive::SampleLayout>(std::vector<std::string>{"timestamp"});
    const CsvWriter writer(*layout, {"timestamp"});
    receive::Sample sample = sampleOf(layout);
    sample.values = {1234.5};
    std::string text = writer.header();
    writer.append(text, sample, 0);
    const QTemporaryDir folder;
    const auto table = readCsv(write(folder, QByteArray::fromStdString(text)));
    std::setlocale(LC_ALL, saved.c_str());
    QLocale::setDefault(QLocale::c());
    QCOMPARE(text, std::string("timestamp,packages_lost\n1234.5,0\n"));
    QCOMPARE(table->values[0][0], 1234.5);
}

void TestCsv::defaultFieldsAreInTheDefaultRecipe() {
    const receive::SampleLayout layout(receive::defaultFields());
    const auto fields = defaultRecordedFields();
    QCOMPARE(fields.front(), std::string("timestamp"));
    for (const std::string& field : fields) {
        QVERIFY2(layout.find(field) != nullptr, field.c_str());
    }
}

void TestCsv::readsFilesOfOtherPrograms() {
    const QTemporaryDir folder;
    const auto table =
        readCsv(write(folder, "\"timestamp\", actual_q_0 ,note\r\n1.5,+2e-3,nan\r\n\r\n2, -inf ,\r\n"));
    QVERIFY2(table.ok(), qPrintable(table.error().toString()));
    QCOMPARE(table->columns, (std::vector<std::string>{"timestamp", "actual_q_0", "note"}));
    QCOMPARE(table->rows(), std::size_t(2));
    QCOMPARE(table->column("actual_q_0")->at(0), 0.002);
    QVERIFY(std::isinf(table->column("actual_q_0")->at(1)));
    QVERIFY(std::isnan(table->column("note")->at(0)));
    QVERIFY(std::isnan(table->column("note")->at(1)));
    QVERIFY(!table->truncated);
    QVERIFY(table->column("missing") == nullptr);
}

void TestCsv::anUnterminatedLineIsSkipped() {
    const QTemporaryDir folder;
    const auto table = readCsv(write(folder, "timestamp,x\n1,2\n2,3.1"));
    QVERIFY(table.ok());
    QVERIFY(table->truncated);
    QCOMPARE(table->rows(), std::size_t(1));
}

void TestCsv::corruptFilesAreExplained_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("says");
    QTest::newRow("empty") << QByteArray() << "line 1: the file has no header";
    QTest::newRow("blank header") << QByteArray("\n1\n") << "line 1: the file has no header";
    QTest::newRow("word") << QByteArray("a,b\n1,2\n3,four\n") << "line 3: \"four\" is not a number";
    QTest::newRow("comma number") << QByteArray("a,b\n1,2,3\n")
                                  << "line 2: the row has 3 cells, the header has 2";
    QTest::newRow("short row") << QByteArray("a,b\n1\n") << "line 2: the row has 1 cells, the header has 2";
    QTest::newRow("tail") << QByteArray("a\n1x\n") << "line 2: \"1x\" is not a number";
    QTest::newRow("binary") << QByteArray("a\n\x00\xff\n", 5) << "line 2:";
}

void TestCsv::corruptFilesAreExplained() {
    QFETCH(QByteArray, content);
    QFETCH(QString, says);
    const QTemporaryDir folder;
    const QString path = write(folder, content);
    const auto table = readCsv(path);
    QCOMPARE(table.error().code, ErrorCode::FileCorrupt);
    QVERIFY2(table.error().context.contains(says), qPrintable(table.error().context));
    QVERIFY(table.error().context.contains(path));
}

void TestCsv::missingFileIsAnError() {
    const QTemporaryDir folder;
    QCOMPARE(readCsv(folder.filePath(QStringLiteral("none.csv"))).error().code, ErrorCode::FileNotReadable);
    QCOMPARE(readCsv(folder.path()).error().code, ErrorCode::FileNotReadable);
}

QTEST_GUILESS_MAIN(TestCsv)
#include "tst_csv.moc"
