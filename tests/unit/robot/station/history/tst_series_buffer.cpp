// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "robot/station/history/series_buffer.h"

using namespace tiller;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Every sample appended so far, as a plain list. Reference for the results of the buffer.
struct Plain {
    struct Row {
        double time;
        std::array<double, 3> values;  ///< two columns can be stored as float
        bool gap;
    };
    std::vector<Row> rows;

    MinMax minMax(int signal, double from, double to, std::int64_t oldest) const {
        MinMax sum;
        for (std::size_t i = static_cast<std::size_t>(oldest); i < rows.size(); ++i) {
            if (rows[i].time >= from && rows[i].time < to) {
                sum.add(rows[i].values[static_cast<std::size_t>(signal)]);
            }
        }
        return sum;
    }
    bool gap(double from, double to, std::int64_t oldest) const {
        for (std::size_t i = static_cast<std::size_t>(oldest); i < rows.size(); ++i) {
            if (rows[i].time >= from && rows[i].time < to && rows[i].gap) {
                return true;
            }
        }
        return false;
    }
};

void fill(SeriesBuffer& buffer, Plain& plain, int count, std::mt19937& random) {
    std::uniform_real_distribution<float> value(-50, 50);
    std::uniform_int_distribution<int> chance(0, 99);
    std::uniform_int_distribution<int> batch(1, 40);
    std::uniform_int_distribution<std::int64_t> word(0, std::int64_t{1} << 52);
    double time = plain.rows.empty() ? 100.0 : plain.rows.back().time;
    double bits = 7;
    // Batches of one frame, and occasionally batches that are larger than a block.
    while (count > 0) {
        const int now = std::min(count, chance(random) == 0 ? 5000 : batch(random));
        count -= now;
        const std::size_t before = plain.rows.size();
        std::vector<SeriesBuffer::Row> rows;
        for (int i = 0; i < now; ++i) {
            const bool gap = chance(random) == 0;
            time += gap ? 0.002 * (2 + chance(random)) : 0.002;
            if (chance(random) == 0 && chance(random) < 20) {
                bits = static_cast<double>(word(random));  // rarely, so whole blocks are equal
            }
            const float spike = chance(random) == 0 ? 500.0F : 0.0F;
            plain.rows.push_back({time,
                                  {static_cast<double>(value(random) + spike),
                                   static_cast<double>(chance(random) < 5 ? kNan : value(random)), bits},
                                  gap});
            rows.push_back({time, gap});
        }
        buffer.appendRows(rows, [&](std::size_t column, std::size_t row) {
            return plain.rows[before + row].values[column];
        });
    }
}

SeriesBuffer threeColumns(const HistoryLimits& limits = {}) {
    SeriesBuffer buffer(2, limits);
    buffer.addColumn(Precision::Exact);
    return buffer;
}

}  // namespace

