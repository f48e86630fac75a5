// SPDX-License-Identifier: GPL-3.0-or-later
//
// A protective stop is opened with one click on its row in the log, and replayed: plots, view, inputs and
// outputs, and log show the same time while live data and a recording continue. Uses the real window, real
// events and real sockets, with the simulated robot in virtual time.

#include <QDir>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QWindow>
#include <functional>
#include <memory>
#include <utility>

#include "resources/resources.h"
#include "robot/core/spatial.h"
#include "robot/script/script_client.h"
#include "robot/station/capture/incident_watch.h"
#include "robot/station/history/plot_marks.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/station.h"
#include "tests/support/pictures.h"
#include "tests/support/window_bench.h"
#include "widgets/common/replay_band.h"
#include "widgets/io/io_channel.h"
#include "widgets/io/io_tab.h"
#include "widgets/log/log_model.h"
#include "widgets/log/log_tab.h"
#include "widgets/plots/comparison_band.h"
#include "widgets/plots/plot_dock.h"
#include "widgets/plots/plot_pages.h"
#include "widgets/plots/plot_view.h"
#include "widgets/scene/scene_dock.h"
#include "widgets/scene/scene_view.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr int kWaitTimeoutMs = 60'000;

struct Bench : WindowBench {
    std::unique_ptr<script::ScriptClient> pendant;

    Bench() {
        window.keepIncidentsIn(folder.filePath("Incidents"));
        show(QSize(1600, 900));
    }
    const SessionState& state() { return window.session().state(); }
    PlotDock& plots() { return find<PlotDock>("plots"); }
    SceneDock& scene() { return find<SceneDock>("view"); }
    IoTab& io() { return find<IoTab>("io"); }
    LogTab& log() { return find<LogTab>("log"); }
    QTableView& logTable() { return find<QTableView>("log.table"); }
    const IncidentWatch& watch() { return *window.station().incidents(); }

    /// Advances virtual time until the condition is true.
    bool within(const std::function<bool()>& condition) {
        QElapsedTimer waited;
        waited.start();
        while (!condition() && waited.elapsed() < kWaitTimeoutMs) {
            cell.advanceMs(16);
            QTest::qWait(1);
        }
        return condition();
    }
    /// Advances virtual time until the black box has received this number of packets. The thread of the black
    /// box can lag behind virtual time.
    bool hasKept(std::uint64_t packets) {
        QElapsedTimer waited;
        waited.start();
        while (watch().packets() < packets && waited.elapsed() < kWaitTimeoutMs) {
            const std::uint64_t before = watch().packets();
            cell.advanceMs(100);
            static_cast<void>(
                QTest::qWaitFor([&] { return watch().packets() >= before + 49; }, before == 0 ? 20 : 5000));
        }
        return watch().packets() >= packets;
    }
    /// Rotates the base by this angle [rad].
    bool move(double by) {
        pendant = std::make_unique<script::ScriptClient>(
            cell.robot.listenAddress(), script::kPrimaryPort + cell.robot.options().portOffset);
        const auto testTimeout = [] { return Deadline::after(std::chrono::seconds(20)); };
        return pendant->connect(testTimeout()).ok() &&
               pendant
                   ->send(QStringLiteral("def others():\nq = get_actual_joint_positions()\nq[0] = q[0] + %1\n"
                                         "movej(q, a=2, v=0.5)\nend\n")
                              .arg(by),
                          testTimeout())
                   .ok() &&
               within([this] { return state().moving; });
    }
    QPoint at(double time) {
        PlotView& view = plots().view();
        return {static_cast<int>(std::lround(view.xAt(time))), 80};
    }
    /// Drags cursor A with the mouse.
    void dragCursor(double to) {
        PlotView& view = plots().view();
        QWidget* viewport = view.viewport();
        QTest::mousePress(viewport, Qt::LeftButton, {}, at(*view.cursor(PlotView::Cursor::A)));
        QTest::mouseMove(viewport, at(to) + QPoint(9, 0));
        QTest::mouseMove(viewport, at(to));
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, at(to));
    }
    /// The value of a signal at cursor A.
    /// recording  name of the recording; empty: the history
    double valueAtA(const QString& recording, const char* component) {
        const double time = plots().view().cursor(PlotView::Cursor::A).value();
        const receive::Sample sample = plots().store().sampleAt(recording, time);
        const auto place = sample.isEmpty() ? std::nullopt : sample.layout->indexOfComponent(component);
        return place ? sample.at(*place) : std::numeric_limits<double>::quiet_NaN();
    }
};

}  // namespace

