// SPDX-License-Identifier: GPL-3.0-or-later
//
// A long recording in the plots. Curves drawn from summaries lose no spike, curves of short ranges are exact,
// and single values equal those of the file at any position.

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "robot/station/history/recorded_lane.h"
#include "tests/unit/robot/station/history/long_recording.h"

using namespace tiller;
using namespace tiller::test;

class TestHistoryFile : public QObject {
    Q_OBJECT

    std::unique_ptr<Long> long_;

private Q_SLOTS:
    void initTestCase() { long_ = std::make_unique<Long>(); }

    void aShortFileIsReadCompletely() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("short.mcap");
        QVERIFY(test::writeFile(path, test::madeFile(*recording::mcapFormat(), 2000)));
        Opened opened(path);
        QVERIFY(opened.store.want(this, {opened.signal}));
        QVERIFY(!opened.history().isInFile());
    }

    void extentsMaySpanSeveralBlocks() {
        struct Nothing : SampleFile {
            void fill(std::int64_t) override {}
        } nothing;
        constexpr std::int64_t kBlock = SeriesColumn::kBlockRows;
        constexpr std::int64_t kSamples = 5 * kBlock + 100;
        SeriesBuffer history;
        history.lieIn(nothing, kSamples, {{0, 0.0}, {kSamples - 1, 100.0}}, {});
        const int column = history.outlineColumn(Precision::Single);
        QVERIFY(history.minMax(column, 0, kSamples).isEmpty());
        const std::vector<MinMax> extents{{-1, 1}, {-2, 2}, {-3, 3}};
        history.setExtents(column, 0, 2 * kBlock, extents);
        QVERIFY(history.minMax(column, 5, 6) == extents[0]);
        QVERIFY(history.minMax(column, kBlock, 2 * kBlock) == extents[0]);
        QVERIFY(history.minMax(column, 3 * kBlock, 3 * kBlock + 1) == extents[1]);
        QVERIFY(history.minMax(column, 5 * kBlock, kSamples) == extents[2]);
        QVERIFY(history.minMax(column, 0, kSamples) == extents[2]);
        QCOMPARE(history.resolutionOf(column, 4), 2 * kBlock);
        const std::vector<MinMax> halves{{0, 0.5}, {-1, 0}};
        history.setExtents(column, kBlock, kBlock / 2, halves);
        QVERIFY(history.minMax(column, kBlock, kBlock + 1) == halves[0]);
        QVERIFY(history.minMax(column, 2 * kBlock - 1, 2 * kBlock) == halves[1]);
        QVERIFY(history.minMax(column, 0, 1) == extents[0]);
    }

    void openingReadsNoRow() {
        Opened opened(long_->path);
        QVERIFY(opened.store.want(this, {opened.signal, opened.mode}));
        const SeriesBuffer& history = opened.history();
        QVERIFY(history.isInFile());
        QCOMPARE(history.end(), static_cast<std::int64_t>(kRows));
        QVERIFY(std::abs(history.firstTime() - kBegin) < 1e-6);
        QVERIFY(std::abs(history.lastTime() - long_->timeOf(kRows - 1)) < 1e-3);
        QVERIFY(!history.hasRows(opened.store.column(opened.signal), 0, 1));
        const MinMax all = history.minMax(opened.store.column(opened.signal), 0, history.end());
        QCOMPARE(all.min, -kSpike);
        QCOMPARE(all.max, kSpike);
        QVERIFY2(opened.store.memoryBytes() < kRows, "the file needs more than one byte of memory per row");
        QVERIFY(history.gapBefore(static_cast<std::int64_t>(kGap)));
        QVERIFY(!history.gapBefore(static_cast<std::int64_t>(kGap) + 1));
    }

    void everyValueMatchesTheFile() {
        Opened opened(long_->path);
        QVERIFY(opened.store.want(this, {opened.signal}));
        std::mt19937 random(7);
        std::uniform_int_distribution<std::uint64_t> place(0, kRows - 1);
        for (int i = 0; i < 200; ++i) {
            const std::uint64_t row = i == 0 ? kGap : place(random);
            const auto sample = static_cast<std::int64_t>(row);
            QVERIFY(std::abs(opened.history().time(sample) - long_->timeOf(row)) < 1e-6);
            QCOMPARE(static_cast<float>(opened.store.value(opened.signal, sample)), long_->force[row]);
            QCOMPARE(opened.history().lowerBound(long_->timeOf(row) - kPeriod / 2), sample);
            const auto value = opened.store.valueAt(opened.signal, long_->timeOf(row) + kPeriod / 4);
            QVERIFY(value);
            QCOMPARE(static_cast<float>(*value), long_->force[row]);
        }
        // There is no value inside the gap.
        QVERIFY(!opened.store.valueAt(opened.signal, long_->timeOf(kGap) - 0.3));
        const auto sample = opened.store.sampleAt(opened.name, long_->timeOf(5));
        QCOMPARE(static_cast<float>(sample.values[*sample.layout->indexOfComponent("actual_TCP_force_2")]),
                 long_->force[5]);
    }

    /// The draft contains all spikes, each at most about two columns wide. After refinement, each spike is in
    /// its exact column.
    void noSpikeIsLostAtAnyZoom() {
        Opened opened(long_->path);
        QVERIFY(opened.store.want(this, {opened.signal}));
        SeriesBuffer plain(1, HistoryLimits{1e9, std::size_t{1} << 30});
        for (std::uint64_t row = 0; row < kRows; ++row) {
            QVERIFY(plain.append(long_->timeOf(row), std::span(&long_->force[row], 1), row == kGap));
        }
        const int column = opened.store.column(opened.signal);
        std::mt19937 random(11);
        constexpr int kColumns = 1000;
        const double all = static_cast<double>(kRows) * kPeriod;
        for (int i = 0; i < 40; ++i) {
            const double span = all * std::pow(1 / all, i / 39.0);
            const double start = kBegin + std::uniform_real_distribution<double>(0, all - span)(random);
            const double width = span / kColumns;
            ColumnGrid grid;
            ColumnGrid raw;
            opened.history().cut(start, width, kColumns, grid);
            plain.cut(start, width, kColumns, raw);
            bool more = true;
            for (int turn = 0; more && turn < 1000; ++turn) {
                more = opened.store.sharpen(
                    opened.history(), grid.edges.front() - 1, grid.edges.back() + 1, kColumns,
                    turn == 0 ? HistoryFile::Effort::Draft : HistoryFile::Effort::Turn);
                opened.history().cut(start, width, kColumns, grid);
                for (int c = 2; c + 2 < kColumns; ++c) {
                    const auto at = static_cast<std::size_t>(c);
                    MinMax near;  // including the neighbouring columns, because draft times are approximate
                    for (std::size_t k = at - 2; k <= at + 2; ++k) {
                        near.add(opened.history().minMax(column, grid.edges[k], grid.edges[k + 1]));
                    }
                    const MinMax wanted = plain.minMax(0, raw.edges[at], raw.edges[at + 1]);
                    QVERIFY2(wanted.isEmpty() || (near.min <= wanted.min && near.max >= wanted.max),
                             qPrintable(QStringLiteral("span %1, column %2").arg(span).arg(c)));
                }
            }
            QVERIFY2(!more, "the refinement does not end");
            QVERIFY(!opened.store.sharpen(opened.history(), grid.edges.front() - 1, grid.edges.back() + 1,
                                          kColumns, HistoryFile::Effort::Draft));
            if (grid.edges.back() - grid.edges.front() <= 60'000) {
                // At this zoom level the rows themselves are read, so the result equals that of the buffer in
                // memory.
                QVERIFY(grid.edges == raw.edges);
                QVERIFY(opened.history().envelope(column, start, start + span, kColumns) ==
                        plain.envelope(0, start, start + span, kColumns));
            }
        }
    }

    void aFileTruncatedByACrashIsShownCompletely() {
        QFile whole(long_->path);
        QVERIFY(whole.open(QIODevice::ReadOnly));
        const QByteArray bytes = whole.readAll();
        const QString path = long_->folder.filePath("cut.mcap");
        for (const double part : {0.96, 0.5, 0.15}) {
            QFile cut(path);
            QVERIFY(cut.open(QIODevice::WriteOnly | QIODevice::Truncate));
            cut.write(bytes.left(static_cast<qsizetype>(static_cast<double>(bytes.size()) * part)));
            cut.close();
            Opened opened(path);
            QVERIFY(opened.store.want(this, {opened.signal}));
            QVERIFY(opened.history().isInFile());
            const std::int64_t end = opened.history().end();
            QVERIFY(static_cast<double>(end) > static_cast<double>(kRows) * part * 0.8);
            const int column = opened.store.column(opened.signal);
            for (const int pixels : {1000, 100'000}) {
                while (opened.store.sharpen(opened.history(), 0, end, pixels, HistoryFile::Effort::Turn)) {
                }
                for (const std::uint64_t spike : long_->spikes) {
                    const auto at = static_cast<std::int64_t>(spike);
                    const MinMax extent = opened.history().minMax(column, at, std::min(at + 1, end));
                    QVERIFY(at >= end || std::max(extent.max, -extent.min) == kSpike);
                }
            }
            for (const std::int64_t row : {std::int64_t{0}, end / 2, end - 1}) {
                QCOMPARE(static_cast<float>(opened.store.value(opened.signal, row)),
                         long_->force[static_cast<std::size_t>(row)]);
            }
        }
    }

    void aColumnRequestedLaterIsAlsoLoaded() {
        Opened opened(long_->path);
        QVERIFY(opened.store.want(this, {opened.signal}));
        QCOMPARE(static_cast<float>(opened.store.value(opened.signal, 1000)), long_->force[1000]);
        QVERIFY(opened.store.want(this, {opened.signal, opened.mode}));
        QCOMPARE(opened.store.value(opened.mode, 1000), 7.0);
        QCOMPARE(opened.store.value(opened.mode, static_cast<std::int64_t>(kRows) - 1), 5.0);
        QCOMPARE(static_cast<float>(opened.store.value(opened.signal, 1000)), long_->force[1000]);
    }

    /// Derived signals of a file equal the values computed from its rows: single values, the whole signal,
    /// and values that need earlier rows from another block.
    void derivedSignalsMatchTheRows() {
        Opened opened(long_->path);
        const QString fz = DerivedSignal::written(opened.name + QStringLiteral("/actual_TCP_force_2"));
        const auto made = opened.store.derive(QStringLiteral("2|Fz| = 2 * norm(%1) + 1").arg(fz));
        QVERIFY2(made.ok(), qPrintable(made ? QString() : made.error().toString()));
        const auto slope = opened.store.derive(QStringLiteral("dF/dt [N/s] = deriv(%1, 0.1)").arg(fz));
        QVERIFY(slope.ok());
        QCOMPARE(opened.store.recordingOf(*made), opened.name);
        QCOMPARE(opened.store.info(*made).group, opened.name);
        QVERIFY(opened.store.want(this, {*made, *slope}));
        // Single values are available immediately, at any row.
        const auto truth = [&](std::uint64_t row) {
            return static_cast<float>(2 * std::abs(static_cast<double>(long_->force[row])) + 1);
        };
        for (const std::uint64_t row : {std::uint64_t{0}, std::uint64_t{4096}, kGap, kRows - 1}) {
            QCOMPARE(static_cast<float>(opened.store.value(*made, static_cast<std::int64_t>(row))),
                     truth(row));
        }
        constexpr std::uint64_t kBack = 50;  // rows
        for (const std::uint64_t row : {std::uint64_t{4096}, std::uint64_t{8191}, std::uint64_t{8192}}) {
            const double expected =
                (static_cast<double>(long_->force[row]) - static_cast<double>(long_->force[row - kBack])) /
                (kBack * kPeriod);
            QVERIFY(std::abs(opened.store.value(*slope, static_cast<std::int64_t>(row)) - expected) < 1e-3);
        }
        QVERIFY2(std::isnan(opened.store.value(*slope, static_cast<std::int64_t>(kGap))),
                 "a value was computed across a gap");
        // The whole signal, after it was computed completely.
        QTRY_COMPARE_WITH_TIMEOUT(opened.store.computedPart(*slope), 1.0, 60'000);
        QCOMPARE(opened.store.computedPart(*made), 1.0);
        const SeriesBuffer& history = *opened.store.buffer(*made);
        const int column = opened.store.column(*made);
        QCOMPARE(history.minMax(column, 0, history.end()).max, 2 * kSpike + 1);
        for (const std::uint64_t spike : long_->spikes) {
            const auto at = static_cast<std::int64_t>(spike);
            QCOMPARE(history.minMax(column, at, at + 1).max, 2 * kSpike + 1);
        }
        std::mt19937 random(3);
        for (int i = 0; i < 200; ++i) {
            const auto begin = std::uniform_int_distribution<std::int64_t>(0, kRows - 40'000)(random);
            const auto end = begin + std::uniform_int_distribution<std::int64_t>(1, 40'000)(random);
            MinMax wanted;
            for (std::int64_t row = begin; row < end; ++row) {
                wanted.add(static_cast<double>(truth(static_cast<std::uint64_t>(row))));
            }
            const MinMax reported = history.minMax(column, begin, end);
            constexpr double kRounding = 1e-6;
            QVERIFY(reported.min <= wanted.min + kRounding && reported.max >= wanted.max - kRounding);
        }
    }

    void closingTheFileStopsNotifications() {
        Opened opened(long_->path);
        const QString fz = DerivedSignal::written(opened.name + QStringLiteral("/actual_TCP_force_2"));
        const auto made = opened.store.derive(QStringLiteral("twice = 2 * %1").arg(fz));
        QVERIFY(made.ok());
        int reported = 0;
        connect(&opened.store, &SignalStore::computedFurther, this, [&] { ++reported; });
        connect(&opened.store, &SignalStore::computationFailed, this, [&] { ++reported; });
        opened.store.closeRecordings();
        // A signal of a second recording is computed after the first signal, so all notifications of the
        // first signal have arrived when the second signal is complete.
        auto file = recording::openRecording(long_->path);
        const QString name = opened.store.open(std::move(file).value(), kBegin).value();
        const auto next = opened.store.derive(
            QStringLiteral("next = 3 * %1").arg(DerivedSignal::written(name + "/actual_TCP_force_2")));
        QVERIFY(next.ok());
        disconnect(&opened.store, nullptr, this, nullptr);
        QTRY_COMPARE_WITH_TIMEOUT(opened.store.computedPart(*next), 1.0, 60'000);
        QCOMPARE(reported, 0);
        QCOMPARE(opened.store.buffer(*made), nullptr);
    }

    void aShortFileAlsoHasDerivedSignals() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a {strange} = name, 2.mcap");
        const QString plain = folder.filePath("run 1-2.mcap");
        QVERIFY(test::writeFile(path, test::madeFile(*recording::mcapFormat(), 2000)));
        QVERIFY(test::writeFile(plain, test::madeFile(*recording::mcapFormat(), 2000)));
        Opened opened(plain);
        const QString q0 = DerivedSignal::written(opened.name + QStringLiteral("/actual_q_0"));
        const auto made = opened.store.derive(QStringLiteral("twice [rad] = 2 * %1 + 0*%1").arg(q0));
        QVERIFY2(made.ok(), qPrintable(made ? QString() : made.error().toString()));
        QVERIFY(opened.store.want(this, {*made, opened.store.find(opened.name + "/actual_q_0")}));
        for (const std::int64_t row : {0, 777, 1999}) {
            QCOMPARE(static_cast<float>(opened.store.value(*made, row)),
                     static_cast<float>(
                         2 * opened.store.value(opened.store.find(opened.name + "/actual_q_0"), row)));
        }
        // Signals of two files, or of a file and live data, are not in the same packets and cannot be
        // combined.
        QVERIFY(!opened.store.derive(QStringLiteral("x = %1 - actual_q_0").arg(q0)).ok());
        Opened strange(path);
        const auto one = strange.store.derive(
            QStringLiteral("x = %1").arg(DerivedSignal::written(strange.name + "/actual_q_0")));
        QVERIFY2(one.ok(), qPrintable(one ? QString() : one.error().toString()));
    }

    // A stop that is much shorter than a pixel column remains visible.
    void theStateLaneIsReadFromSummaries() {
        Opened opened(long_->path);
        const std::vector<int> needed = recordedLaneSignals(opened.store, opened.name);
        QCOMPARE(needed.size(), std::size_t{2});
        QVERIFY(recordedLane(opened.store, opened.name, {}).empty());
        QVERIFY(opened.store.want(this, {needed[0], needed[1], opened.signal}));
        const SeriesBuffer& history = opened.history();
        constexpr int kColumns = 1000;
        while (opened.store.sharpen(history, 0, history.end(), kColumns, HistoryFile::Effort::Turn)) {
        }
        const double begin = long_->timeOf(0) - 20;
        const double width = (long_->timeOf(kRows - 1) + 20 - begin) / kColumns;
        ColumnGrid grid;
        history.cut(begin, width, kColumns, grid);
        const std::vector<LaneSegment> lane = recordedLane(opened.store, opened.name, grid);
        QStringList labels;
        for (const LaneSegment& segment : lane) {
            labels << segment.label;
        }
        QCOMPARE(labels, QStringList({"Running", "Protective stop", "Running", "Brakes on"}));
        QVERIFY(std::abs(lane[0].start - long_->timeOf(0)) <= width);
        QVERIFY(std::abs(lane[1].start - long_->timeOf(kStop)) <= width);
        QVERIFY(lane[1].end - lane[1].start <= 2 * width);
        // A summary may extend over the boundary between two columns.
        QVERIFY(std::abs(lane[3].start - long_->timeOf(kRows / 2)) <= 2 * width);
        QVERIFY(std::abs(lane[3].end - long_->timeOf(kRows - 1)) <= width);
    }

    // Each part of the file holds 250 rows. The gap may be anywhere in a part.
    void noPictureShowsDataInAGap_data() {
        QTest::addColumn<std::uint64_t>("gap");
        QTest::addColumn<bool>("noteInGap");
        QTest::newRow("before a part") << std::uint64_t{50'000} << false;
        QTest::newRow("before a part that begins with a note") << std::uint64_t{50'000} << true;
        QTest::newRow("after the first row of a part") << std::uint64_t{50'001} << false;
        QTest::newRow("within a part") << std::uint64_t{50'100} << false;
        QTest::newRow("before the last row of a part") << std::uint64_t{50'249} << true;
    }

    void noPictureShowsDataInAGap() {
        QFETCH(std::uint64_t, gap);
        QFETCH(bool, noteInGap);
        constexpr std::uint64_t kFew = 70'000;
        const Long made(kFew, gap, noteInGap);
        Opened opened(made.path);
        const std::vector<int> needed = recordedLaneSignals(opened.store, opened.name);
        QVERIFY(opened.store.want(this, {needed[0], needed[1], opened.signal}));
        const SeriesBuffer& history = opened.history();
        QVERIFY(history.isInFile());
        const double begin = made.timeOf(gap - 1);
        const double end = made.timeOf(gap);
        constexpr int kColumns = 1000;
        ColumnGrid grid;
        // Zooms from the whole recording, which is drawn without its rows, to the gap alone.
        for (const double zoom : {1.0, 4.0, 30.0}) {
            const double span = (made.timeOf(kFew - 1) - kBegin) / zoom;
            const double width = span / kColumns;
            const double start = zoom == 1 ? kBegin : begin - span / 2;
            history.cut(start, width, kColumns, grid);
            bool more = true;
            for (int turn = 0; more && turn < 1000; ++turn) {
                more =
                    opened.store.sharpen(history, grid.edges.front() - 1, grid.edges.back() + 1, kColumns,
                                         turn == 0 ? HistoryFile::Effort::Draft : HistoryFile::Effort::Turn);
                history.cut(start, width, kColumns, grid);
                const std::vector<MinMax> drawn =
                    history.envelope(opened.store.column(opened.signal), start, start + span, kColumns);
                const std::vector<LaneSegment> lane = recordedLane(opened.store, opened.name, grid);
                int columns = 0;
                for (int c = 0; c < kColumns; ++c) {
                    const double left = start + c * width;
                    constexpr double kAccuracy = 0.01;  // accuracy of times computed from marks [s]
                    if (left < begin + kAccuracy || left + width > end - kAccuracy) {
                        continue;
                    }
                    ++columns;
                    QVERIFY2(drawn[static_cast<std::size_t>(c)].isEmpty(),
                             qPrintable(QStringLiteral("zoom %1, column %2").arg(zoom).arg(c)));
                    const auto state = std::find_if(lane.begin(), lane.end(), [&](const LaneSegment& one) {
                        return one.end > left + width / 2;
                    });
                    QVERIFY(state != lane.end() && state->kind == LaneKind::NoData);
                }
                QVERIFY(columns >= 3);
            }
            QVERIFY(!more);
        }
    }

    // The gap is wider than a pixel column.
    void theStateLaneShowsAGap() {
        Opened opened(long_->path);
        const std::vector<int> needed = recordedLaneSignals(opened.store, opened.name);
        QVERIFY(opened.store.want(this, {needed[0], needed[1], opened.signal}));
        const SeriesBuffer& history = opened.history();
        ColumnGrid grid;
        const auto cut = [&] { history.cut(long_->timeOf(kGap) - 3, 0.01, 600, grid); };
        cut();
        while (opened.store.sharpen(history, grid.edges.front(), grid.edges.back(), 600,
                                    HistoryFile::Effort::Turn)) {
        }
        cut();
        const std::vector<LaneSegment> lane = recordedLane(opened.store, opened.name, grid);
        QCOMPARE(lane.size(), std::size_t{3});
        QVERIFY(lane[0].kind == LaneKind::Idle && lane[2].kind == LaneKind::Idle);
        QVERIFY(lane[1].kind == LaneKind::NoData);
        QVERIFY(std::abs(lane[1].start - long_->timeOf(kGap - 1)) <= 0.02);
        QVERIFY(std::abs(lane[1].end - long_->timeOf(kGap)) <= 0.02);
    }
};

QTEST_GUILESS_MAIN(TestHistoryFile)
#include "tst_history_file.moc"
