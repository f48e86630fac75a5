// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of the plots that work without a window: time window, scale, lane, feed, CSV.
#include <QFile>
#include <QGraphicsScene>
#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "robot/core/clock.h"
#include "robot/station/history/history_export.h"
#include "robot/station/history/history_feed.h"
#include "robot/station/history/lane_text.h"
#include "robot/station/history/signal_lane.h"
#include "robot/station/history/state_lane.h"
#include "tests/support/sample_stream.h"
#include "widgets/plots/axis_range.h"
#include "widgets/plots/curve.h"
#include "widgets/plots/curve_raster.h"
#include "widgets/plots/plot_layout.h"
#include "widgets/plots/time_window.h"

using namespace tiller;

namespace {

struct Fed {
    SignalStore store;
    const SeriesBuffer& history = store.live();
    HistoryFeed feed{store};
    test::SampleStream stream;

    void add(double time, std::uint64_t sequence, double fz = 0) {
        stream.set(stream.add(time, sequence), "actual_TCP_force_2", fz);
    }
    int frame() {
        return stream.frame([this](const SampleBatch& batch) { return feed.take(batch); });
    }
};

SessionState running() {
    SessionState state;
    state.link = LinkState::Live;
    state.sequence = 1;
    state.robotMode = RobotMode::Running;
    state.safetyMode = SafetyMode::Normal;
    return state;
}

}  // namespace