class TestIncident : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void oneClickOpensTheRecordingAtTheStop();
    void theScrubberMovesAllViewsTogether();
    void aReplayMovesNoKey();
    void backToLiveMovesNoButtonUnderThePointer();
    void theLogFollowsAgainAfterBackToLive();
    void armAndModelDifferWhereTheArmWasPushed();
};

void TestIncident::oneClickOpensTheRecordingAtTheStop() {
    Bench bench;
    QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
    QVERIFY(bench.hasKept(200));
    bench.cell.robot.setDigitalInput(3, true);
    QVERIFY(bench.move(1.0));
    QVERIFY(bench.hasKept(bench.watch().packets() + 200));
    bench.cell.robot.protectiveStop();
    QVERIFY(bench.within([&] { return bench.state().safetyMode == SafetyMode::ProtectiveStop; }));
    bench.cell.robot.setDigitalInput(3, false);
    QVERIFY(bench.hasKept(bench.watch().packets() + 5200));  // the incident also includes later packets
    bench.window.showTab("log");
    QTableView& table = bench.logTable();
    int row = -1;
    QVERIFY(bench.within([&] {
        for (int i = 0; i < table.model()->rowCount(); ++i) {
            if (!table.model()->index(i, 0).data(LogModel::RecordingRole).toString().isEmpty()) {
                row = i;
            }
        }
        return row >= 0;
    }));

    const QModelIndex open = table.model()->index(row, LogModel::Open);
    QCOMPARE(open.data().toString(), QString("Open"));
    const QString name = QFileInfo(open.data(LogModel::RecordingRole).toString()).fileName();
    table.scrollTo(open);
    QVERIFY(!table.visualRect(open).isEmpty());
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(open).center());
    QVERIFY(bench.within([&] { return bench.plots().replay().has_value(); }));

    // The plots show the recording, with cursor A exactly at the packet of the stop.
    PlotView& view = bench.plots().view();
    QCOMPARE(view.page().name, name);
    const double stop = view.cursor(PlotView::Cursor::A).value();
    QVERIFY(view.window().start() < stop && stop < view.window().end());
    QCOMPARE(bench.valueAtA(name, "safety_mode"), 3.0);
    const double before =
        bench.plots()
            .store()
            .sampleAt(name, stop - 0.001)
            .at(*bench.plots().store().sampleAt(name, stop).layout->indexOfComponent("safety_mode"));
    QCOMPARE(before, 1.0);
    // For a stop without a cause, arm and model agree.
    auto& comparison = bench.find<ComparisonBand>("plots.comparison");
    QVERIFY(bench.within([&] { return comparison.words().contains("The motion matches"); }));
    QVERIFY2(comparison.details().contains("at all times"), qPrintable(comparison.details()));
    // The recording is placed at its original time, where the live data have the same values.
    QVERIFY(std::abs(bench.valueAtA({}, "actual_q_0") - bench.valueAtA(name, "actual_q_0")) < 0.01);
    // The view shows the past position of the arm, marked as a replay.
    const Replay& moment = bench.plots().replay();
    QCOMPARE(moment->source, name);
    QVERIFY(bench.scene().view().replay().has_value());
    QCOMPARE(bench.scene().view().replay()->q[0], bench.valueAtA(name, "actual_q_0"));
    auto& band = bench.find<ReplayBand>("view.replay");
    QVERIFY(band.isVisible() && band.words().contains("REPLAY") && band.words().contains(name));
    // Input 3 has been switched off since the stop. The replay shows its state at the stop.
    QCOMPARE(bench.io().input(3)->state(), IoChannel::State::On);
    // The log shows the entries in the file, with the entry of the stop selected.
    QVERIFY(bench.find<ReplayBand>("log.replay").isVisible());
    QVERIFY2(table.currentIndex().isValid(), qPrintable(bench.log().shownText()));

    // Signals of a file are not saved with the arrangement.
    const PlotLayout kept = PlotLayout::fromJson(bench.plots().arrangement()).value();
    QCOMPARE(kept.pages.size(), qsizetype(bench.plots().pages().count() - 1));
    QCOMPARE(kept.current, 0);

    // A second click shows the page again without opening it twice.
    const int pages = bench.plots().pages().count();
    bench.plots().endReplay();
    QVERIFY(!bench.plots().replay());
    QVERIFY(!bench.find<ReplayBand>("log.replay").isVisible());
    QCOMPARE(bench.io().input(3)->state(), IoChannel::State::Off);
    const QModelIndex again = table.model()->index(row, LogModel::Open);
    // Update the layout of the page first, because a click would miss a row that moves at the same time.
    int height = -1;
    QVERIFY(bench.within([&] {
        table.scrollTo(again);
        return std::exchange(height, table.viewport()->height()) == table.viewport()->height() &&
               table.viewport()->rect().contains(table.visualRect(again).center());
    }));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(again).center());
    QVERIFY(bench.within([&] { return bench.plots().replay().has_value(); }));
    QCOMPARE(bench.plots().pages().count(), pages);
    QCOMPARE(bench.plots().view().cursor(PlotView::Cursor::A), std::optional(stop));
}