class TestSeriesBuffer : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void envelopeEqualsBruteForce_data() {
        QTest::addColumn<int>("samples");
        QTest::newRow("fewer than columns") << 40;
        QTest::newRow("one level") << 700;
        QTest::newRow("just a block") << 4096;
        QTest::newRow("many blocks") << 30001;
    }
    void envelopeEqualsBruteForce() {
        QFETCH(int, samples);
        std::mt19937 random(static_cast<unsigned>(samples));
        SeriesBuffer buffer = threeColumns();
        Plain plain;
        fill(buffer, plain, samples, random);
        QCOMPARE(buffer.end(), std::int64_t{samples});
        QCOMPARE(buffer.first(), std::int64_t{0});

        const double begin = plain.rows.front().time;
        const double end = plain.rows.back().time;
        std::uniform_real_distribution<double> moment(begin - 1, end + 1);
        std::uniform_int_distribution<int> columnCount(1, 300);
        ColumnGrid grid;
        for (int round = 0; round < 40; ++round) {
            double t0 = round == 0 ? begin : moment(random);
            double t1 = round == 0 ? end : moment(random);
            if (t1 < t0) {
                std::swap(t0, t1);
            }
            const int columns = columnCount(random);
            const double width = (t1 - t0) / columns;
            buffer.cut(t0, width, columns, grid);
            std::vector<MinMax> envelope;
            for (int signal = 0; signal < 3; ++signal) {
                buffer.envelope(signal, grid, envelope);
                QCOMPARE(envelope.size(), static_cast<std::size_t>(columns));
                for (int c = 0; c < columns; ++c) {
                    const double from = t0 + c * width;
                    const double to = t0 + (c + 1) * width;
                    const MinMax wanted = plain.minMax(signal, from, to, buffer.first());
                    QCOMPARE(envelope[static_cast<std::size_t>(c)].isEmpty(), wanted.isEmpty());
                    QVERIFY(envelope[static_cast<std::size_t>(c)] == wanted);
                    QCOMPARE(grid.gapBefore[static_cast<std::size_t>(c)] != 0,
                             plain.gap(from, to, buffer.first()));
                }
            }
        }
    }

    void anAdvancedGridEqualsARecomputedOne() {
        std::mt19937 random(11);
        SeriesBuffer buffer = threeColumns();
        Plain plain;
        fill(buffer, plain, 4000, random);
        ColumnGrid moving;
        std::uniform_int_distribution<int> more(0, 60);
        const double width = 0.0371;
        for (int round = 0; round < 120; ++round) {
            fill(buffer, plain, more(random), random);
            const double start = std::floor((buffer.lastTime() - 9 + 3 * (round % 5)) / width) * width;
            buffer.cut(start, width, 150, moving);
            ColumnGrid fresh;
            buffer.cut(start, width, 150, fresh);
            QVERIFY(moving.edges == fresh.edges);
            QVERIFY(moving.gapBefore == fresh.gapBefore);
        }
    }

    void rangesOfEveryAlignmentAreExact() {
        std::mt19937 random(7);
        SeriesBuffer buffer = threeColumns();
        Plain plain;
        fill(buffer, plain, 6000, random);
        std::uniform_int_distribution<std::int64_t> index(buffer.first(), buffer.end());
        for (int round = 0; round < 400; ++round) {
            std::int64_t a = index(random);
            std::int64_t b = index(random);
            if (b < a) {
                std::swap(a, b);
            }
            MinMax wanted;
            bool gap = false;
            for (std::int64_t i = a; i < b; ++i) {
                wanted.add(plain.rows[static_cast<std::size_t>(i)].values[0]);
                gap = gap || plain.rows[static_cast<std::size_t>(i)].gap;
            }
            QVERIFY(buffer.minMax(0, a, b) == wanted);
            QCOMPARE(buffer.hasGap(a, b), gap);
        }
    }

    void queriesBeyondTheHistoryAreEmpty() {
        SeriesBuffer buffer(1);
        QVERIFY(buffer.envelope(0, 0, 1, 10).front().isEmpty());
        const std::array<float, 1> one = {1};
        buffer.append(5, one);
        for (const MinMax& column : buffer.envelope(0, 6, 7, 10)) {
            QVERIFY(column.isEmpty());
        }
        for (const MinMax& column : buffer.envelope(0, 3, 4, 10)) {
            QVERIFY(column.isEmpty());
        }
        QCOMPARE(buffer.lastBefore(4.9), std::int64_t{-1});
        QCOMPARE(buffer.lastBefore(5), std::int64_t{0});
        QCOMPARE(buffer.lastBefore(9), std::int64_t{0});
        QVERIFY(buffer.envelope(0, 1, 1, 10).empty());
        QVERIFY(buffer.envelope(0, 0, 1, 0).empty());
    }

    void nonIncreasingTimesAreRefused() {
        SeriesBuffer buffer(1);
        const std::array<float, 1> one = {1};
        QVERIFY(buffer.append(1, one));
        QVERIFY(!buffer.append(1, one));
        QVERIFY(!buffer.append(0.5, one));
        QVERIFY(!buffer.append(std::numeric_limits<double>::quiet_NaN(), one));
        QVERIFY(!buffer.append(std::numeric_limits<double>::infinity(), one));
        QCOMPARE(buffer.end(), std::int64_t{1});
    }

    // All values are noise, so no block can be stored as a single value.
    void memoryOverheadIsAtMostTwentyPercent() {
        SeriesBuffer buffer(24);
        std::mt19937 random(3);
        std::uniform_real_distribution<float> value(-1, 1);
        std::vector<SeriesBuffer::Row> rows(1000);
        constexpr int kRounds = 200;
        for (int round = 0; round < kRounds; ++round) {
            for (int i = 0; i < 1000; ++i) {
                rows[static_cast<std::size_t>(i)] = {(round * 1000 + i) * 0.002, false};
            }
            buffer.appendRows(rows, [&](std::size_t, std::size_t) { return value(random); });
        }
        const double raw = 24.0 * 4 * 1000 * kRounds;
        const double ratio = static_cast<double>(buffer.memoryBytes()) / raw;
        QVERIFY2(ratio <= 1.2, qPrintable(QString::number(ratio)));
        QVERIFY2(ratio > 1.0, "the buffer uses less memory than the values");
    }

    void theOldestSamplesAreDroppedByAgeAndMemory() {
        for (const HistoryLimits& limits :
             {HistoryLimits{20, std::size_t{1} << 30}, HistoryLimits{1e9, 400'000}}) {
            SeriesBuffer buffer(1, limits);
            std::mt19937 random(5);
            std::uniform_real_distribution<float> value(-1, 1);
            std::array<float, 1> row{};
            std::vector<float> all;
            for (int i = 0; i < 60'000; ++i) {
                row[0] = value(random);
                all.push_back(row[0]);
                QVERIFY(buffer.append(i * 0.002, row));
            }
            QVERIFY(buffer.first() > 0);
            QVERIFY(buffer.memoryBytes() <= limits.bytes);
            if (limits.seconds < 100) {
                QVERIFY(buffer.lastTime() - buffer.firstTime() >= limits.seconds);
                QVERIFY(buffer.lastTime() - buffer.firstTime() < limits.seconds + 9);
            }
            MinMax wanted;
            for (std::int64_t i = buffer.first(); i < buffer.end(); ++i) {
                QCOMPARE(buffer.value(0, i), static_cast<double>(all[static_cast<std::size_t>(i)]));
                wanted.add(buffer.value(0, i));
            }
            QVERIFY(buffer.minMax(0, 0, buffer.end()) == wanted);
        }
    }

    void aSmallerBudgetAppliesImmediately() {
        SeriesBuffer buffer(4);
        std::mt19937 random(6);
        std::uniform_real_distribution<float> value(-1, 1);
        for (int i = 0; i < 60'000; ++i) {
            const std::array<float, 4> row = {value(random), value(random), value(random), value(random)};
            buffer.append(i * 0.002, row);
        }
        buffer.setLimits({1e9, 500'000});
        QVERIFY(buffer.memoryBytes() <= 500'000);
        QCOMPARE(buffer.end(), std::int64_t{60'000});
    }

    void aColumnAddedLaterHasNoEarlierValues() {
        SeriesBuffer buffer(1);
        const std::array<float, 2> row = {1, 2};
        for (int i = 0; i < 5000; ++i) {
            buffer.append(i * 0.002, row);
        }
        const int added = buffer.addColumn(Precision::Exact);
        for (int i = 5000; i < 9000; ++i) {
            buffer.append(i * 0.002, row);
        }
        QVERIFY(std::isnan(buffer.value(added, 4999)));
        QCOMPARE(buffer.value(added, 5000), 2.0);
        QVERIFY(buffer.minMax(added, 0, 5000).isEmpty());
        QVERIFY((buffer.minMax(added, 0, 9000) == MinMax{2, 2}));
    }

    void constantColumnsUseAlmostNoMemory() {
        SeriesBuffer buffer(200);
        const std::size_t times = [] {
            SeriesBuffer empty;
            for (int i = 0; i < 40'960; ++i) {
                empty.append(i * 0.002, {});
            }
            return empty.memoryBytes();
        }();
        const std::vector<float> row(200, 3.5F);
        for (int i = 0; i < 40'960; ++i) {
            buffer.append(i * 0.002, row);
        }
        QVERIFY(buffer.memoryBytes() < times + std::size_t{200} * 10 * 100);
        QVERIFY((buffer.minMax(7, 100, 30'000) == MinMax{3.5, 3.5}));
    }
};

QTEST_GUILESS_MAIN(TestSeriesBuffer)
#include "tst_series_buffer.moc"
