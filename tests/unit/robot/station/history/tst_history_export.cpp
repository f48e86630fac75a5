// SPDX-License-Identifier: MIT
//
// Exports of recordings. Every exported number equals the number in the file, and the exported rows are
// exactly those in the time range.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>

#include "robot/recording/formats/open_recording.h"
#include "robot/recording/table_recording.h"
#include "robot/station/history/history_export.h"
#include "robot/station/history/signal_store.h"

using namespace tiller;

namespace {

using Columns = std::vector<std::vector<double>>;

std::string textOf(double value) {
    char text[32];
    return std::isnan(value) ? std::string()
                             : std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

/// Columns of a random recording: time, force, another number, and digital inputs.
Columns randomRows(std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1000, 1000);
    const double step = std::array{0.1, 0.002, 0.0005}[random() % 3];
    double time = std::abs(any(random)) * 10;
    Columns columns(4);
    const std::size_t rows = 20 + random() % 1500;
    for (std::size_t row = 0; row < rows; ++row) {
        columns[0].push_back(time);
        columns[1].push_back(random() % 50 == 0 ? std::numeric_limits<double>::quiet_NaN() : any(random));
        columns[2].push_back(any(random) * 1e-9);
        columns[3].push_back(static_cast<double>(random() % 256));
        time += step * (random() % 100 == 0 ? 7 : 1);
    }
    return columns;
}

void write(const QString& path, const Columns& columns, const char* timeName) {
    std::string text = std::string(timeName) + ",actual_TCP_force_2,mine,actual_digital_input_bits\n";
    for (std::size_t row = 0; row < columns[0].size(); ++row) {
        for (std::size_t column = 0; column < columns.size(); ++column) {
            text += textOf(columns[column][row]) + (column + 1 < columns.size() ? ',' : '\n');
        }
    }
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), static_cast<qint64>(text.size())) < 0) {
        qFatal("cannot write");
    }
}

bool same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