void TestIncident::theScrubberMovesAllViewsTogether() {
    Bench bench;
    QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
    bench.window.session().journal().add(Severity::Info, QStringLiteral("before all"), Origin::Operator);
    bench.cell.advanceMs(1000);
    const double early = bench.plots().history().lastTime();
    bench.cell.robot.setDigitalInput(2, true);
    bench.cell.advanceMs(100);
    bench.window.session().journal().add(Severity::Info, QStringLiteral("input is on"), Origin::Operator);
    QVERIFY(bench.move(0.4));
    QVERIFY(bench.within([&] { return !bench.state().moving; }));
    bench.cell.robot.setDigitalInput(2, false);
    bench.cell.advanceMs(1000);
    const double now = bench.plots().history().lastTime();

    // A recording continues during the whole test.
    auto& record = bench.find<QToolButton>("plots.record");
    RecordingChoice choice;
    choice.folder = bench.folder.filePath("recorded");
    bench.plots().setRecordingChoice(choice);
    QTest::mouseClick(&record, Qt::LeftButton);
    QVERIFY(bench.within([&] { return bench.state().recording.active; }));

    // A cursor on live data is not a replay. A cursor on paused data is a replay.
    bench.window.showTab("io");
    PlotView& view = bench.plots().view();
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_A);
    QVERIFY(!bench.plots().replay());
    QTest::mouseClick(&bench.find<QToolButton>("plots.pause"), Qt::LeftButton);
    QVERIFY(bench.plots().replay().has_value());
    QVERIFY(bench.find<ReplayBand>("io.replay").isVisible());

    // A pixel is about 40 ms wide, so place the cursor well before the input change.
    bench.dragCursor(early - 0.3);
    QCOMPARE(bench.plots().replay()->time, view.cursor(PlotView::Cursor::A).value());
    const double q0 = bench.scene().view().replay()->q[0];
    QVERIFY2(std::abs(q0 - bench.state().q[0]) > 0.3, "the replay shows the current position of the arm");
    QCOMPARE(bench.io().input(2)->state(), IoChannel::State::Off);
    bench.window.showTab("log");
    const auto textAtCursor = [&] {
        const QModelIndex index = bench.logTable().currentIndex();
        return index.siblingAtColumn(LogModel::Text).data().toString();
    };
    const QString atFirst = textAtCursor();

    // Arrow keys also move the cursor. Move it until the input is on.
    QElapsedTimer waited;
    waited.start();
    view.setFocus();
    while (bench.io().input(2)->state() != IoChannel::State::On && waited.elapsed() < kWaitTimeoutMs) {
        QTest::keyClick(&view, Qt::Key_Right);
    }
    QCOMPARE(bench.valueAtA({}, "actual_digital_input_bits"), 4.0);
    bench.dragCursor(now - 1.5);
    QVERIFY(std::abs(bench.scene().view().replay()->q[0] - q0) > 0.1);
    QVERIFY2(textAtCursor() != atFirst, qPrintable(atFirst));

    // Outputs cannot be switched during a replay: a click sends no request to the robot.
    bench.window.showTab("io");
    const std::uint64_t outputs = bench.state().digitalOutputs;
    QTest::mouseClick(bench.io().output(0), Qt::LeftButton);
    bench.cell.advanceMs(200);
    QCOMPARE(bench.state().digitalOutputs, outputs);

    // Live data have continued.
    const std::uint64_t rows = bench.state().recording.rows;
    QVERIFY(bench.within([&] { return bench.state().recording.rows > rows; }));
    QVERIFY(bench.plots().history().lastTime() > now);
    QVERIFY(bench.plots().replay().has_value());

    QTest::mouseClick(&bench.find<QToolButton>("io.replay.live"), Qt::LeftButton);
    QVERIFY(!bench.plots().replay());
    QVERIFY(view.window().follows());
    QVERIFY(!bench.scene().view().replay());
    QVERIFY(!bench.find<ReplayBand>("io.replay").isVisible());
    QTest::mouseClick(&record, Qt::LeftButton);
    QVERIFY(bench.within([&] { return !bench.state().recording.active; }));
}