class TestPlotModels : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // ---- time window
    void followsTheNewestSample() {
        TimeWindow window;
        window.setHistory(0, 100);
        QCOMPARE(window.end(), 100.0);
        QCOMPARE(window.start(), 70.0);
        window.setHistory(0, 101);
        QCOMPARE(window.end(), 101.0);
        QCOMPARE(window.behind(), 0.0);
    }
    void pauseKeepsTheViewWhileDataContinue() {
        TimeWindow window;
        window.setHistory(0, 100);
        window.pause();
        window.setHistory(0, 142);
        QCOMPARE(window.end(), 100.0);
        QCOMPARE(window.behind(), 42.0);
        window.follow();
        QCOMPARE(window.end(), 142.0);
    }
    void scrollingBackStopsFollowingAndStaysInsideTheHistory() {
        TimeWindow window;
        window.setHistory(0, 100);
        window.scrollBy(-10);
        QVERIFY(!window.follows());
        QCOMPARE(window.end(), 90.0);
        window.scrollBy(-1000);
        QCOMPARE(window.start(), 0.0);
        window.scrollBy(1000);
        QCOMPARE(window.end(), 100.0);
    }
    void zoomKeepsTheMomentUnderThePointer() {
        TimeWindow window;
        window.setHistory(0, 1000);
        window.pause();
        window.scrollBy(-500);
        const double share = (490 - window.start()) / window.span();
        window.zoom(0.5, 490);
        QCOMPARE((490 - window.start()) / window.span(), share);
        QCOMPARE(window.span(), 15.0);
        window.zoom(1e9, 490);
        QCOMPARE(window.span(), TimeWindow::kLongest);
        window.zoom(1e-12, 490);
        QCOMPARE(window.span(), TimeWindow::kShortest);
    }

    // ---- scale
    void scaleEnclosesTheCurvesWithRoundValues_data() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        for (const auto& [low, high] : {std::pair(-20.0, 20.0),
                                        {0.0, 0.0},
                                        {-3.0, 180.0},
                                        {1e-4, 2e-4},
                                        {-1e6, -9e5},
                                        {40.0, 41.0},
                                        {-0.1, 7.0}}) {
            QTest::addRow("%g ... %g", low, high) << low << high;
        }
    }
    void scaleEnclosesTheCurvesWithRoundValues() {
        QFETCH(double, low);
        QFETCH(double, high);
        for (const int lines : {2, 3, 4, 6}) {
            AxisRange range(0.5);
            range.setMostLines(lines);
            range.reset(low, high);
            QVERIFY(range.min() <= low);
            QVERIFY(range.max() >= high);
            QVERIFY(range.step() >= 0.5);
            const double first = std::ceil(range.min() / range.step());
            const double last = std::floor(range.max() / range.step());
            QVERIFY2(last - first >= 1, "fewer than two grid lines");
            QVERIFY2(last - first < lines, "too many grid lines");
            const double mantissa = range.step() / std::pow(10, std::floor(std::log10(range.step()) + 1e-9));
            QVERIFY(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 ||
                    std::abs(mantissa - 5) < 1e-6);
        }
    }
    void aScaleOfHugeValuesIsFound() {
        for (const auto& [low, high] : std::initializer_list<std::pair<double, double>>{
                 {1e17, 1e17}, {-1, 1e17}, {3e38, 3e38}, {-3e38, 3e38}, {1e300, 1e300}, {-1e307, 1e307}}) {
            AxisRange range(0.001);
            range.reset(low, high);
            QVERIFY2(range.min() < range.max(), qPrintable(QString::number(low)));
            QVERIFY(std::isfinite(range.step()) && range.step() > 0);
        }
    }
    void scaleGrowsImmediatelyAndShrinksWithADelay() {
        AxisRange range(1);
        range.reset(-2, 2);
        QVERIFY(range.fit(-2, 30, 0.025));
        const double max = range.max();
        QVERIFY(max >= 30);
        double waited = 0;
        while (!range.fit(-2, 2, 0.025)) {
            waited += 0.025;
            QVERIFY(waited < 10);
            QCOMPARE(range.max(), max);
        }
        QVERIFY(waited > AxisRange::kShrinkDelay - 0.1);
        QVERIFY(range.max() < max);
    }
    void scaleDoesNotJitterWithNoise() {
        AxisRange range(1);
        range.reset(-10, 10);
        int changes = 0;
        for (int i = 0; i < 4000; ++i) {
            changes += range.fit(-10 - 0.5 * (i % 7), 10 + 0.5 * (i % 5), 0.025) ? 1 : 0;
        }
        QVERIFY2(changes <= 1, qPrintable(QString::number(changes)));
    }
    void aScaleZoomedByHandStaysUntilItIsReleased() {
        AxisRange range(1);
        range.reset(-8, 9);
        const double span = range.max() - range.min();
        range.zoom(0.5, 2);
        QVERIFY(range.isHeld());
        QVERIFY(std::abs(range.max() - range.min() - span / 2) < 1e-9);
        QVERIFY(range.min() < 2 && range.max() > 2);
        QVERIFY(range.step() > 0 && range.step() < range.max() - range.min());
        const double least = range.min();
        QVERIFY(!range.fit(-500, 500, 10));
        QVERIFY(!range.reset(-500, 500));
        QCOMPARE(range.min(), least);
        for (int i = 0; i < 200; ++i) {
            range.zoom(0.5, 2);
        }
        QVERIFY(range.max() > range.min());
        for (int i = 0; i < 400; ++i) {
            range.zoom(2, 2);
        }
        QVERIFY(range.max() - range.min() < 1e6);
        range.release();
        QVERIFY(range.reset(-8, 9));
        QVERIFY(std::abs(range.max() - range.min() - span) < 1e-9);
    }

    void scaleIgnoresNonFiniteValues() {
        AxisRange range(1);
        range.reset(-2, 2);
        const double max = range.max();
        QVERIFY(
            !range.fit(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 1));
        QVERIFY(!range.fit(0, std::numeric_limits<double>::infinity(), 1));
        QVERIFY(!range.fit(std::numeric_limits<double>::quiet_NaN(), 1, 1));
        QCOMPARE(range.max(), max);
    }

    // ---- curves

    void noSpikeIsLostAtAnyZoom_data() {
        QTest::addColumn<QList<qreal>>("dashes");
        QTest::newRow("solid") << QList<qreal>();
        QTest::newRow("dashed") << QList<qreal>{12, 6};
        QTest::newRow("dashed and dotted") << QList<qreal>{6, 2.5, 1.5, 2.5};
    }
    void noSpikeIsLostAtAnyZoom() {
        QFETCH(QList<qreal>, dashes);
        constexpr int kSamples = 200'000;
        constexpr int kColumns = 640;
        constexpr int kRows = 100;
        constexpr int kSpikes = 40;
        constexpr double kStep = 0.002;
        constexpr float kHigh = 8;
        std::mt19937 random(19);
        std::uniform_int_distribution<int> place(0, kSamples / kSpikes - 1);
        std::uniform_real_distribution<float> noise(-0.05F, 0.05F);
        std::vector<int> spikes;
        for (int i = 0; i < kSpikes; ++i) {
            spikes.push_back(i * (kSamples / kSpikes) + place(random));
        }
        SeriesBuffer history(1);
        for (int i = 0; i < kSamples; ++i) {
            const bool isSpike = std::binary_search(spikes.begin(), spikes.end(), i);
            const float value = isSpike ? kHigh : noise(random);
            QVERIFY(history.append(i * kStep, std::span(&value, 1)));
        }
        std::vector<std::unique_ptr<Curve>> curves;
        curves.push_back(std::make_unique<Curve>(0));
        QPen pen(Qt::red, 1.6);
        if (!dashes.isEmpty()) {
            pen.setDashPattern(dashes);
        }
        curves.front()->setPen(pen);
        QGraphicsScene scene;
        auto* const sheet = new CurveRaster(curves, nullptr);
        scene.addItem(sheet);
        std::uniform_real_distribution<double> exponent(std::log(2.0), std::log(kSamples * kStep));
        ColumnGrid grid;
        for (int round = 0; round < 60; ++round) {
            const double span = round == 0 ? kSamples * kStep : std::exp(exponent(random));
            const double width = span / kColumns;
            std::uniform_real_distribution<double> begin(0, kSamples * kStep - span);
            const double start = std::floor(begin(random) / width) * width;
            history.cut(start, width, kColumns, grid);
            curves.front()->sample(history, 0, grid);
            sheet->setView({0, 0, kColumns, kRows}, start, start + span, -10, 10);
            QImage picture(kColumns, kRows, QImage::Format_ARGB32_Premultiplied);
            picture.fill(Qt::transparent);
            QPainter painter(&picture);
            sheet->paint(&painter, nullptr, nullptr);
            painter.end();
            constexpr int kSpikeRow = kRows / 10;  // 8 in a range of -10 ... 10
            for (const int spike : spikes) {
                const double column = (spike * kStep - start) / width;
                if (column < 1 || column > kColumns - 2) {
                    continue;
                }
                // A spike is drawn in its own column or, if a column contains many samples, at the edge of a
                // neighbouring column.
                bool isDrawn = false;
                bool isKnown = false;
                for (int x = static_cast<int>(column) - 1; x <= static_cast<int>(column) + 1; ++x) {
                    isKnown = isKnown || curves.front()->columns()[static_cast<std::size_t>(x)].high ==
                                             static_cast<double>(kHigh);
                    for (int y = kSpikeRow - 1; y <= kSpikeRow + 1; ++y) {
                        isDrawn = isDrawn || qAlpha(picture.pixel(x, y)) > 60;
                    }
                }
                QVERIFY2(isKnown, qPrintable(QStringLiteral("round %1, column %2").arg(round).arg(column)));
                QVERIFY2(isDrawn, qPrintable(QStringLiteral("round %1, column %2").arg(round).arg(column)));
            }
        }
    }

    // ---- lane
    void laneMergesEqualValuesAndClipsToTheView() {
        StateLane lane;
        for (int i = 0; i <= 100; ++i) {
            const bool moving = i >= 40 && i < 70;
            lane.add(i * 0.1, moving ? LaneKind::Moving : LaneKind::Idle, moving ? "Jog X+" : "Idle");
        }
        QCOMPARE(lane.segments().size(), std::size_t{3});
        const auto seen = lane.visible(3, 9, 0);
        QCOMPARE(seen.size(), std::size_t{3});
        QCOMPARE(seen[0].start, 3.0);
        QCOMPARE(seen[0].end, 4.0);
        QCOMPARE(seen[1].label, QString("Jog X+"));
        QCOMPARE(seen[1].end, 7.0);
        QCOMPARE(seen[2].end, 9.0);
        QVERIFY(lane.visible(20, 30, 0).empty());
    }
    void laneCostsNoMoreThanItsPixels() {
        StateLane lane;
        for (int i = 0; i < 30000; ++i) {
            lane.add(i * 0.01, i % 2 == 0 ? LaneKind::Moving : LaneKind::Idle, {});
        }
        QVERIFY(lane.segments().size() <= StateLane::kMaxSegments);
        const auto seen = lane.visible(100, 300, 1.0);
        QVERIFY(seen.size() <= 202);
        for (std::size_t i = 1; i < seen.size(); ++i) {
            QVERIFY(seen[i].start >= seen[i - 1].end - 1e-9);
        }
        lane.forgetBefore(299);
        QVERIFY(lane.segments().size() <= 102);
    }
    void laneShowsTheRobotActivity() {
        SessionState state = running();
        QCOMPARE(laneEntry(state, {}).label, QString("At standstill"));
        state.moving = true;
        QCOMPARE(laneEntry(state, "X+").label, QString("Moving"));
        QVERIFY(laneEntry(state, {}).kind == LaneKind::Moving);
        state.jogActive = true;
        QCOMPARE(laneEntry(state, "X+").label, QString("Jog X+"));
        QCOMPARE(laneEntry(state, {}, "Step 3 (MoveL)").label, QString("Step 3 (MoveL)"));
        QVERIFY(laneEntry(state, {}, "Step 3 (MoveL)").kind == LaneKind::Moving);
        state.safetyMode = SafetyMode::ProtectiveStop;
        QCOMPARE(laneEntry(state, "X+").label, QString("Protective stop"));
        QCOMPARE(laneEntry(state, {}, "Step 3 (MoveL)").label, QString("Protective stop"));
        QVERIFY(laneEntry(state, {}).kind == LaneKind::Stopped);
        // If the data are late, the arm may be moving.
        state.quality.ageMs = 150;
        QVERIFY(laneEntry(state, {}).kind == LaneKind::NoData);
        QCOMPARE(laneEntry(state, {}).label, QString("Late data"));
        state = running();
        state.robotMode = RobotMode::PowerOff;
        QVERIFY(laneEntry(state, {}).kind == LaneKind::Off);
        state.link = LinkState::Lost;
        QVERIFY(laneEntry(state, {}).kind == LaneKind::NoData);
    }

    // ---- feed
    void samplesBecomeRowsInOrder() {
        Fed f;
        for (int i = 0; i < 10; ++i) {
            f.add(5 + i * 0.002, static_cast<std::uint64_t>(i) + 1, i);
        }
        QCOMPARE(f.frame(), 10);
        QCOMPARE(f.history.end(), std::int64_t{10});
        QCOMPARE(f.store.value(f.store.find("actual_TCP_force_2"), 9), 9.0);
        QCOMPARE(f.feed.gaps(), std::uint64_t{0});
        QCOMPARE(f.frame(), 0);
    }
    void missingFieldsAreNan() {
        Fed f;
        f.add(5, 1);
        f.frame();
        QVERIFY(std::isnan(f.store.value(f.store.find("actual_current_0"), 0)));
    }
    void aRingOverrunIsACountedGap() {
        Fed f;
        f.add(1.000, 1);
        f.add(1.002, 2);
        f.frame();
        f.add(9.000, 4001);
        f.add(9.002, 4002);
        f.stream.lost = 3998;
        f.frame();
        QCOMPARE(f.feed.overrun(), std::uint64_t{3998});
        QCOMPARE(f.feed.gaps(), std::uint64_t{1});
        QVERIFY(f.history.gapBefore(2));
        QVERIFY(!f.history.gapBefore(3));
    }
    void packetsSkippedByTheControllerAreAGap() {
        Fed f;
        f.add(1.000, 1);
        f.add(1.002, 2);
        f.add(1.100, 3);  // not counted as lost, but a gap in time
        f.frame();
        QVERIFY(f.history.gapBefore(2));
        f.stream.add(1.102, 4).lostBefore = 1;
        f.frame();
        QVERIFY(f.history.gapBefore(3));
    }
    void aReconnectIsAGap() {
        Fed f;
        f.add(1.000, 1);
        f.add(1.002, 2);
        f.stream.add(1.004, 3).connection = 2;
        f.frame();
        QVERIFY(!f.history.gapBefore(1));
        QVERIFY(f.history.gapBefore(2));
    }
    void dataContinueAfterAControllerRestartWithAGap() {
        Fed f;
        f.add(500.000, 1);
        f.add(500.002, 2);
        f.frame();
        f.feed.beginLink();
        f.add(0.002, 1);
        f.add(0.004, 2);
        f.frame();
        QCOMPARE(f.history.end(), std::int64_t{4});
        QVERIFY(f.history.gapBefore(2));
        QVERIFY(f.history.time(2) > 500.002);
        QCOMPARE(f.feed.plotTime(0.004), f.history.time(3));
    }
    // The controller's time does not show how long the connection was interrupted before a restart.
    void anOutageHasTheDurationOfTheLocalClock_data() {
        QTest::addColumn<double>("timeBehind");
        QTest::addColumn<bool>("newLink");
        QTest::newRow("restarted") << 0.002 << false;
        QTest::newRow("another robot, younger") << 3.0 << true;
        QTest::newRow("another robot, older") << 90'000.0 << true;
    }
    void anOutageHasTheDurationOfTheLocalClock() {
        QFETCH(double, timeBehind);
        QFETCH(bool, newLink);
        Fed f;
        const auto add = [&f](double time, std::uint64_t sequence, std::int64_t hostMs) {
            f.stream.add(time, sequence).hostTimeNs = hostMs * kNsPerMs;
        };
        add(500.000, 1, 10'000);
        add(500.002, 2, 10'002);
        f.frame();
        QVERIFY(f.feed.takeDataGaps().empty());
        if (newLink) {
            f.feed.beginLink();
        }
        add(timeBehind, newLink ? 1 : 3, 17'002);
        add(timeBehind + 0.002, newLink ? 2 : 4, 17'004);
        f.frame();
        QVERIFY(std::abs(f.history.time(2) - 507.002) < 1e-6);
        const auto silences = f.feed.takeDataGaps();
        QCOMPARE(silences.size(), std::size_t{1});
        QVERIFY(std::abs(silences[0].from - 500.002) < 1e-6);
        QVERIFY(std::abs(silences[0].to - 507.002) < 1e-6);
        QVERIFY(f.feed.takeDataGaps().empty());
    }

    // ---- additionally requested signals
    void additionalSignalsUseTheSameTimes() {
        Fed f;
        const int scalar = f.store.find("tcp_force_scalar");
        QVERIFY(scalar >= 0 && f.store.buffer(scalar) == nullptr);
        QSignalSpy asked(&f.store, &SignalStore::furtherFieldsChanged);
        QVERIFY(f.store.want(this, {scalar}));
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked[0][0].toStringList(), QStringList("tcp_force_scalar"));
        test::SampleStream further;
        further.layout = std::make_shared<const receive::SampleLayout>(
            std::vector<std::string>{"timestamp", "tcp_force_scalar"});
        const auto frame = [&](int from, int to, double start) {
            for (int i = from; i < to; ++i) {
                const double time = start + i * 0.002;
                f.add(time, static_cast<std::uint64_t>(i) + 1);
                further.set(further.add(time, static_cast<std::uint64_t>(i) + 1), "tcp_force_scalar", i);
            }
            f.frame();
            further.frame([&](const SampleBatch& batch) { return f.feed.takeExtra(batch); });
        };
        frame(0, 50, 100);
        QCOMPARE(f.store.valueAt(scalar, 100.02).value(), 10.0);
        QCOMPARE(f.store.valueAt(scalar, 100.0215).value(), 10.0);  // the previous value is kept
        // The controller time restarts with the new connection.
        f.feed.beginLink();
        frame(0, 50, 3);
        const double shown = f.feed.plotTime(3 + 49 * 0.002);
        QCOMPARE(f.store.valueAt(scalar, shown).value(), 49.0);
        QVERIFY(!f.store.valueAt(scalar, 100.15).has_value());
        // The last subscriber has unsubscribed.
        QVERIFY(f.store.want(this, {}));
        QCOMPARE(asked.last()[0].toStringList(), QStringList());
        QCOMPARE(f.store.valueAt(scalar, shown).value(), 49.0);
    }

    // ---- lanes of signals
    void aBitIsALaneAndNoChangeIsLost() {
        SignalStore store;
        const int bit = store.find("actual_digital_input_bits.3");
        QVERIFY(bit >= 0 && store.info(bit).isState());
        const auto column = static_cast<std::size_t>(store.column(bit));
        const auto valueAt = [](int i) {
            const double other = (i / 7) % 2 == 0 ? 1.0 : 0.0;  // a different bit
            const bool on = (i >= 20'000 && i < 30'000) || i == 40'000;
            return other + (on ? 8 : 0);
        };
        std::vector<SeriesBuffer::Row> rows;
        for (int i = 0; i < 50'000; ++i) {
            rows.push_back({i * 0.002, false});
        }
        store.appendLive(rows, [&](std::size_t c, std::size_t row) {
            return c == column ? valueAt(static_cast<int>(row)) : 0.0;
        });
        ColumnGrid grid;
        store.live().cut(0, 0.1, 1000, grid);
        const auto segments = signalSegments(store, bit, grid);
        QCOMPARE(segments.size(), std::size_t{5});
        QVERIFY(segments[0].kind == LaneKind::Low);
        QVERIFY(segments[1].kind == LaneKind::High);
        QCOMPARE(segments[1].label, QString("on"));
        QVERIFY(std::abs(segments[1].start - 40.0) < 0.11 && std::abs(segments[1].end - 60.0) < 0.11);
        QVERIFY2(segments[3].kind == LaneKind::Varied, "a pulse of one sample is not shown");
        QVERIFY(std::abs(segments[3].start - 80.0) < 0.11);
        const auto changes = store.changes(bit, 0, store.live().end());
        QCOMPARE(changes, (std::vector<std::int64_t>{20'000, 30'000, 40'000, 40'001}));
    }
    void aModeIsALaneWithItsNames() {
        SignalStore store;
        const int mode = store.find("robot_mode");
        const auto column = static_cast<std::size_t>(store.column(mode));
        std::vector<SeriesBuffer::Row> rows;
        for (int i = 0; i < 1000; ++i) {
            rows.push_back({i * 0.002, false});
        }
        store.appendLive(rows, [&](std::size_t c, std::size_t row) {
            return c == column ? (row < 500 ? 5.0 : 7.0) : 0.0;
        });
        ColumnGrid grid;
        store.live().cut(0, 0.0005, 4000, grid);  // finer than the samples
        const auto segments = signalSegments(store, mode, grid);
        QVERIFY(segments.size() >= 2);
        QCOMPARE(segments[0].label, store.info(mode).stateName(5));
        QCOMPARE(segments[1].label, store.info(mode).stateName(7));
        QVERIFY(segments[0].label != segments[1].label);
        QVERIFY(std::abs(segments[1].start - 1.0) < 0.001);
        QVERIFY2(segments.back().kind == LaneKind::NoData, "the lane shows data after the newest sample");
    }

    // ---- layout
    void anArrangementRoundTrips() {
        PlotLayout layout;
        layout.pages = {PageLayout::standard(),
                        {"Mine",
                         {{{"actual_q_0", "actual_qd_0"}, {"actual_qd_0"}, 0, 2}, {{}, {}, 1, 1}},
                         {"robot_mode"}}};
        layout.current = 1;
        layout.span = 120;
        layout.modelLimits = {.jointPosition = 0.02, .tcpPosition = 0, .current = 3.5};
        layout.tables["stamp,b"] = {.timeColumn = "stamp", .timeUnit = recording::TimeUnit::Nanoseconds};
        layout.tables["a;b"] = {
            .timeColumn = "", .separator = ';', .decimal = ',', .hasHeader = true, .rate = 12.5};
        const auto read = PlotLayout::fromJson(layout.toJson());
        QVERIFY(read.ok());
        QVERIFY(*read == layout);
    }
    void invalidArrangementsAreRefusedAndLongOnesTruncated() {
        for (const char* bad : {"", "{", "[]", "{}", "{\"pages\":[]}", "7"}) {
            QCOMPARE(PlotLayout::fromJson(bad).error().code, ErrorCode::FileCorrupt);
        }
        QByteArray many = "{\"pages\":[";
        for (int i = 0; i < 40; ++i) {
            many += (i == 0 ? "" : ",") + QByteArray(
                                              "{\"plots\":[{\"signals\":[\"x\",\"x\",3,null],\"column\":99,"
                                              "\"share\":-4}],\"lanes\":7}");
        }
        many += "],\"current\":1e300,\"span\":-1,\"model_limits\":{\"joint\":-2,\"force\":\"x\"}}";
        const auto read = PlotLayout::fromJson(many);
        QVERIFY(read.ok());
        QCOMPARE(read->pages.size(), PlotLayout::kMaxPages);
        QCOMPARE(read->current, PlotLayout::kMaxPages - 1);
        QCOMPARE(read->modelLimits.jointPosition, 0.0);
        QCOMPARE(read->modelLimits.force, divergence::Limits().force);
        QCOMPARE(read->pages[0].panes[0].shown, QStringList("x"));
        QCOMPARE(read->pages[0].panes[0].column, PlotLayout::kMaxColumns - 1);
        QVERIFY(read->pages[0].panes[0].share > 0 && read->span > 0);
        // Any modified text results in a layout or an error.
        PlotLayout good;
        good.pages.append({"Mine", {{{"actual_q_0"}, {}, 0, 2}}, {"robot_mode"}});
        const QByteArray text = good.toJson();
        std::mt19937 random(1);
        for (int round = 0; round < 1000; ++round) {
            QByteArray broken = text;
            for (int change = 0; change < 3; ++change) {
                broken[std::uniform_int_distribution<qsizetype>(0, broken.size() - 1)(random)] =
                    static_cast<char>(random() % 256);
            }
            if (const auto result = PlotLayout::fromJson(broken)) {
                QVERIFY(!result->pages.isEmpty() && result->current < result->pages.size());
            }
        }
    }

    // ---- CSV
    void csvHasTheShownSamplesUnderTheirRecordingNames() {
        QTemporaryDir folder;
        Fed f;
        for (int i = 0; i < 100; ++i) {
            f.add(10 + i * 0.002, static_cast<std::uint64_t>(i) + 1, i * 0.5);
        }
        f.frame();
        std::vector<int> shown;
        for (const char* key :
             {"actual_TCP_force_0", "actual_TCP_force_1", "actual_TCP_force_2", "actual_current_5"}) {
            shown.push_back(f.store.find(key));
        }
        const QString path = folder.filePath("range.csv");
        const auto rows = exportCsv(f.store, shown, 10.0199, 10.0401, path);
        QVERIFY(rows.ok());
        QCOMPARE(*rows, std::int64_t{11});
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), 12);
        QCOMPARE(lines[0],
                 QByteArray(
                     "timestamp,actual_TCP_force_0,actual_TCP_force_1,actual_TCP_force_2,actual_current_5"));
        QCOMPARE(lines[1], QByteArray("10.02,,,5,"));
        QCOMPARE(lines[11].split(',')[3], QByteArray("10"));
    }
    void aFailedCsvExportIsReportedAndKeepsTheOldFile() {
        Fed f;
        QTemporaryDir folder;
        const QString path = folder.filePath("old.csv");
        QFile old(path);
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write("mine");
        old.close();
        QCOMPARE(exportCsv(f.store, {}, 0, 1, path).error().code, ErrorCode::InvalidArgument);
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("mine"));
        f.add(0.5, 1);
        f.frame();
        const Error error = exportCsv(f.store, {}, 0, 1, folder.filePath("no/such/folder/x.csv")).error();
        QCOMPARE(error.code, ErrorCode::FileNotWritable);
        QVERIFY(!error.controllerMessage.isEmpty());
    }
};

QTEST_MAIN(TestPlotModels)
#include "tst_plot_models.moc"