class TestHistoryExport : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // Random recordings, windows and formats.
    void exportedValuesMatchTheFile() {
        std::mt19937 random(35);
        QTemporaryDir folder;
        for (int run = 0; run < 40; ++run) {
            const char* timeName = run % 2 == 0 ? "timestamp" : "Time";
            const Columns columns = randomRows(random);
            const QString path = folder.filePath(QStringLiteral("run%1.csv").arg(run));
            write(path, columns, timeName);
            SignalStore store;
            const QString name =
                store
                    .open(recording::openRecording(path).value(), 0.25 * static_cast<double>(random() % 4000))
                    .value();
            const QString sum = QStringLiteral("Sum [N] = max({%1/actual_TCP_force_2}, {%1/mine})").arg(name);
            const std::vector<int> shown{store.find(name + "/mine"), store.find(name + "/actual_TCP_force_2"),
                                         store.find(name + "/actual_digital_input_bits.3"),
                                         *store.derive(sum)};
            const SeriesBuffer& times = *store.timesOf(name);
            const auto rows = columns[0].size();
            for (const char* suffix : {".csv", ".h5", ".mcap"}) {
                std::size_t first = random() % rows;
                std::size_t last = random() % rows;
                std::tie(first, last) = std::minmax({first, last});
                // Limits exactly at rows, as set by cursors, or between two rows, as set by the visible
                // range.
                const double margin = random() % 2 == 0 ? 0 : 2e-4;
                const double t0 = times.time(static_cast<std::int64_t>(first)) - margin;
                const double t1 = times.time(static_cast<std::int64_t>(last)) + margin;
                const QString to = folder.filePath(QStringLiteral("out%1%2").arg(run).arg(suffix));
                const auto written = exportSignals(store, shown, t0, t1, to);
                QVERIFY2(written.ok(), written.ok() ? "" : written.error().message().c_str());
                QCOMPARE(*written, static_cast<std::int64_t>(last - first + 1));
                const auto back = recording::openRecording(to).value();
                QCOMPARE(back->rows(), std::uint64_t(last - first + 1));
                const bool isHdf5 = std::string_view(suffix) == ".h5";
                const auto place = [&](std::size_t index, const char* column) {
                    return isHdf5 ? back->indexOf(column) : std::optional(index);
                };
                QString computed = store.info(shown.back()).key;
                const std::string computedName = computed.replace('/', '_').toStdString();
                const auto time = place(0, *timeName == 'T' ? "Time" : timeName);
                const auto mine = place(1, "mine");
                const auto force = place(2, "actual_TCP_force_2");
                const auto bit = place(3, "actual_digital_input_bits.3");
                const auto total = place(4, computedName.c_str());
                QStringList names;
                for (const recording::RecordedColumn& column : back->columns()) {
                    names << QString::fromStdString(column.name);
                }
                QVERIFY2(time && mine && force && bit && total, qPrintable(names.join('\n')));
                const auto read =
                    back->read(std::vector{*time, *mine, *force, *bit, *total}, {0, back->rows()}).value();
                for (std::size_t i = 0; i < back->rows(); ++i) {
                    const std::size_t row = first + i;
                    const double input = columns[3][row];
                    const double expected[] = {columns[0][row], columns[2][row], columns[1][row],
                                               static_cast<double>(static_cast<int>(input) >> 3 & 1),
                                               std::isnan(columns[1][row])
                                                   ? columns[1][row]
                                                   : std::max(columns[1][row], columns[2][row])};
                    for (std::size_t column = 0; column < 5; ++column) {
                        QVERIFY2(same(read[column][i], expected[column]),
                                 qPrintable(QStringLiteral("run %1%2 column %3 row %4: %5, expected %6")
                                                .arg(run)
                                                .arg(suffix)
                                                .arg(column)
                                                .arg(row)
                                                .arg(read[column][i], 0, 'g', 17)
                                                .arg(expected[column], 0, 'g', 17)));
                    }
                }
            }
        }
    }

    // The name of a column may be in any encoding, or the file damaged. The columns are found all the same.
    void columnsWithAnyNameAreShown() {
        recording::RecordedTable table;
        table.path = "a.csv";
        table.columns = {{"time", "s", false},
                         {"b\xE4"
                          "d",
                          "", false},
                         {"good", "", false}};
        table.values = {{0, 1, 2}, {5, 6, 7}, {1, 2, 3}};
        SignalStore store;
        const QString name = store.open(std::make_unique<recording::TableRecording>(table), 0).value();
        const std::vector<int> all = store.signalsOf(name);
        QVERIFY(store.want(this, {all.begin(), all.end()}));
        QCOMPARE(store.value(all[1], 1), 6.0);
        QCOMPARE(store.value(all[2], 2), 3.0);
    }
    void damagedFilesAreShownOrRefused_data() {
        QTest::addColumn<QString>("suffix");
        for (const char* suffix : {"csv", "mcap", "h5"}) {
            QTest::newRow(suffix) << suffix;
        }
    }
    void damagedFilesAreShownOrRefused() {
        QFETCH(QString, suffix);
        QTemporaryDir folder;
        std::mt19937 random(12);
        write(folder.filePath("whole.csv"), randomRows(random), "timestamp");
        const QString whole = folder.filePath("whole." + suffix);
        if (suffix != "csv") {
            SignalStore store;
            const QString name =
                store.open(recording::openRecording(folder.filePath("whole.csv")).value(), 0).value();
            QVERIFY(exportSignals(store, store.signalsOf(name), 0, 1e9, whole).ok());
        }
        QFile file(whole);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        int shown = 0;
        for (int run = 0; run < 200; ++run) {
            QByteArray damaged = bytes;
            // Half of the changes are in the head of the file, where the names are.
            const auto place = [&] {
                const qsizetype end =
                    random() % 2 == 0 ? std::min<qsizetype>(1000, damaged.size()) : damaged.size();
                return static_cast<qsizetype>(random() % static_cast<unsigned>(end));
            };
            for (unsigned change = 0; change < 1 + random() % 4; ++change) {
                damaged[place()] = static_cast<char>(random());
            }
            const QString path = folder.filePath(QStringLiteral("%1.%2").arg(run).arg(suffix));
            QFile copy(path);
            QVERIFY(copy.open(QIODevice::WriteOnly) && copy.write(damaged) == damaged.size());
            copy.close();
            auto opened = recording::openRecording(path);
            SignalStore store;
            const auto name =
                opened ? store.open(std::move(opened).value(), 0) : Result<QString>(opened.error());
            if (!name) {
                QVERIFY(!name.error().toString().isEmpty());
                continue;
            }
            ++shown;
            const std::vector<int> all = store.signalsOf(*name);
            store.want(this, {all.begin(), all.end()});
            for (const int signal : all) {
                store.valueAt(signal, 0.1);
            }
            const auto exported = exportSignals(store, all, 0, 1e9, folder.filePath("out.csv"));
            QVERIFY(exported || !exported.error().toString().isEmpty());
        }
        QVERIFY2(shown > 20, qPrintable(QString::number(shown)));
    }

    void signalsOfSeveralSourcesAreRefused() {
        QTemporaryDir folder;
        std::mt19937 random(1);
        write(folder.filePath("a.csv"), randomRows(random), "timestamp");
        SignalStore store;
        const QString name =
            store.open(recording::openRecording(folder.filePath("a.csv")).value(), 0).value();
        const QString to = folder.filePath("out.csv");
        const auto mixed =
            exportSignals(store, {store.find(name + "/mine"), store.find("actual_q_0")}, 0, 1e9, to);
        QCOMPARE(mixed.error().code, ErrorCode::Rejected);
        QVERIFY2(mixed.error().context.contains("several recordings"), qPrintable(mixed.error().toString()));
        QVERIFY(!QFile::exists(to));
        // A range without rows, and live signals in a recording format.
        QCOMPARE(exportSignals(store, {store.find(name + "/mine")}, 1e8, 1e9, to).error().code,
                 ErrorCode::InvalidArgument);
        QCOMPARE(exportSignals(store, {store.find("actual_q_0")}, 0, 1, folder.filePath("x.h5")).error().code,
                 ErrorCode::Rejected);
    }

    // The rows of two robots in one table could not be distinguished.
    void aRangeWithTwoRobotsIsRefused() {
        SignalStore store;
        const auto append = [&](double from) {
            std::vector<SeriesBuffer::Row> rows;
            for (int i = 0; i < 100; ++i) {
                rows.push_back({from + i * 0.002, false});
            }
            store.appendLive(rows, [](std::size_t, std::size_t) { return 1.0; });
        };
        store.setRobot("first");
        append(1);
        store.setRobot("first");  // connected again
        append(2);
        store.setRobot("second");
        append(3);
        const QTemporaryDir folder;
        const QString path = folder.filePath("range.csv");
        const std::vector<int> shown{store.find("actual_q_0")};
        const auto mixed = exportCsv(store, shown, 1, 4, path);
        QVERIFY(!mixed && mixed.error().context.contains("different robots"));
        QVERIFY(!QFile::exists(path));
        QCOMPARE(exportCsv(store, shown, 1, 2.9, path).value(), 200);
        QCOMPARE(exportCsv(store, shown, 3, 4, path).value(), 100);
    }

    void formulaInTheHeaderIsOneCell() {
        QTemporaryDir folder;
        SignalStore store;
        const int norm = *store.derive("|q| = norm(actual_q_0, actual_q_1)");
        std::vector<SeriesBuffer::Row> rows{{1.0, false}, {1.002, false}};
        store.appendLive(rows, [](std::size_t, std::size_t) { return 0.1; });
        const QString path = folder.filePath("live.csv");
        QCOMPARE(*exportCsv(store, {store.find("actual_q_0"), norm}, 0, 2, path), std::int64_t(2));
        const auto back = recording::openRecording(path).value();
        QCOMPARE(back->columns().size(), std::size_t(3));
        QCOMPARE(back->columns()[2].name, std::string("|q| = norm(actual_q_0, actual_q_1)"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\n1.002,0.1,"));
    }
};

QTEST_GUILESS_MAIN(TestHistoryExport)
#include "tst_history_export.moc"