/// After "Back to live", the log scrolls to new rows again, although its replay band stays visible while the
/// pointer is on it.
void TestIncident::theLogFollowsAgainAfterBackToLive() {
    Bench bench;
    QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
    for (int i = 0; i < 60; ++i) {
        bench.window.session().journal().add(Severity::Info, QStringLiteral("line %1").arg(i),
                                             Origin::Operator);
    }
    bench.window.showTab("log");
    PlotView& view = bench.plots().view();
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_A);
    QTest::mouseClick(&bench.find<QToolButton>("plots.pause"), Qt::LeftButton);
    auto& band = bench.find<ReplayBand>("log.replay");
    QVERIFY(bench.within([&] { return band.isVisible() && band.height() >= band.sizeHint().height(); }));
    QWindow* window = bench.window.windowHandle();
    const auto& live = bench.find<QToolButton>("log.replay.live");
    const QPoint place = live.mapTo(&bench.window, live.rect().center());
    QTest::mouseMove(window, place);
    QTest::mouseClick(window, Qt::LeftButton, {}, place);
    QVERIFY(bench.within([&] { return !bench.plots().replay().has_value(); }));
    QVERIFY(band.isVisible());
    const QScrollBar* bar = bench.logTable().verticalScrollBar();
    int before = bar->maximum();
    for (int i = 0; i < 3; ++i) {
        bench.window.session().journal().add(Severity::Info, QStringLiteral("later %1").arg(i),
                                             Origin::Operator);
        // The scroll bar includes the new row only after the next layout update.
        QVERIFY(bench.within([&] { return bar->maximum() > before; }));
        QVERIFY(bench.within([&] { return bar->value() == bar->maximum(); }));
        before = bar->maximum();
    }
}

