// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "widgets/plots/series_buffer.h"

using namespace tiller;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Every sample ever appended, as a plain list: what the buffer's answers are measured against.
struct Plain {
    struct Row {
        double time;
        std::array<float, 2> values;
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
    double time = plain.rows.empty() ? 100.0 : plain.rows.back().time;
    for (int i = 0; i < count; ++i) {
        const bool gap = chance(random) == 0;
        time += gap ? 0.002 * (2 + chance(random)) : 0.002;
        const Plain::Row row{time,
                             {value(random) + (chance(random) == 0 ? 500.0F : 0.0F),
                              chance(random) < 5 ? kNan : value(random)},
                             gap};
        QVERIFY(buffer.append(row.time, row.values, row.gap));
        plain.rows.push_back(row);
    }
}

}  // namespace

class TestSeriesBuffer : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void envelopeEqualsBruteForce_data() {
        QTest::addColumn<int>("samples");
        QTest::newRow("fewer than columns") << 40;
        QTest::newRow("one level") << 700;
        QTest::newRow("just full") << 4096;
        QTest::newRow("the oldest fell out") << 9001;
    }
    void envelopeEqualsBruteForce() {
        QFETCH(int, samples);
        std::mt19937 random(static_cast<unsigned>(samples));
        SeriesBuffer buffer(2, 4096);
        Plain plain;
        fill(buffer, plain, samples, random);
        QCOMPARE(buffer.end(), std::int64_t{samples});
        QCOMPARE(buffer.first(), std::int64_t{std::max(0, samples - 4096)});

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
            for (int signal = 0; signal < 2; ++signal) {
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

    void aGridThatMovesOnEqualsOneCutAnew() {
        std::mt19937 random(11);
        SeriesBuffer buffer(2, 4096);
        Plain plain;
        fill(buffer, plain, 4000, random);
        ColumnGrid moving;
        std::uniform_int_distribution<int> more(0, 60);
        const double width = 0.0371;
        for (int round = 0; round < 120; ++round) {
            fill(buffer, plain, more(random), random);
            const double start = std::floor((buffer.lastTime() - 9 + 3 * (round % 5)) / width) * width;
            buffer.cut(start, width, 150, moving);
            ColumnGrid anew;
            buffer.cut(start, width, 150, anew);
            QVERIFY(moving.edges == anew.edges);
            QVERIFY(moving.gapBefore == anew.gapBefore);
        }
    }

    void rangesOfEveryAlignmentAreExact() {
        std::mt19937 random(7);
        SeriesBuffer buffer(2, 4096);
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

    void askingBeyondTheHistoryGivesNothing() {
        SeriesBuffer buffer(1, 4096);
        QVERIFY(buffer.envelope(0, 0, 1, 10).front().isEmpty());
        const std::array<float, 1> one = {1};
        buffer.append(5, one);
        for (const MinMax& column : buffer.envelope(0, 6, 7, 10)) {
            QVERIFY(column.isEmpty());
        }
        for (const MinMax& column : buffer.envelope(0, 3, 4, 10)) {
            QVERIFY(column.isEmpty());
        }
        QCOMPARE(buffer.nearest(9, 0.1), std::int64_t{-1});
        QCOMPARE(buffer.nearest(5.05, 0.1), std::int64_t{0});
        QVERIFY(buffer.envelope(0, 1, 1, 10).empty());
        QVERIFY(buffer.envelope(0, 0, 1, 0).empty());
    }

    void timeThatDoesNotGoForwardIsRefused() {
        SeriesBuffer buffer(1, 4096);
        const std::array<float, 1> one = {1};
        QVERIFY(buffer.append(1, one));
        QVERIFY(!buffer.append(1, one));
        QVERIFY(!buffer.append(0.5, one));
        QVERIFY(!buffer.append(std::numeric_limits<double>::quiet_NaN(), one));
        QVERIFY(!buffer.append(std::numeric_limits<double>::infinity(), one));
        QCOMPARE(buffer.end(), std::int64_t{1});
    }

    void memoryIsBoundedAndHoldsHalfAnHourOfTwentyFourSignals() {
        const SeriesBuffer buffer(24);
        QVERIFY(static_cast<double>(buffer.capacity()) * 0.002 > 30 * 60);
        QVERIFY(buffer.memoryBytes() < 200'000'000);

        SeriesBuffer small(1, 4096);
        const std::size_t before = small.memoryBytes();
        std::array<float, 1> row{};
        for (int i = 0; i < 50000; ++i) {
            row[0] = static_cast<float>(i);
            small.append(i * 0.002, row);
        }
        QCOMPARE(small.memoryBytes(), before);
        QCOMPARE(small.end() - small.first(), std::int64_t{4096});
        QCOMPARE(small.value(0, small.first()), 50000.0F - 4096.0F);
        QCOMPARE(small.minMax(0, 0, small.end()).min, 50000.0F - 4096.0F);
    }
};

QTEST_GUILESS_MAIN(TestSeriesBuffer)
#include "tst_series_buffer.moc"