void TestIncident::backToLiveMovesNoButtonUnderThePointer() {
    Bench bench;
    QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
    PlotView& view = bench.plots().view();
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_A);
    QTest::mouseClick(&bench.find<QToolButton>("plots.pause"), Qt::LeftButton);
    QVERIFY(bench.plots().replay().has_value());
    auto& band = bench.find<ReplayBand>("view.replay");
    QVERIFY(bench.within([&] { return band.isVisible(); }));
    const int height = bench.scene().view().height();
    // Use the mouse, with the pointer over the button.
    QWindow* window = bench.window.windowHandle();
    const auto& live = bench.find<QToolButton>("view.replay.live");
    const QPoint place = live.mapTo(&bench.window, live.rect().center());
    QTest::mouseMove(window, place);
    QTest::mouseClick(window, Qt::LeftButton, {}, place);
    QVERIFY(bench.within([&] { return !bench.plots().replay().has_value(); }));
    QVERIFY(band.words().isEmpty());
    bench.cell.advanceMs(100);
    QCOMPARE(bench.scene().view().height(), height);
    QVERIFY(bench.window.childAt(place) == &band || bench.window.childAt(place)->parentWidget() == &band);
    QTest::mouseDClick(window, Qt::LeftButton, {}, place);  // a second click must have no effect
    QVERIFY(!bench.plots().replay().has_value());
    QCOMPARE(bench.scene().view().height(), height);
    QTest::mouseMove(window, bench.scene().view().mapTo(&bench.window, QPoint(40, 40)));
    QVERIFY(bench.within([&] { return !band.isVisible(); }));
    QVERIFY(bench.scene().view().height() > height);
}

// The pause button and the buttons in the view remain under the pointer.
void TestIncident::aReplayMovesNoKey() {
    Bench bench;
    QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
    bench.window.showTab("io");
    bench.cell.advanceMs(1000);
    PlotView& view = bench.plots().view();
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_A);
    const QWidgetList keys{&bench.find<QToolButton>("scene.fit"), &bench.find<QToolButton>("plots.pause"),
                           &bench.find<QLineEdit>("io.search")};
    // A panel at its minimum height needs the same height with and without the band.
    const QWidgetList panels{&bench.scene(), &bench.io()};
    const auto measures = [&] {
        QList<QRect> all;
        for (const QWidget* key : keys) {
            all << QRect(key->mapTo(&bench.window, QPoint()), key->size());
        }
        for (const QWidget* panel : panels) {
            all << QRect(0, 0, 1, panel->minimumSizeHint().height());
        }
        return all;
    };
    bench.cell.advanceMs(100);
    QTest::qWait(1);
    const QList<QRect> live = measures();
    auto& pause = bench.find<QToolButton>("plots.pause");
    QTest::mouseClick(&pause, Qt::LeftButton);
    QVERIFY(bench.plots().replay().has_value());
    auto& band = bench.find<ReplayBand>("view.replay");
    // Wait for the layout update.
    QVERIFY(bench.within([&] { return band.isVisible() && band.height() >= band.sizeHint().height(); }));
    QCOMPARE(measures(), live);
    QTest::mouseClick(&bench.find<QToolButton>("view.replay.live"), Qt::LeftButton);
    QVERIFY(bench.within([&] { return !band.isVisible(); }));
    QTest::qWait(1);
    QCOMPARE(measures(), live);
}

// An external force acts on the moving arm. The controller stops the arm half a second later. The time of the
// force must be marked.
void TestIncident::armAndModelDifferWhereTheArmWasPushed() {
    Bench bench;
    QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
    QVERIFY(bench.hasKept(200));
    QVERIFY(bench.move(2.0));
    QVERIFY(bench.hasKept(bench.watch().packets() + 200));
    bench.cell.robot.pressHand({{0, 0, -80}, {0, 0, 0}});
    QVERIFY(bench.hasKept(bench.watch().packets() + 250));
    bench.cell.robot.protectiveStop();
    QVERIFY(bench.within([&] { return bench.state().safetyMode == SafetyMode::ProtectiveStop; }));
    bench.cell.robot.pressHand({});
    QVERIFY(bench.hasKept(bench.watch().packets() + 5200));
    bench.window.showTab("log");
    QTableView& table = bench.logTable();
    const auto rowOf = [&](const char* words) {
        for (int i = 0; i < table.model()->rowCount(); ++i) {
            const bool openable =
                !table.model()->index(i, 0).data(LogModel::RecordingRole).toString().isEmpty();
            if (openable && table.model()->index(i, LogModel::Text).data().toString().contains(words)) {
                return i;
            }
        }
        return -1;
    };
    const auto click = [&](int row) {
        const QModelIndex open = table.model()->index(row, LogModel::Open);
        int height = -1;
        const bool ready = bench.within([&] {
            table.scrollTo(open);
            return std::exchange(height, table.viewport()->height()) == table.viewport()->height() &&
                   table.viewport()->rect().contains(table.visualRect(open).center());
        });
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(open).center());
        return ready;
    };
    QVERIFY(bench.within([&] { return rowOf("Incident recorded") >= 0; }));
    QVERIFY(click(rowOf("Incident recorded")));
    auto& band = bench.find<ComparisonBand>("plots.comparison");
    QVERIFY(bench.within([&] { return band.isVisible() && band.words().contains("diverge at"); }));
    const PlotView& view = bench.plots().view();
    const QString name = view.page().name;
    const double stop = view.cursor(PlotView::Cursor::A).value();
    QCOMPARE(bench.valueAtA(name, "safety_mode"), 3.0);

    // The mark is exactly at the first packet with the force, well before the stop.
    const auto& marks = bench.plots().marks().marks();
    const auto mark =
        std::find_if(marks.begin(), marks.end(), [&](const PlotMark& one) { return one.recording == name; });
    QVERIFY(mark != marks.end());
    QVERIFY2(mark->time < stop - 0.4 && mark->time > stop - 1,
             qPrintable(QString::number(mark->time - stop)));
    auto& key = bench.find<QToolButton>("plots.comparison.key");
    QTest::mouseClick(&key, Qt::LeftButton);
    QCOMPARE(view.cursor(PlotView::Cursor::A), std::optional(mark->time));
    QVERIFY(bench.valueAtA(name, "actual_TCP_force_2") < -70);
    QVERIFY(std::abs(bench.plots()
                         .store()
                         .sampleAt(name, mark->time - 0.001)
                         .at(*bench.plots()
                                  .store()
                                  .sampleAt(name, mark->time)
                                  .layout->indexOfComponent("actual_TCP_force_2"))) < 5);
    // The curves are visible in both themes, even if no data arrive that would repaint the view.
    const auto colourful = [&view] {
        const QImage picture = const_cast<PlotView&>(view).grab().toImage();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                count += picture.pixelColor(x, y).hsvSaturation() > 100 ? 1 : 0;
            }
        }
        return count;
    };
    for (const bool dark : {true, false}) {
        bench.window.setTheme(dark ? "dark" : "light");
        bench.cell.advanceMs(100);
        const int after = colourful();
        keepPicture(bench.window,
                    dark ? QStringLiteral("incident-parted-dark") : QStringLiteral("incident-parted"));
        bench.window.resize(bench.window.width() + 8, bench.window.height());  // repaints everything
        bench.cell.advanceMs(100);
        QVERIFY2(after > 0.9 * colourful(), qPrintable(QString::number(after)));
    }
    // The log of the recording also contains an entry for the deviation. The entry is at the time of the
    // cursor.
    QVERIFY2(table.currentIndex().siblingAtColumn(LogModel::Text).data().toString().contains("diverge at"),
             qPrintable(bench.log().shownText()));

    // With live data, neither the line below the plots nor the mark is shown. The log entry opens the
    // recording at that time.
    bench.plots().endReplay();
    QVERIFY(bench.within([&] { return !band.isVisible(); }));
    const int row = rowOf("diverge at");
    QVERIFY2(row >= 0, qPrintable(bench.log().shownText()));
    QVERIFY(click(row));
    QVERIFY(bench.within([&] { return bench.plots().replay().has_value(); }));
    QCOMPARE(bench.plots().view().cursor(PlotView::Cursor::A), std::optional(mark->time));
    QVERIFY(band.isVisible());
    bench.plots().closeRecordings();
    QVERIFY(!band.isVisible());
    QVERIFY(bench.plots().marks().marks().empty());
}

QTEST_MAIN(TestIncident)
#include "tst_incident.moc"
