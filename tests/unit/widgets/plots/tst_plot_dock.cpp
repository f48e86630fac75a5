// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plot panel, tested with real mouse, wheel and key events and generated samples.
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QGraphicsScene>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QTabBar>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "robot/core/clock.h"
#include "robot/recording/formats/open_recording.h"
#include "robot/recording/mcap/reader.h"
#include "robot/recording/recording_format.h"
#include "robot/station/history/history_export.h"
#include "robot/station/history/live_history.h"
#include "robot/station/history/plot_marks.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/history/state_lane.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/text/format.h"
#include "tests/support/event_spy.h"
#include "tests/support/sample_stream.h"
#include "tests/unit/robot/station/history/long_recording.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"
#include "widgets/plots/analysis_canvas.h"
#include "widgets/plots/axis_labels.h"
#include "widgets/plots/comparison_band.h"
#include "widgets/plots/comparison_dialog.h"
#include "widgets/plots/curve.h"
#include "widgets/plots/curve_look.h"
#include "widgets/plots/curve_raster.h"
#include "widgets/plots/open_table_dialog.h"
#include "widgets/plots/plot_analysis.h"
#include "widgets/plots/plot_dock.h"
#include "widgets/plots/plot_layout.h"
#include "widgets/plots/plot_overlay.h"
#include "widgets/plots/plot_pages.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/plot_replay.h"
#include "widgets/plots/plot_view.h"
#include "widgets/plots/recordings_dialog.h"
#include "widgets/signals/signal_tree.h"

using namespace tiller;

namespace {

/// Samples at 500 Hz with Fz [N] equal to the time [s], so that every value can be checked by mental
/// arithmetic.
struct Bench {
    RobotSession session;
    LiveHistory live{session};
    PlotDock dock{session, live};
    test::SampleStream stream;
    int next = 0;                            ///< index of the next sample
    int restartedAt = 0;                     ///< index of the sample at which the controller started
    std::pair<QDateTime, QDateTime> framed;  ///< times before and after displaying the newest sample

    Bench() {
        stream.layout = std::make_shared<const receive::SampleLayout>(
            std::vector<std::string>{"timestamp", "actual_TCP_force", "actual_current", "actual_q",
                                     "actual_digital_input_bits", "robot_mode"});
        session.shutDown();  // disables automatic frames; the test triggers them
        dock.resize(1500, 375);
        dock.show();
        runTo(60);
    }
    /// Adds all samples up to this time in one frame.
    void runTo(double seconds) {
        const int until = static_cast<int>(std::lround(seconds / 0.002)) + 1;
        for (; next < until; ++next) {
            const double time = next * 0.002;
            receive::Sample& sample = stream.add(time, static_cast<std::uint64_t>(next) + 1);
            std::fill(sample.values.begin(), sample.values.end(), 0.0);
            stream.set(sample, "timestamp", (next - restartedAt) * 0.002);
            stream.set(sample, "actual_TCP_force_2", time);
            stream.set(sample, "actual_current_0", 1);
            stream.set(sample, "actual_q_1", std::sin(time));
            stream.set(sample, "actual_digital_input_bits", time >= 40 && time < 50 ? 8 : 0);
            stream.set(sample, "robot_mode", 7);
        }
        framed.first = QDateTime::currentDateTimeUtc();
        stream.frame([this](const SampleBatch& batch) { Q_EMIT session.samplesReceived(batch); });
        framed.second = QDateTime::currentDateTimeUtc();
        Q_EMIT session.stateChanged(session.state());
    }
    PlotView& view() { return dock.view(); }
    int id(const char* key) { return dock.store().find(QLatin1String(key)); }
    QPoint at(double time) { return {static_cast<int>(std::lround(view().xAt(time))), 100}; }
    void wheel(double time, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const QPointF place = at(time);
        QWheelEvent event(place, view().viewport()->mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(view().viewport(), &event);
    }
    PlotPane& forces() { return *view().panes()[0]; }
    void clickLegend(int signal, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const auto& panes = view().panes();
        const auto entry = [&] {
            const QRectF upper = panes[0]->legendEntry(signal);
            return upper.isEmpty() ? panes[1]->legendEntry(signal) : upper;
        };
        QTRY_VERIFY_WITH_TIMEOUT(!entry().isEmpty(), 60'000);
        QTest::mouseClick(view().viewport(), Qt::LeftButton, modifiers, entry().center().toPoint());
    }
    Curve& curve(int signal) {
        for (const auto& pane : view().panes()) {
            for (const auto& curve : pane->curves()) {
                if (curve->signal() == signal) {
                    return *curve;
                }
            }
        }
        qFatal("there is no such curve");
    }
    void wheelAt(const QPointF& place, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QWheelEvent event(place, view().viewport()->mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(view().viewport(), &event);
    }
    /// Types into the search field of the list.
    void list(const QString& words) {
        auto* search = dock.findChild<QLineEdit*>(QStringLiteral("signals.search"));
        search->setFocus();
        search->selectAll();
        QTest::keyClick(search, Qt::Key_Delete);
        QTest::keyClicks(search, words);
    }
    /// Returns the first row of the list that currently has this text.
    QModelIndex rowOf(const QString& text) {
        const QAbstractItemModel* model = dock.findChild<QTreeView*>(QStringLiteral("signals.tree"))->model();
        const auto rows = model->match(model->index(0, 0), Qt::DisplayRole, text, 1,
                                       Qt::MatchExactly | Qt::MatchCaseSensitive | Qt::MatchRecursive);
        return rows.isEmpty() ? QModelIndex() : rows.first();
    }
    /// Sends the events of a drag from the list.
    void drop(const QPointF& place, const QStringList& keys) {
        QMimeData data;
        data.setData(QLatin1String(SignalTree::kMime), keys.join('\n').toUtf8());
        const QPoint at = place.toPoint();
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(view().viewport(), &enter);
        QVERIFY(enter.isAccepted());
        QDragMoveEvent move(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(view().viewport(), &move);
        QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(view().viewport(), &drop);
    }
    /// Chooses an action from the context menu at a position in the view.
    void menuAt(const QPointF& place, const char* action) {
        QContextMenuEvent event(QContextMenuEvent::Mouse, place.toPoint(),
                                view().viewport()->mapToGlobal(place.toPoint()));
        QApplication::sendEvent(view().viewport(), &event);
        auto* menu = view().findChild<QMenu*>(QStringLiteral("plots.menu"));
        QVERIFY(menu != nullptr);
        auto* wanted = menu->findChild<QAction*>(QLatin1String(action));
        QVERIFY2(wanted != nullptr, action);
        wanted->trigger();
        delete menu;
    }
    /// Returns an action of the Layout menu, which is rebuilt each time.
    QAction* menu(const char* name) {
        QMenu* layout = button("plots.layout")->menu();
        Q_EMIT layout->aboutToShow();
        return layout->findChild<QAction*>(QLatin1String(name), Qt::FindDirectChildrenOnly);
    }
    QToolButton* button(const char* name) { return dock.findChild<QToolButton*>(QLatin1String(name)); }
    QString readout() { return dock.findChild<ElidedLabel*>(QStringLiteral("plots.readout"))->fullText(); }
};

SessionState running(double time, bool jogging) {
    SessionState state;
    state.link = LinkState::Live;
    state.sequence = 1;
    state.robotMode = RobotMode::Running;
    state.safetyMode = SafetyMode::Normal;
    state.robotTime = time;
    state.moving = state.jogActive = jogging;
    return state;
}

bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

/// Hides all curves, which would cover the grid lines.
void hideCurves(PlotView& view) {
    for (const auto& pane : view.panes()) {
        for (const int signal : pane->shown()) {
            view.setHidden(signal, true);
        }
    }
}

/// Compares the drawn grid lines of each plot with its scale. Returns the first difference; empty: none.
QString gridFault(PlotView& view) {
    const QImage image = view.grab().toImage();
    const Theme& theme = Theme::current();
    const QRgb line =
        QColor((theme.panel.red() + theme.border.red()) / 2, (theme.panel.green() + theme.border.green()) / 2,
               (theme.panel.blue() + theme.border.blue()) / 2)
            .rgb();
    for (const auto& pane : view.panes()) {
        const AxisRange& range = pane->range();
        QSet<int> wanted;
        const auto last = std::llround(std::floor(range.max() / range.step()));
        for (auto i = std::llround(std::ceil(range.min() / range.step())); i <= last; ++i) {
            wanted.insert(static_cast<int>(std::floor(pane->yAt(static_cast<double>(i) * range.step()))));
        }
        const QRect area = pane->area().toRect();
        for (const int x : {area.left() + 2, area.center().x(), area.right() - 2}) {
            if (pane->isZoomed() && x > area.center().x()) {
                continue;  // the note about the fixed scale covers the upper right corner
            }
            QSet<int> drawn;
            for (int y = area.top(); y <= area.bottom(); ++y) {
                if (image.pixel(x, y) == line) {
                    drawn.insert(y);
                }
            }
            if (drawn != wanted || wanted.size() < 2) {
                return QStringLiteral("plot %1, x = %2: %3 of %4 lines are at the height of their labels")
                    .arg(view.paneIndex(*pane))
                    .arg(x)
                    .arg((drawn & wanted).size())
                    .arg(wanted.size());
            }
        }
    }
    return {};
}

/// Writes a recording of 100 s: motion, from 30 s to 40 s a protective stop, from 60 s power off, from 80 s
/// at standstill.
QString writeDay(const QTemporaryDir& folder, const QString& name, const QStringList& omitted = {}) {
    const QStringList columns{"timestamp", "actual_TCP_force_2", "robot_mode", "safety_mode", "actual_qd_0"};
    QFile file(folder.filePath(name));
    const bool opened = file.open(QIODevice::WriteOnly);
    Q_ASSERT(opened);
    const auto write = [&](const QStringList& cells) {
        QStringList kept;
        for (qsizetype i = 0; i < cells.size(); ++i) {
            kept << (omitted.contains(columns[i]) ? QStringList() : QStringList(cells[i]));
        }
        file.write(kept.join(QLatin1Char(',')).toUtf8() + '\n');
    };
    write(columns);
    for (int i = 0; i <= 10'000; ++i) {
        const double time = i * 0.01;
        const bool isOff = time >= 60 && time < 80;
        write({QString::number(700 + time, 'f', 4), QString::number(i % 10), QString::number(isOff ? 3 : 7),
               QString::number(time >= 30 && time < 40 ? 3 : 1),
               QString::number(time < 30 || (time >= 40 && time < 60) ? 0.2 : 0.0)});
    }
    return file.fileName();
}

/// The lane as text, with the start of each segment relative to the given time [s].
QString laneText(const PlotView& view, double begin) {
    QStringList words;
    for (const LaneSegment& segment : view.laneItem().segments()) {
        words << QStringLiteral("%1 %2").arg(std::llround(segment.start - begin)).arg(segment.label);
    }
    return words.join(QStringLiteral(", "));
}

/// Number of columns without data between the first and the last column with data; -1 if no column has data.
int emptyColumnsWithin(const Curve& curve) {
    const auto isDrawn = [](const Curve::Column& column) { return !column.isEmpty(); };
    const auto& columns = curve.columns();
    const auto first = std::find_if(columns.begin(), columns.end(), isDrawn);
    const auto last = std::find_if(columns.rbegin(), columns.rend(), isDrawn).base();
    return first == columns.end() ? -1 : static_cast<int>(std::count_if(first, last, std::not_fn(isDrawn)));
}

}  // namespace

class TestPlotDock : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void gridLinesAreAtTheHeightsOfTheirLabels() {
        Bench b;
        hideCurves(b.view());
        QCOMPARE(gridFault(b.view()), QString());
        b.dock.resize(1100, 520);
        QCOMPARE(gridFault(b.view()), QString());
        // Change the size and scale while the plots are hidden, as happens while another perspective is
        // active.
        b.dock.hide();
        b.dock.resize(1500, 420);
        b.runTo(61);
        b.forces().holdValues(-3, 17);
        b.dock.show();
        QCOMPARE(gridFault(b.view()), QString());
        b.dock.pages().addPage(PageLayout::standard());
        hideCurves(b.view());
        QCOMPARE(gridFault(b.view()), QString());
    }

    void gridLinesOfARecordingAreAtTheHeightsOfTheirLabels() {
        Bench b;
        QTemporaryDir folder;
        b.dock.openRecording(writeDay(folder, QStringLiteral("day.csv")));
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        hideCurves(b.view());
        QCOMPARE(gridFault(b.view()), QString());
    }

    // The cursor moves by the real time multiplied by the speed, and the rest of the window follows.
    void playbackMovesTheCursorToTheEndOfTheRecording() {
        Bench b;
        QTemporaryDir folder;
        b.dock.openRecording(writeDay(folder, QStringLiteral("day.csv")));
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        const SeriesBuffer& times = *b.dock.store().timesOf(b.view().recordingInFront());
        const double last = times.lastTime();
        b.view().setCursor(PlotView::Cursor::A, last - 20);
        QElapsedTimer real;
        real.start();
        b.dock.play(10);
        QVERIFY(b.dock.isPlaying());
        std::vector<double> places;
        QObject context;
        connect(&b.dock, &PlotDock::replayChanged, &context,
                [&](const Replay& replay) { places.push_back(replay ? replay->time : -1); });
        // At most 10 s of the recording per second of real time.
        QTRY_VERIFY_WITH_TIMEOUT(b.view().cursor(PlotView::Cursor::A) > last - 15, 60'000);
        QVERIFY(*b.view().cursor(PlotView::Cursor::A) - (last - 20) <=
                1e-3 * static_cast<double>(real.elapsed() + 1) * 10);
        // A moved cursor is the new start, and the view follows the cursor.
        b.view().setCursor(PlotView::Cursor::A, last - 5);
        QTRY_VERIFY_WITH_TIMEOUT(!b.dock.isPlaying(), 60'000);
        QCOMPARE(b.view().cursor(PlotView::Cursor::A), std::optional(last));
        QVERIFY(b.view().window().end() >= last);
        QVERIFY(!places.empty() && std::is_sorted(places.begin(), places.end()));
        QCOMPARE(places.back(), last);
    }

    // The file of a recording has the clock setting of its start, and converts notes from the current setting.
    void notesHaveTheCurrentSettingOfTheClock() {
        Bench b;
        PlotReplay replay(b.dock.store(), b.dock.pages());
        replay.noteFrame(10,
                         QDateTime::currentDateTimeUtc().addSecs(3600));  // the clock is set back afterwards
        const std::int64_t before = QDateTime::currentMSecsSinceEpoch();
        const std::int64_t note = replay.noteUtcNs(9.5) / kNsPerMs;
        QVERIFY2(note > before - 60'000 && note <= QDateTime::currentMSecsSinceEpoch() - 499,
                 qPrintable(QString::number(note - before)));
        QVERIFY(replay.noteUtcNs(10) - replay.noteUtcNs(9.5) < kNsPerSecond);
    }

    void playbackEndsWithItsPage() {
        Bench b;
        b.dock.play(0.1);
        QVERIFY(b.dock.isPlaying() && !b.view().window().follows());
        QTRY_VERIFY_WITH_TIMEOUT(b.dock.replay(), 60'000);
        const double begin = *b.view().cursor(PlotView::Cursor::A);
        QTRY_VERIFY_WITH_TIMEOUT(*b.view().cursor(PlotView::Cursor::A) > begin, 60'000);
        b.dock.setPaused(false);
        QTRY_VERIFY_WITH_TIMEOUT(!b.dock.isPlaying(), 60'000);
        QVERIFY(b.view().window().follows());
        b.dock.play(0.1);
        b.view().setCursor(PlotView::Cursor::A, std::nullopt);
        QTRY_VERIFY_WITH_TIMEOUT(!b.dock.isPlaying(), 60'000);
        b.dock.play(0.1);
        b.dock.stopPlayback();
        QVERIFY(!b.dock.isPlaying());
        // Data that arrive during the playback are not played.
        b.view().setCursor(PlotView::Cursor::A, b.dock.history().lastTime() - 1);
        const double end = b.dock.history().lastTime();
        b.dock.play(10);
        b.runTo(70);
        QTRY_VERIFY_WITH_TIMEOUT(!b.dock.isPlaying(), 60'000);
        QCOMPARE(b.view().cursor(PlotView::Cursor::A), std::optional(end));
    }

    void showsTheNewestThirtySecondsAtFirst() {
        Bench b;
        QCOMPARE(b.view().window().span(), 30.0);
        QVERIFY(near(b.view().window().end(), 60, 0.003));
        b.runTo(61);
        QVERIFY(near(b.view().window().end(), 61, 0.003));
    }

    void pauseFreezesTheViewWhileDataContinue() {
        Bench b;
        QTest::mouseClick(b.button("plots.pause"), Qt::LeftButton);
        b.runTo(75);
        QVERIFY(near(b.view().window().end(), 60, 0.003));
        QVERIFY(near(b.dock.history().lastTime(), 75, 0.003));
        QCOMPARE(b.button("plots.pause")->text(), QString("Resume"));
        QTest::mouseClick(b.button("plots.pause"), Qt::LeftButton);
        QVERIFY(near(b.view().window().end(), 75, 0.003));
        QCOMPARE(b.button("plots.pause")->text(), QString("Pause"));
    }

    void theAgeOfAPausedViewCountsOn() {
        Bench b;
        b.view().pause();
        b.runTo(62);
        for (int frame = 0; frame < 60; ++frame) {
            Q_EMIT b.session.stateChanged(b.session.state());
        }
        QVERIFY2(b.readout().contains("2.0 s behind"), qPrintable(b.readout()));
        b.runTo(70);
        for (int frame = 0; frame < 60; ++frame) {
            Q_EMIT b.session.stateChanged(b.session.state());
        }
        QVERIFY2(b.readout().contains("10.0 s behind"), qPrintable(b.readout()));
    }

    void theTimeWindowIsSelectedFromTheMenu() {
        Bench b;
        for (QAction* action : b.button("plots.span")->menu()->actions()) {
            action->trigger();
            QCOMPARE(b.view().window().span(), action->data().toDouble());
            QVERIFY(b.button("plots.span")->text().startsWith(action->text()));
        }
        QCOMPARE(b.button("plots.span")->menu()->actions().size(), 6);
    }

    void draggingScrollsBackInHistory() {
        Bench b;
        QWidget* viewport = b.view().viewport();
        const double held = 50;
        QTest::mousePress(viewport, Qt::LeftButton, {}, b.at(held));
        const QPoint to = b.at(held) + QPoint(300, 0);
        QTest::mouseMove(viewport, b.at(held) + QPoint(60, 0));
        QTest::mouseMove(viewport, to);
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, to);
        QVERIFY(!b.view().window().follows());
        QVERIFY2(near(b.view().timeAt(to.x()), held, 0.1), "the dragged time is no longer under the pointer");
        QVERIFY(!b.view().cursor(PlotView::Cursor::A));  // a drag is not a click
    }

    void theWheelZoomsAndWithShiftScrolls() {
        Bench b;
        b.view().pause();
        b.wheel(45, 2);
        QVERIFY(near(b.view().window().span(), 30 * 0.64, 1e-6));
        QVERIFY(near(b.view().xAt(45), b.at(45).x(), 1.0));
        const double end = b.view().window().end();
        b.wheel(45, 1, Qt::ShiftModifier);
        QVERIFY(b.view().window().end() < end);
    }

    void clicksPlaceTheCursorsAndTheReadoutShowsTheDifference() {
        Bench b;
        b.view().pause();
        QTest::mouseClick(b.view().viewport(), Qt::LeftButton, {}, b.at(40));
        QVERIFY(near(*b.view().cursor(PlotView::Cursor::A), 40, 0.03));
        QVERIFY(b.readout().contains("A "));
        QTest::mouseClick(b.view().viewport(), Qt::LeftButton, {}, b.at(50));
        b.view().setCursor(PlotView::Cursor::A, 40.0);
        b.view().setCursor(PlotView::Cursor::B, 50.0);
        QVERIFY2(b.readout().startsWith("A–B Δt 10.000 s · ΔFz +10.0 N"), qPrintable(b.readout()));
        b.view().setCursor(PlotView::Cursor::A, 50.0);
        b.view().setCursor(PlotView::Cursor::B, 40.2);
        QVERIFY2(b.readout().startsWith("A–B Δt −9.800 s · ΔFz −9.8 N"), qPrintable(b.readout()));
    }

    /// Includes the upper edge of the plot. Only a click on a name in the legend does not place a cursor.
    void aClickAnywhereInAPlotPlacesACursor() {
        Bench b;
        b.view().pause();
        for (const int height : {375, 700}) {
            b.dock.resize(1500, height);
            QTest::qWait(1);
            for (const auto& pane : b.view().panes()) {
                const QRectF area = pane->area();
                for (double y = area.top() + 2; y < area.bottom() - 1; y += 3) {
                    b.view().setCursor(PlotView::Cursor::A, {});
                    const QPoint place(b.at(50).x(), static_cast<int>(y));
                    QTest::mouseClick(b.view().viewport(), Qt::LeftButton, {}, place);
                    QVERIFY2(b.view().cursor(PlotView::Cursor::A).has_value(),
                             qPrintable(QStringLiteral("%1 px below the upper edge").arg(y - area.top())));
                }
            }
        }
    }

    /// A paused view draws no new frames by itself.
    void theCurvesOfAPausedViewStayWhenAnotherSignalIsSelected_data() {
        QTest::addColumn<QString>("way");
        for (const char* way : {"click into the lower plot", "key", "legend"}) {
            QTest::newRow(way) << QString::fromLatin1(way);
        }
    }
    void theCurvesOfAPausedViewStayWhenAnotherSignalIsSelected() {
        QFETCH(QString, way);
        Bench b;
        b.view().pause();
        const auto drawn = [&b](int signal) {
            const QImage image = b.view().grab().toImage();
            const QColor color = b.curve(signal).pen().color();
            const QRect area = b.view().panes()[b.forces().shows(signal) ? 0 : 1]->area().toRect();
            int count = 0;
            for (int y = area.top(); y <= area.bottom(); ++y) {
                for (int x = area.left(); x <= area.right(); ++x) {
                    count += image.pixelColor(x, y) == color ? 1 : 0;
                }
            }
            return count;
        };
        const int force = b.id("actual_TCP_force_2");
        const int current = b.id("actual_current_0");
        QVERIFY(drawn(force) > 500 && drawn(current) > 500);
        if (way == QLatin1String("key")) {
            QTest::keyClick(&b.view(), Qt::Key_Down);
        } else if (way == QLatin1String("legend")) {
            b.clickLegend(current, Qt::ControlModifier);
        } else {
            const QPointF lower = b.view().panes()[1]->area().center();
            QTest::mouseClick(b.view().viewport(), Qt::LeftButton, {}, lower.toPoint());
        }
        QVERIFY(b.view().readoutSignal() != force);
        QVERIFY2(drawn(force) > 500 && drawn(current) > 500,
                 qPrintable(QStringLiteral("%1 and %2 pixels").arg(drawn(force)).arg(drawn(current))));
        const QImage emphasized = b.view().grab().toImage();
        b.view().setSpan(b.view().window().span());
        QVERIFY2(b.view().grab().toImage() == emphasized, "the emphasis appears only later");
    }

    void aCursorIsDraggedByItsLine() {
        Bench b;
        b.view().pause();
        b.view().setCursor(PlotView::Cursor::B, 45.0);
        QWidget* viewport = b.view().viewport();
        QTest::mousePress(viewport, Qt::LeftButton, {}, b.at(45) + QPoint(3, 0));
        QTest::mouseMove(viewport, b.at(35));
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, b.at(35));
        QVERIFY(near(*b.view().cursor(PlotView::Cursor::B), 35, 0.03));
        QVERIFY(near(b.view().window().end(), 60, 0.003));
    }

    void everythingIsReachedFromTheKeyboard() {
        Bench b;
        b.view().pause();
        QTest::keyClick(&b.view(), Qt::Key_A);
        const double a = b.view().cursor(PlotView::Cursor::A).value();
        const double pixel = b.view().timeAt(501) - b.view().timeAt(500);
        QTest::keyClick(&b.view(), Qt::Key_Right);
        QVERIFY(near(*b.view().cursor(PlotView::Cursor::A), a + pixel, 1e-6));
        QTest::keyClick(&b.view(), Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(near(*b.view().cursor(PlotView::Cursor::A), a - 9 * pixel, 1e-6));
        QTest::keyClick(&b.view(), Qt::Key_B);
        QVERIFY(b.view().cursor(PlotView::Cursor::B).has_value());
        QTest::keyClick(&b.view(), Qt::Key_Delete);
        QVERIFY(!b.view().cursor(PlotView::Cursor::B));
        QTest::keyClick(&b.view(), Qt::Key_Down);
        QVERIFY(b.view().readoutSignal() == b.id("actual_current_0"));
        QTest::keyClick(&b.view(), Qt::Key_Up);
        QVERIFY(b.view().readoutSignal() == b.id("actual_TCP_force_2"));
        QTest::keyClick(&b.view(), Qt::Key_PageUp);
        QVERIFY(near(b.view().window().end(), 45, 0.003));
        QTest::keyClick(&b.view(), Qt::Key_End);
        QVERIFY(b.view().window().follows());
    }

    void aClickOnANameInALegendHidesItsCurve() {
        Bench b;
        const double wide = b.forces().range().max();
        b.clickLegend(b.id("actual_TCP_force_2"));
        QVERIFY2(b.view().isHidden(b.id("actual_TCP_force_2")),
                 qPrintable(QDebug::toString(b.forces().legendEntry(b.id("actual_TCP_force_2")))));
        QVERIFY(!b.curve(b.id("actual_TCP_force_2")).isVisible());
        QVERIFY(b.curve(b.id("actual_TCP_force_0")).isVisible());
        QVERIFY2(b.forces().range().max() < wide, "the scale includes hidden curves");
        b.clickLegend(b.id("actual_current_1"));
        QVERIFY(!b.curve(b.id("actual_current_1")).isVisible());
        QVERIFY(!b.view().cursor(PlotView::Cursor::A));  // not a click in the plot
        // New data, another connection and different colours do not change the cursors.
        b.runTo(61);
        Q_EMIT b.session.linkBegan();
        b.runTo(63);
        applyTheme(*qApp, Theme::dark());
        applyTheme(*qApp, Theme::light());
        QVERIFY(!b.curve(b.id("actual_TCP_force_2")).isVisible());
        QVERIFY(!b.curve(b.id("actual_current_1")).isVisible());
        b.clickLegend(b.id("actual_TCP_force_2"));
        QVERIFY(b.curve(b.id("actual_TCP_force_2")).isVisible());
        QVERIFY(b.forces().range().max() > 60);
        QVERIFY(!b.curve(b.id("actual_current_1")).isVisible());
    }

    void controlClickOnALegendNameSelectsTheReadout() {
        Bench b;
        b.clickLegend(b.id("actual_current_2"), Qt::ControlModifier);
        QVERIFY(b.view().readoutSignal() == b.id("actual_current_2"));
        QVERIFY(!b.view().isHidden(b.id("actual_current_2")));
        QTest::keyClick(&b.view(), Qt::Key_H);
        QVERIFY(b.view().isHidden(b.id("actual_current_2")));
        QTest::keyClick(&b.view(), Qt::Key_H);
        QVERIFY(!b.view().isHidden(b.id("actual_current_2")));
    }

    void theWheelOverTheValueAxisZoomsIt() {
        Bench b;
        const double span = b.forces().range().max() - b.forces().range().min();
        const double time = b.view().window().span();
        const QPointF axis(20, b.forces().area().center().y());
        const double middle = (b.forces().range().max() + b.forces().range().min()) / 2;
        b.wheelAt(axis, 2);
        QVERIFY(near(b.forces().range().max() - b.forces().range().min(), span * 0.64, 1e-6));
        QVERIFY(near((b.forces().range().max() + b.forces().range().min()) / 2, middle, span * 0.01));
        QCOMPARE(b.view().window().span(), time);
        QVERIFY(!b.view().panes()[1]->isZoomed());
        // New data do not change the zoomed range.
        b.runTo(70);
        QVERIFY(near(b.forces().range().max() - b.forces().range().min(), span * 0.64, 1e-6));
        QTest::mouseDClick(b.view().viewport(), Qt::LeftButton, {}, axis.toPoint());
        QVERIFY(!b.forces().isZoomed());
        QVERIFY(b.forces().range().max() - b.forces().range().min() > span * 0.9);
        // The wheel with Ctrl zooms anywhere over a plot. Keys zoom the plot that contains the active signal.
        b.wheelAt(b.view().panes()[1]->area().center(), 1, Qt::ControlModifier);
        QVERIFY(b.view().panes()[1]->isZoomed());
        QVERIFY(!b.forces().isZoomed());
        QTest::keyClick(&b.view(), Qt::Key_Plus, Qt::ControlModifier);
        QVERIFY(b.forces().isZoomed());
        QTest::keyClick(&b.view(), Qt::Key_0, Qt::ControlModifier);
        QVERIFY(!b.forces().isZoomed());
        QCOMPARE(b.view().window().span(), time);
    }

    /// Without its leading digits, a label would show a different number.
    void labelsOfTheValueAxisAreNeverCutOff_data() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::newRow("small") << -1.0 << 1.0;
        QTest::newRow("with unit") << -2400.0 << -1000.0;
        QTest::newRow("tiny") << 1e-9 << 4e-9;
        QTest::newRow("million") << -4e6 << 4e6;
        QTest::newRow("1e37") << -1e37 << 3e37;
        QTest::newRow("-1e-37") << -3e-37 << -1e-37;
        QTest::newRow("small steps") << 1e9 << 1e9 + 3;
    }
    void labelsOfTheValueAxisAreNeverCutOff() {
        QFETCH(double, low);
        QFETCH(double, high);
        Bench b;
        PlotPane& pane = b.forces();
        pane.holdValues(low, high);
        const double room = pane.area().left();
        const QFontMetricsF metrics(textFont(13));
        int numbers = 0;
        for (const QGraphicsItem* item : b.view().scene()->items()) {
            const auto* labels = dynamic_cast<const AxisLabels*>(item);
            for (const AxisLabels::Label& label :
                 labels == nullptr ? std::vector<AxisLabels::Label>() : labels->labels()) {
                const double y = label.box.center().y();
                if (label.box.right() > room || y < pane.area().top() - 20 || y > pane.area().bottom()) {
                    continue;  // another plot, or the time axis
                }
                QVERIFY2(metrics.horizontalAdvance(label.text) <= label.box.right(), qPrintable(label.text));
                bool isNumber = false;
                QString plain = label.text;
                plain.replace(QChar(0x2212), QLatin1Char('-')).remove(QStringLiteral(" N"));
                const double value = plain.toDouble(&isNumber);
                QVERIFY2(isNumber || plain == QLatin1String("N") || plain.startsWith(QChar(0x2026)),
                         qPrintable(label.text));
                if (isNumber) {
                    QVERIFY2(near(value, pane.valueAt(y), 0.05 * pane.range().step()),
                             qPrintable(label.text));
                }
                numbers += plain == QLatin1String("N") ? 0 : 1;
            }
        }
        QVERIFY(numbers >= 2);
    }

    void largeValuesAreShownWithAnExponent() {
        Bench b;
        b.view().pause();
        QVERIFY(b.view().addSignals({QStringLiteral("big = 1e37 * actual_current_0")}, 0));
        QTest::mouseClick(b.button("plots.valuesKey"), Qt::LeftButton);
        b.view().setCursor(PlotView::Cursor::A, 40.0);
        auto* table = b.dock.findChild<QTableWidget*>("plots.values.table");
        const auto texts = [&] {
            QStringList all;
            for (int row = 0; row < table->rowCount(); ++row) {
                all << table->item(row, 0)->text() + QLatin1Char('=') + table->item(row, 1)->text();
            }
            return all;
        };
        QTRY_VERIFY_WITH_TIMEOUT(!texts().filter("big=").join(QString()).endsWith(QChar(0x2013)), 60'000);
        QCOMPARE(texts().filter("big="), QStringList{"big=1e37"});
        b.view().setReadoutSignal(b.forces().shown().back());
        QVERIFY2(b.readout().contains("1e37"), qPrintable(b.readout()));
    }

    void zeroTaresTheForceAndShowsIt() {
        Bench b;
        b.view().setCursor(PlotView::Cursor::A, 60.0);
        QVERIFY2(b.readout().contains("Fz +60.0 N"), qPrintable(b.readout()));
        const QImage plain = b.view().grab().toImage();
        QTest::mouseClick(b.button("plots.zero"), Qt::LeftButton);
        QVERIFY(b.button("plots.zero")->isChecked());
        // Mean of the last quarter of a second, where Fz equals the time.
        QVERIFY(near(b.forces().offset(b.id("actual_TCP_force_2")), 59.875, 0.01));
        QVERIFY2(b.readout().contains("Fz (zeroed) +0.1 N"), qPrintable(b.readout()));
        QVERIFY(b.view().zeroText().contains("Fz +59.9"));
        QVERIFY(b.forces().range().max() < 20);
        QVERIFY2(b.view().grab().toImage() != plain, "the plot has no mark for the offset");
        // Measured values are unchanged.
        QVERIFY(near(b.dock.store().valueAt(b.id("actual_TCP_force_2"), 50).value(), 50, 0.01));
        b.runTo(70);
        QVERIFY(near(b.forces().offset(b.id("actual_TCP_force_2")), 59.875, 0.01));
        QTemporaryDir folder;
        QVERIFY(b.dock.exportTo(folder.filePath("zeroed.svg")));
        QFile picture(folder.filePath("zeroed.svg"));
        QVERIFY(picture.open(QIODevice::ReadOnly));
        QVERIFY(picture.readAll().contains("Zeroed"));
        // Switching the offset off restores the original values.
        QTest::mouseClick(b.button("plots.zero"), Qt::LeftButton);
        QVERIFY(!b.button("plots.zero")->isChecked());
        QVERIFY(b.view().zeroText().isEmpty());
        QVERIFY(b.forces().range().max() > 60);
        QVERIFY2(b.readout().contains("Fz +60.0 N"), qPrintable(b.readout()));
    }

    // The zero offset is not kept, because another robot may have a tool with a different weight.
    void theZeroIsClearedForAnotherRobot() {
        Bench b;
        QTest::mouseClick(b.button("plots.zero"), Qt::LeftButton);
        Q_EMIT b.session.linkBegan();
        QVERIFY(!b.view().isForceZeroed());
        QVERIFY(!b.button("plots.zero")->isChecked());
    }

    void zeroNeedsSamples() {
        RobotSession session;
        LiveHistory dockLive(session);
        PlotDock dock(session, dockLive);
        dock.resize(900, 300);
        dock.show();
        const test::EventSpy messages(session.journal());
        auto* zero = dock.findChild<QToolButton*>("plots.zero");
        QTest::mouseClick(zero, Qt::LeftButton);
        QVERIFY(!zero->isChecked());
        QCOMPARE(messages.count(), 1);
    }

    void spaceAndEscapeAreLeftToTheStop() {
        Bench b;
        for (const auto key : {Qt::Key_Space, Qt::Key_Escape}) {
            QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
            QApplication::sendEvent(&b.view(), &event);
            QVERIFY(!event.isAccepted());
        }
        QVERIFY(b.view().window().follows());
    }

    void aGapHasNoValue() {
        Bench b;
        b.next += 2000;  // a gap of four seconds
        b.runTo(70);
        QVERIFY(b.dock.store().valueAt(b.id("actual_TCP_force_2"), 59.9).has_value());
        QVERIFY(!b.dock.store().valueAt(b.id("actual_TCP_force_2"), 62).has_value());
        QVERIFY(!b.dock.store().valueAt(b.id("actual_TCP_force_2"), 60.05).has_value());
        QVERIFY(near(b.dock.store().valueAt(b.id("actual_TCP_force_2"), 65).value(), 65, 0.01));
        // No line crosses the gap.
        const Curve& fz = *b.view().panes()[0]->curves()[2];
        const auto column = [&](double time) {
            const double share = (time - b.view().window().start()) / b.view().window().span();
            return fz
                .columns()[static_cast<std::size_t>(share * static_cast<double>(fz.columns().size() - 1))];
        };
        QVERIFY(std::isnan(column(62).left));
        QVERIFY(!std::isnan(column(59.5).left));
        QVERIFY(!std::isnan(column(65).left));
    }

    void aChangeOfTheRobotIsMarked() {
        Bench b;
        const auto connectTo = [&](const char* name, const char* host) {
            b.session.connectTo({name, host, 0, false});
            b.session.shutDown();
        };
        connectTo("Left", "127.0.0.1");
        b.runTo(61);
        QCOMPARE(b.dock.marks().marks().size(), std::size_t(0));
        connectTo("Right", "127.0.0.2");
        QCOMPARE(b.dock.marks().marks().size(), std::size_t(0));
        b.runTo(70);
        QCOMPARE(b.dock.marks().marks().size(), std::size_t(1));
        const PlotMark mark = b.dock.marks().marks().front();
        QCOMPARE(mark.text, QStringLiteral("Robot: Right (127.0.0.2)"));
        QVERIFY(near(mark.time, 61.2, 0.02));
        QVERIFY(b.dock.history().gapBefore(b.dock.history().lowerBound(mark.time)));
        // A replay names the robot if it is not the connected one.
        b.dock.setPaused(true);
        b.view().setCursor(PlotView::Cursor::A, 60.9);
        QVERIFY(b.dock.replay().has_value());
        QCOMPARE(b.dock.replay()->robot, QStringLiteral("Left (127.0.0.1)"));
        QVERIFY(b.dock.replay()->words().contains("Left (127.0.0.1)"));
        b.view().setCursor(PlotView::Cursor::A, 65);
        QVERIFY2(b.dock.replay()->robot.isEmpty(), qPrintable(b.dock.replay()->words()));
        // Differences and x-y plots do not mix the robots.
        b.view().setCursor(PlotView::Cursor::A, 60);
        b.view().setCursor(PlotView::Cursor::B, 65);
        QVERIFY2(b.view().readout().endsWith(QStringLiteral("ΔFz – N")), qPrintable(b.view().readout()));
        b.dock.setAnalysisShown(true);
        auto* analysis = b.dock.findChild<PlotAnalysis*>();
        analysis->setKind(PlotAnalysis::Kind::Xy);
        QVERIFY2(analysis->canvas().message().contains("different robots"), qPrintable(analysis->title()));
        b.view().setCursor(PlotView::Cursor::A, 62);
        QTRY_VERIFY_WITH_TIMEOUT(!analysis->title().isEmpty(), 60'000);
        QVERIFY2(!b.view().readout().endsWith(QStringLiteral("– N")), qPrintable(b.view().readout()));
    }

    // The receiver reconnects by itself, so no new connection begins. The model is reported after the first packets.
    void anotherModelAtTheSameAddressIsMarked() {
        Bench b;
        b.session.connectTo({QStringLiteral("Cell"), QStringLiteral("127.0.0.1"), 0, false});
        b.session.shutDown();
        const auto report = [&](RobotModelId model) {
            SessionState state = b.session.state();
            state.link = LinkState::Live;
            state.modelKnown = true;
            state.model = model;
            Q_EMIT b.session.stateChanged(state);
        };
        b.runTo(61);
        report(RobotModelId::UR5e);
        b.runTo(63);
        b.restartedAt = b.next;
        b.runTo(64);
        report(RobotModelId::UR5e);
        b.runTo(65);
        QCOMPARE(b.dock.marks().marks().size(), std::size_t(0));
        report(RobotModelId::UR10e);
        QCOMPARE(b.dock.marks().marks().size(), std::size_t(1));
        const PlotMark mark = b.dock.marks().marks().front();
        QCOMPARE(mark.text, QStringLiteral("Robot: Cell (127.0.0.1), UR10e"));
        const SeriesBuffer& history = b.dock.history();
        const std::int64_t first = history.lowerBound(mark.time);
        QVERIFY(history.gapBefore(first));
        QVERIFY(b.dock.store().hasSeveralRobots(history.time(first - 1), history.time(first)));
        QVERIFY(!b.dock.store().hasSeveralRobots(history.time(first), history.lastTime()));
        b.dock.setPaused(true);
        b.view().setCursor(PlotView::Cursor::A, history.time(first - 1));
        QCOMPARE(b.dock.replay()->model, std::optional(RobotModelId::UR5e));
        b.view().setCursor(PlotView::Cursor::A, history.time(first));
        QCOMPARE(b.dock.replay()->model, std::optional(RobotModelId::UR10e));
    }

    void aCurveIsDrawnAtItsValues() {
        SeriesBuffer history(1);
        std::array<float, 1> row{};
        for (int i = 0; i < 4000; ++i) {
            row[0] = i < 2000 ? 2.0F : 8.0F;
            history.append(i * 0.001, row);
        }
        for (const double span : {4.0, 0.05}) {  // across columns with many samples and across single samples
            std::vector<std::unique_ptr<Curve>> curves;
            curves.push_back(std::make_unique<Curve>(0));
            curves[0]->setPen(QPen(Qt::red, 2));
            CurveRaster sheet(curves, nullptr);
            ColumnGrid grid;
            const double t0 = 2.0 - span / 2;
            history.cut(t0, span / 200, 200, grid);
            curves[0]->sample(history, 0, grid);
            sheet.setView(QRectF(0, 0, 200, 100), t0, t0 + span, 0, 10);
            QImage image(200, 100, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::white);
            QPainter painter(&image);
            sheet.paint(&painter, nullptr, nullptr);
            painter.end();
            const auto red = [&](int x, int y) { return QColor(image.pixel(x, y)).green() < 60; };
            QVERIFY(red(50, 80));
            QVERIFY(red(150, 20));
            QVERIFY(!red(50, 70));
            QVERIFY(!red(50, 20));
            QVERIFY(!red(150, 80));
        }
    }

    void theLaneShowsTheJogByItsKey() {
        Bench b;
        for (int i = 0; i <= 600; ++i) {
            b.live.setJogLabel(i >= 400 && i < 500 ? QStringLiteral("X+") : QString());
            Q_EMIT b.session.stateChanged(running(i * 0.1, i >= 400 && i < 500));
        }
        b.runTo(60.1);
        const auto& seen = b.view().laneItem().segments();
        QCOMPARE(seen.size(), std::size_t{3});
        QCOMPARE(seen[0].label, QString("At standstill"));
        QCOMPARE(seen[1].label, QString("Jog X+"));
        QVERIFY(seen[1].kind == LaneKind::Moving);
        QVERIFY(near(seen[1].start, 40, 1e-6));
        QVERIFY(near(seen[1].end, 50, 1e-6));
    }

    void theLaneOfARecordingShowsItsStates() {
        Bench b;
        QTemporaryDir folder;
        for (const int time : {59, 60}) {
            Q_EMIT b.session.stateChanged(running(time, true));
        }
        PlotView& live = b.view();
        live.follow();
        QVERIFY(laneText(live, 0).contains(QLatin1String("Jog")));
        b.dock.openRecording(writeDay(folder, QStringLiteral("day.csv")));
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        const double begin = b.dock.store().timesOf(QStringLiteral("day.csv"))->firstTime();
        QCOMPARE(laneText(b.view(), begin),
                 QString("0 Moving, 30 Protective stop, 40 Moving, 60 Power off, 80 At standstill"));
        QVERIFY(b.view().laneItem().segments()[1].kind == LaneKind::Stopped);
        QVERIFY(b.view().laneItem().segments()[3].kind == LaneKind::Off);
        // Later live states do not appear there, even while the page follows the newest samples.
        b.view().follow();
        b.runTo(62);
        Q_EMIT b.session.stateChanged(running(62, true));
        QVERIFY2(!laneText(b.view(), begin).contains(QLatin1String("Jog")),
                 qPrintable(laneText(b.view(), begin)));
        // Zoomed in until there are fewer samples than pixels, a state holds until the next sample.
        b.view().showRange(begin + 39.95, begin + 40.05);
        QCOMPARE(b.view().laneItem().segments().size(), std::size_t{2});
        QVERIFY(near(b.view().laneItem().segments()[1].start, begin + 40, 0.002));
        // With a live signal on the page, the lane belongs to the signal read by the cursors.
        b.view().addSignals({QStringLiteral("actual_TCP_force_2")});
        QCOMPARE(b.view().recordingInFront(), QString());
        b.view().showRange(55, 62);
        QVERIFY(laneText(b.view(), 0).contains(QLatin1String("Jog")));
        b.view().setReadoutSignal(b.id("day.csv/actual_TCP_force_2"));
        QVERIFY2(!laneText(b.view(), 0).contains(QLatin1String("Jog")), qPrintable(laneText(b.view(), 0)));
        b.dock.pages().setCurrent(0);
        QVERIFY(laneText(live, 0).contains(QLatin1String("Jog")));
    }

    void theLaneOfARecordingWithoutModesIsEmpty_data() {
        QTest::addColumn<QString>("omitted");
        QTest::addColumn<QString>("lane");
        QTest::newRow("robot mode") << QStringLiteral("robot_mode") << QString();
        QTest::newRow("safety mode") << QStringLiteral("safety_mode") << QString();
        QTest::newRow("speeds") << QStringLiteral("actual_qd_0")
                                << QStringLiteral(
                                       "0 Running, 30 Protective stop, 40 Running, 60 Power off, 80 Running");
    }
    void theLaneOfARecordingWithoutModesIsEmpty() {
        QFETCH(QString, omitted);
        QFETCH(QString, lane);
        Bench b;
        QTemporaryDir folder;
        for (const int time : {59, 60}) {
            Q_EMIT b.session.stateChanged(running(time, true));
        }
        b.dock.openRecording(writeDay(folder, QStringLiteral("day.csv"), {omitted}));
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        const double begin = b.dock.store().timesOf(QStringLiteral("day.csv"))->firstTime();
        QCOMPARE(laneText(b.view(), begin), lane);
    }

    void closingTheRecordingsRestoresTheLiveRange() {
        Bench b;
        QTemporaryDir folder;
        const QString path = folder.filePath("short.mcap");
        QVERIFY(test::writeFile(path, test::madeFile(*recording::mcapFormat(), 1000)));
        const double span = b.view().window().span();
        const QStringList labels = b.view().timeLabels();
        b.dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        QVERIFY(b.view().window().span() < span);
        b.dock.closeRecordings();
        QCOMPARE(b.dock.pages().count(), 1);
        QVERIFY(b.view().window().follows());
        QCOMPARE(b.view().window().span(), span);
        QCOMPARE(b.view().timeLabels(), labels);
    }

    void backToLiveRestoresTheTimeRange() {
        Bench b;
        QTemporaryDir folder;
        b.view().setSpan(12);
        const QString path = writeDay(folder, QStringLiteral("day.csv"));
        b.dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        QVERIFY(near(b.view().window().span(), 100, 0.1));
        b.view().setCursor(PlotView::Cursor::A, 50.0);
        b.dock.endReplay();
        QCOMPARE(b.dock.pages().current(), 0);
        QCOMPARE(b.view().window().span(), 12.0);
        QVERIFY(b.view().window().follows());
        // Switching the tab applies the range of the recording to the live page. This range was not selected
        // by the user.
        b.dock.pages().setCurrent(1);
        b.view().setSpan(90);
        b.dock.pages().setCurrent(0);
        QCOMPARE(b.view().window().span(), 90.0);
        b.dock.pages().setCurrent(1);
        b.dock.endReplay();
        QCOMPARE(b.view().window().span(), 12.0);
        // A range chosen on the live page remains.
        b.view().setSpan(20);
        b.view().pause();
        b.view().setCursor(PlotView::Cursor::A, 50.0);
        b.dock.endReplay();
        QCOMPARE(b.view().window().span(), 20.0);
    }

    // A moving view repaints only the areas of the curves, so anything drawn elsewhere would remain.
    void notesAndLimitsAreDrawnInsideThePlotsOnly() {
        Bench b;
        b.view().pause();
        const auto outside = [&b] {
            QImage image = b.view().grab().toImage();
            QPainter painter(&image);
            for (const auto& pane : b.view().panes()) {
                painter.fillRect(pane->area(), Qt::white);
            }
            return image;
        };
        const QImage before = outside();
        b.dock.addNote(45, QStringLiteral("here it slipped"));
        b.dock.addNote(b.view().window().end(), QStringLiteral("at the edge"));
        QVERIFY2(outside() == before, "a note was drawn outside the plots");
        for (const bool above : {true, false}) {
            for (const double y : {b.forces().area().top() + 2, b.forces().area().bottom() - 2}) {
                b.dock.marks().setThresholds({{"actual_TCP_force_2", b.forces().valueAt(y), above}});
                QVERIFY2(outside() == before, qPrintable(QStringLiteral("a limit at y = %1").arg(y)));
            }
        }
    }

    void outageIsGreyWithItsDuration() {
        Bench b;
        Q_EMIT b.session.stateChanged(running(59, true));
        Q_EMIT b.session.stateChanged(running(60, true));
        SessionState lost = running(60, true);
        lost.link = LinkState::Lost;
        for (int frame = 1; frame <= 100; ++frame) {
            lost.quality.ageMs = frame * 50;
            Q_EMIT b.session.stateChanged(lost);
        }
        // The gap grows as long as data are missing, and the time axis moves with it.
        QVERIFY(near(b.view().window().end(), 65, 0.003));
        const auto seen = b.view().laneItem().segments();
        QCOMPARE(seen.size(), std::size_t{2});
        QVERIFY(seen[0].kind == LaneKind::Moving);
        QVERIFY(near(seen[0].end, 60, 0.003));
        QVERIFY(seen[1].kind == LaneKind::NoData);
        QCOMPARE(seen[1].label, QString("No data"));
        QVERIFY(near(seen[1].end, 65, 0.003));

        // New data are placed after the gap.
        b.next = 33'000;
        b.runTo(66.1);
        Q_EMIT b.session.stateChanged(running(66.1, false));
        const auto& after = b.live.lane().segments();
        QVERIFY(after.back().kind == LaneKind::Idle);
        const LaneSegment& outage = after[after.size() - 2];
        QVERIFY(outage.kind == LaneKind::NoData);
        QVERIFY(near(outage.start, 60, 0.003));
        QVERIFY(near(outage.end, 66, 0.003));
    }

    // The gap is too short to be reported in the header, but it is still not drawn as a motion.
    void aShortOutageIsNotDrawnAsMotion() {
        Bench b;
        Q_EMIT b.session.stateChanged(running(60, true));
        b.next = 30'400;  // 0.8 s later
        b.runTo(61);
        Q_EMIT b.session.stateChanged(running(61, true));
        const auto& segments = b.live.lane().segments();
        QVERIFY(segments.size() >= 2);
        const LaneSegment& silence = segments[segments.size() - 2];
        QVERIFY(silence.kind == LaneKind::NoData);
        QVERIFY(near(silence.start, 60, 0.003));
        QVERIFY(near(silence.end, 60.8, 0.003));
    }

    void exportsTheShownRangeOnly() {
        Bench b;
        QTemporaryDir folder;
        b.view().pause();
        b.view().setSpan(5);
        const QString csv = folder.filePath("range.csv");
        QVERIFY(b.dock.exportTo(csv));
        QFile file(csv);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto lines = file.readAll().trimmed().split('\n');
        QVERIFY2(std::abs(lines.size() - 1 - 2501) <= 1, qPrintable(QString::number(lines.size())));
        const QString png = folder.filePath("range.png");
        QVERIFY(b.dock.exportTo(png));
        QVERIFY(QImage(png).width() >= 1500);
    }

    // Independent of the colours of the window: white background, with a title, without buttons, and with
    // vector lines wherever possible.
    void exportedPicturesAreSuitableForPrinting() {
        applyTheme(*qApp, Theme::dark());
        const auto light = qScopeGuard([] { applyTheme(*qApp, Theme::light()); });
        Bench b;
        QTemporaryDir folder;
        const auto bytesOf = [&](const QString& name) {
            QFile file(folder.filePath(name));
            return b.dock.exportTo(file.fileName()) && file.open(QIODevice::ReadOnly) ? file.readAll()
                                                                                      : QByteArray();
        };
        const QImage png = QImage::fromData(bytesOf("a.PNG"));
        for (const QPoint& corner : {QPoint(3, 3), QPoint(png.width() - 4, png.height() - 4)}) {
            QCOMPARE(png.pixelColor(corner), QColor(Qt::white));
        }
        const QByteArray svg = bytesOf("a.svg");
        QVERIFY(svg.contains("<svg"));
        QVERIFY(svg.contains("TCP force, Joint currents"));
        QVERIFY(svg.contains("controller time"));
        QVERIFY(svg.contains("Fz"));
        for (const char* unit : {" N", " A", " s"}) {
            QVERIFY2(
                svg.contains(QByteArray(unit) + "\n</text>") || svg.contains(QByteArray(unit) + "</text>"),
                unit);
        }
        QVERIFY(svg.contains("<path") || svg.contains("<polyline"));
        QVERIFY2(!svg.contains("<image"), "curves were exported as pixels");
        QVERIFY(!svg.contains("Record"));
        const QByteArray pdf = bytesOf("a.pdf");
        QVERIFY(pdf.startsWith("%PDF"));
        QVERIFY2(!pdf.contains("/Subtype /Image"), "curves were exported as pixels");
        QVERIFY(Theme::current().isDark());
    }

    void exportedPicturesContainNotesAndLimits() {
        Bench b;
        QTemporaryDir folder;
        b.view().pause();
        const auto svgWith = [&](const QString& name) {
            QFile file(folder.filePath(name));
            return b.dock.exportTo(file.fileName()) && file.open(QIODevice::ReadOnly) ? file.readAll()
                                                                                      : QByteArray();
        };
        QVERIFY(!svgWith("without.svg").contains("jammed"));
        b.dock.marks().addNote(50, "jammed");
        b.dock.marks().add({"actual_TCP_force_2", 55, true});
        b.forces().holdValues(0, 100);
        const QByteArray svg = svgWith("with.svg");
        QVERIFY(svg.contains("jammed"));
        QVERIFY(svg.contains(b.dock.marks().words(b.dock.marks().thresholds().front()).toUtf8()));
        QVERIFY(!svg.contains("double-click"));
    }

    void unknownFileTypeIsRefusedAndUnchanged() {
        Bench b;
        QTemporaryDir folder;
        QFile file(folder.filePath("picture.gif"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
        file.close();
        const test::EventSpy messages(b.session.journal());
        QVERIFY(!b.dock.exportTo(file.fileName()));
        QVERIFY(messages.last().text.contains(".svg"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("mine"));
    }

    void failedExportGivesTheReason() {
        Bench b;
        const test::EventSpy messages(b.session.journal());
        QVERIFY(!b.dock.exportTo("/nonexistent/folder/x.csv"));
        QVERIFY(!b.dock.exportTo("/nonexistent/folder/x.png"));
        QCOMPARE(messages.count(), 2);
        for (const auto& message : messages) {
            QVERIFY(message.severity == Severity::Error);
            QVERIFY(!message.text.isEmpty());
        }
    }

    void recordingWithoutARobotSuggestsASolution() {
        Bench b;
        QTemporaryDir folder;
        b.dock.setRecordingChoice({.folder = folder.path()});
        const test::EventSpy messages(b.session.journal());
        QTest::mouseClick(b.button("plots.record"), Qt::LeftButton);
        QVERIFY(messages.count() >= 1);
        QVERIFY(messages.last().text.contains("connect", Qt::CaseInsensitive));
    }

    void theRecordKeyShowsThatItRecords() {
        Bench b;
        SessionState state = running(60, false);
        state.recording.active = true;
        state.recording.seconds = 12;
        Q_EMIT b.session.stateChanged(state);
        QVERIFY(b.button("plots.record")->text().contains("REC 00:00:12"));
        state.recording.active = false;
        Q_EMIT b.session.stateChanged(state);
        QVERIFY(b.button("plots.record")->text().contains("Record"));
    }

    void recordMenuShowsAndChangesTheRecordedFields() {
        Bench b;
        QTemporaryDir folder;
        b.dock.setRecordingChoice({.folder = folder.path(), .fields = {"actual_q"}, .every = 7});
        QSignalSpy chosen(&b.dock, &PlotDock::recordingChosen);
        QSignalSpy wanted(&b.dock, &PlotDock::recordingOptionsWanted);
        QMenu* menu = b.button("plots.recordMenu")->menu();
        Q_EMIT menu->aboutToShow();
        QAction* every10 = nullptr;
        for (QAction* action : menu->actions()) {
            if (action->objectName() == "plots.record.every") {
                QCOMPARE(action->isChecked(), action->data().toInt() == 7);
                every10 = action->data().toInt() == 10 ? action : every10;
            }
        }
        QVERIFY(every10 != nullptr);
        every10->trigger();
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(b.dock.recordingChoice().every, 10);
        QCOMPARE(b.dock.recordingChoice().folder, folder.path());
        Q_EMIT menu->aboutToShow();
        const auto find = [menu](const char* name) {
            return menu->findChild<QAction*>(QLatin1String(name), Qt::FindDirectChildrenOnly);
        };
        QVERIFY(find("plots.record.signals")->text().startsWith("1 signal"));
        QVERIFY(find("plots.record.pattern")->text().contains("{date}_{time}"));
        QCOMPARE(find("plots.record.folder")->toolTip(), QDir::toNativeSeparators(folder.path()));
        find("plots.record.signals")->trigger();
        find("plots.record.pattern")->trigger();
        QCOMPARE(wanted.count(), 2);
    }

    void theRecordKeyShowsThatItWaitsForTheTrigger() {
        Bench b;
        SessionState state = running(60, false);
        state.recording.active = state.recording.waiting = true;
        state.recording.files = 2;
        Q_EMIT b.session.stateChanged(state);
        QCOMPARE(b.button("plots.record")->text(), QString("● Waiting"));
        QVERIFY(b.button("plots.record")->property("recording").toBool());
        state.recording.waiting = false;
        state.recording.seconds = 3;
        Q_EMIT b.session.stateChanged(state);
        QVERIFY(b.button("plots.record")->text().contains("REC 00:00:03"));
    }

    void metadataIsEnteredBeforeTheRecording() {
        Bench b;
        QTemporaryDir folder;
        b.dock.setRecordingChoice(
            {.folder = folder.path(), .metadata = {"operator=Ann", "sample="}, .asksMetadata = true});
        const test::EventSpy messages(b.session.journal());
        QSignalSpy chosen(&b.dock, &PlotDock::recordingChosen);
        QTest::mouseClick(b.button("plots.record"), Qt::LeftButton);
        QPointer<QDialog> dialog = b.dock.findChild<QDialog*>("plots.metadata.dialog");
        QVERIFY(dialog != nullptr);
        QCOMPARE(messages.count(), 0);
        auto* table = dialog->findChild<QTableWidget*>("plots.metadata.table");
        auto* accept = dialog->findChild<QPushButton*>("plots.metadata.accept");
        auto* problem = dialog->findChild<QLabel*>("plots.metadata.problem");
        QCOMPARE(accept->text(), QString("Record"));
        QCOMPARE(table->rowCount(), 2);
        QCOMPARE(table->currentRow(), 1);  // the first field without a value
        table->item(1, 1)->setText("7 b");
        QTest::failOnWarning(QRegularExpression("editing failed"));
        QTest::mouseClick(dialog->findChild<QPushButton*>("plots.metadata.add"), Qt::LeftButton);
        QCOMPARE(table->rowCount(), 3);
        QVERIFY2(table->viewport()->findChild<QLineEdit*>() != nullptr, "the new name is not being edited");
        for (const auto& [name, word] : {std::pair("model", "model"), std::pair("a=b", "not valid"),
                                         std::pair("operator", "twice"), std::pair("", "no name")}) {
            table->item(2, 0)->setText(name);
            table->item(2, 1)->setText("x");
            QTest::mouseClick(accept, Qt::LeftButton);
            QVERIFY2(dialog && dialog->isVisible() && problem->text().contains(word), word);
            QCOMPARE(table->currentRow(), 2);
        }
        QTest::mouseClick(dialog->findChild<QPushButton*>("plots.metadata.remove"), Qt::LeftButton);
        QCOMPARE(problem->text(), QString());
        QTest::mouseClick(accept, Qt::LeftButton);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(b.dock.recordingChoice().metadata, (QStringList{"operator=Ann", "sample=7 b"}));
        // The dialog starts a recording, which fails without a robot.
        QVERIFY(messages.count() >= 1 && messages.last().text.contains("connect", Qt::CaseInsensitive));
        Q_EMIT b.button("plots.recordMenu")->menu()->aboutToShow();
        QVERIFY(b.button("plots.recordMenu")
                    ->menu()
                    ->findChild<QAction*>("plots.record.metadata")
                    ->text()
                    .contains('2'));
    }

    void recordingsAreListedAndSearched() {
        Bench b;
        QTemporaryDir folder;
        const QString day = writeDay(folder, QStringLiteral("day.csv"));
        QFile other(folder.filePath("other.csv"));
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.write(
            "# start: 2026-02-03T04:05:06.000000000Z\n# operator: Ann\n# sample: 7\n# model: UR5e\n"
            "timestamp,actual_q_0\n1.0,0.5\n1.5,0.75\n2.0,0.5\n");
        other.close();
        QFile damaged(folder.filePath("damaged.mcap"));
        QVERIFY(damaged.open(QIODevice::WriteOnly) && damaged.write("\x89MCAP") == 5);
        damaged.close();
        b.dock.setRecordingChoice({.folder = folder.path()});
        b.menu("plots.layout.recordings")->trigger();
        auto* dialog = b.dock.findChild<RecordingsDialog*>("plots.recordings.dialog");
        QVERIFY(dialog != nullptr && dialog->isVisible());
        auto* table = dialog->findChild<QTableWidget*>("plots.recordings.table");
        const auto* count = dialog->findChild<QLabel*>("plots.recordings.count");
        QCOMPARE(table->rowCount(), 3);
        QTRY_COMPARE_WITH_TIMEOUT(count->text(), QString("3 of 3 recording(s)"), 60'000);
        const auto rowOf = [&](const QString& name) {
            const auto found = table->findItems(name, Qt::MatchExactly);
            return found.isEmpty() ? -1 : found.front()->row();
        };
        const auto text = [&](const QString& name, int column) {
            return table->item(rowOf(name), column)->text();
        };
        QCOMPARE(text("other.csv", 3), QString("UR5e"));
        QCOMPARE(text("other.csv", 4), format::duration(1));
        QCOMPARE(text("other.csv", 5), QString("operator=Ann, sample=7"));
        QCOMPARE(text("day.csv", 4), format::duration(100));
        QVERIFY(!table->item(rowOf("day.csv"), 0)->icon().isNull());
        QVERIFY2(!text("damaged.mcap", 6).isEmpty(), "the reason is shown");
        auto* search = dialog->findChild<QLineEdit*>("plots.recordings.search");
        QTest::keyClicks(search, "ann 7");
        QCOMPARE(count->text(), QString("1 of 3 recording(s)"));
        QVERIFY(table->isRowHidden(rowOf("day.csv")) && !table->isRowHidden(rowOf("other.csv")));
        search->clear();
        // A new file appears when the list is shown again; a changed file is read again.
        QVERIFY(QFile::copy(day, folder.filePath("again.csv")));
        b.menu("plots.layout.recordings")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(count->text(), QString("4 of 4 recording(s)"), 60'000);
        table->selectRow(rowOf("again.csv"));
        QTest::mouseClick(dialog->findChild<QPushButton*>("plots.recordings.open"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(b.dock.store().hasRecordings(), 60'000);
        QCOMPARE(b.dock.store().recordings(), QStringList("again.csv"));
    }

    void aTimeOfTheLogIsShownInThePlots() {
        Bench b;
        const QDateTime first = b.framed.second;
        QTest::qWait(20);
        b.runTo(90);
        QTest::qWait(20);
        b.runTo(120);
        QTest::qWait(20);
        // The data up to 90 s were displayed between the two frames.
        b.dock.goToClock(first.addMSecs(15), false);
        QVERIFY(near(b.view().cursor(PlotView::Cursor::A).value(), 60, 0.01));
        QVERIFY(!b.view().window().follows());
        QVERIFY(b.view().window().start() <= 60 && b.view().window().end() >= 60);
        QVERIFY(b.dock.replay() && near(b.dock.replay()->time, 60, 0.01));
        b.dock.goToClock(b.framed.second.addMSecs(5), false);
        QVERIFY(near(b.view().cursor(PlotView::Cursor::A).value(), 120, 0.01));
        // Before the first frame, there are no data.
        const test::EventSpy messages(b.session.journal());
        b.dock.goToClock(first.addSecs(-3600), false);
        QCOMPARE(messages.count(), 1);
        QVERIFY(near(b.view().cursor(PlotView::Cursor::A).value(), 120, 0.01));

        // In a recording, the position follows from the start time in the file.
        QTemporaryDir folder;
        QFile file(folder.filePath("run.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "# start: 2026-02-03T04:05:06.000000000Z\ntimestamp,actual_TCP_force_2\n1.0,0\n2.0,1\n3.0,2\n");
        file.close();
        b.dock.openRecording(file.fileName());
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        const double begin = b.dock.store().timesOf("run.csv")->firstTime();
        b.dock.goToClock(QDateTime(QDate(2026, 2, 3), QTime(4, 5, 7, 500), Qt::UTC), true);
        QVERIFY(near(b.view().cursor(PlotView::Cursor::A).value() - begin, 1.5, 1e-6));
        // A row of the window's log shows the live page.
        b.dock.goToClock(b.framed.second.addMSecs(5), false);
        QCOMPARE(b.dock.pages().current(), 0);
        QVERIFY(near(b.view().cursor(PlotView::Cursor::A).value(), 120, 0.01));
    }

    // ---- appearance of curves
    void aCurveIsEdited() {
        Bench b;
        const int force = b.id("actual_TCP_force_2");
        const auto open = [&](int signal) {
            const QRectF entry = b.forces().legendEntry(signal);
            b.menuAt(entry.center(), "plots.menu.curve");
            return b.view().findChild<QDialog*>("plots.curve.dialog");
        };
        QTRY_VERIFY_WITH_TIMEOUT(!b.forces().legendEntry(force).isEmpty(), 60'000);
        QDialog* dialog = open(force);
        QVERIFY(dialog != nullptr);
        const auto edit = [&](const char* name, const QString& text) {
            dialog->findChild<QLineEdit*>(QStringLiteral("plots.curve.") + name)->setText(text);
        };
        const auto accept = [&] {
            QTest::mouseClick(dialog->findChild<QPushButton*>("plots.curve.accept"), Qt::LeftButton);
        };
        const auto* problem = dialog->findChild<QLabel*>("plots.curve.problem");
        edit("scale", "0");
        accept();
        QVERIFY2(problem->text().contains("scale") && dialog->isVisible(), qPrintable(problem->text()));
        edit("scale", "-0,002");
        edit("offset", "x");
        accept();
        QVERIFY2(problem->text().contains("offset"), qPrintable(problem->text()));
        edit("offset", "\u22121.5");
        edit("name", "Press [x]");
        accept();
        QVERIFY2(problem->text().contains("[ ]"), qPrintable(problem->text()));
        edit("name", "Press");
        edit("unit", "kN");
        dialog->findChild<QComboBox*>("plots.curve.line")->setCurrentIndex(2);
        dialog->findChild<QComboBox*>("plots.curve.axis")->setCurrentIndex(1);
        accept();
        const QString key = QStringLiteral("Press [kN] = actual_TCP_force_2 * -0.002 - 1.5");
        const PaneLayout pane = b.view().page().panes[0];
        QCOMPARE(pane.shown, (QStringList{"actual_TCP_force_0", "actual_TCP_force_1", key}));
        QCOMPARE(pane.styles.size(), 1);
        QCOMPARE(pane.styles[key].line, CurveStyle::Line::Dashed);
        QVERIFY(pane.styles[key].right);
        // The values follow the scale: Fz equals the time.
        const int press = b.id(qPrintable(key));
        QVERIFY(near(b.dock.store().valueAt(press, 40).value(), 40 * -0.002 - 1.5, 1e-6));
        QCOMPARE(b.curve(press).pen().style(), Qt::CustomDashLine);
        // The second edit shows the values of the first one, and undoing all of them restores the signal.
        QTRY_VERIFY_WITH_TIMEOUT(!b.forces().legendEntry(press).isEmpty(), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(b.view().findChild<QDialog*>("plots.curve.dialog") == nullptr, 60'000);
        dialog = open(press);
        QCOMPARE(dialog->findChild<QLineEdit*>("plots.curve.scale")->text(), QString("-0.002"));
        QCOMPARE(dialog->findChild<QLineEdit*>("plots.curve.offset")->text(), QString("-1.5"));
        QCOMPARE(dialog->findChild<QLineEdit*>("plots.curve.unit")->text(), QString("kN"));
        edit("name", b.dock.store().info(force).longLabel);
        edit("unit", "N");
        edit("scale", "1");
        edit("offset", "0");
        dialog->findChild<QComboBox*>("plots.curve.line")->setCurrentIndex(0);
        dialog->findChild<QComboBox*>("plots.curve.axis")->setCurrentIndex(0);
        accept();
        QCOMPARE(b.view().page(), PageLayout::standard());
    }

    void aCurveUsesTheAxisAtTheRight() {
        Bench b;
        const double width = b.forces().area().width();
        PageLayout page = b.view().page();
        page.panes[0].shown << "actual_current_0";
        page.panes[0].styles["actual_current_0"].right = true;
        page.panes[0].styles["actual_current_0"].color = QColor(1, 2, 3);
        QVERIFY(b.view().setPage(page));
        PlotPane& pane = b.forces();
        using Side = PlotPane::Side;
        QVERIFY(pane.hasRight());
        QCOMPARE(pane.area().width(), width - PlotPane::kValueWidth);
        // Force from 30 N to 60 N at the left, a constant current of 1 A at the right.
        QVERIFY(pane.range().max() >= 59 && pane.range(Side::Right).max() < 10);
        const int current = b.id("actual_current_0");
        QCOMPARE(b.curve(current).pen().color(), QColor(1, 2, 3));
        const QImage image = b.view().grab().toImage();
        const int x = static_cast<int>(pane.area().center().x());
        int drawn = -1;
        for (int y = static_cast<int>(pane.area().top()); y < pane.area().bottom(); ++y) {
            drawn = image.pixelColor(x, y) == QColor(1, 2, 3) ? y : drawn;
        }
        QVERIFY2(near(drawn, pane.yAt(1, Side::Right), 2), qPrintable(QString::number(drawn)));
        QVERIFY(!near(pane.yAt(1), pane.yAt(1, Side::Right), 10));
        QCOMPARE(pane.curveAt({pane.area().center().x(), pane.yAt(1, Side::Right)}), std::optional(current));
        // The wheel over an axis zooms this axis only.
        const double left = pane.range().max() - pane.range().min();
        const double right = pane.range(Side::Right).max() - pane.range(Side::Right).min();
        b.wheelAt({pane.area().right() + 20, pane.area().center().y()}, 2);
        QVERIFY(pane.range(Side::Right).max() - pane.range(Side::Right).min() < right);
        QCOMPARE(pane.range().max() - pane.range().min(), left);
        // The layout contains the style.
        const QByteArray kept = b.dock.arrangement();
        LiveHistory anotherLive(b.session);
        PlotDock another(b.session, anotherLive);
        another.arrange(kept);
        QCOMPARE(another.arrangement(), kept);
        QVERIFY(another.view().page().panes[0].styles["actual_current_0"].right);
        QCOMPARE(another.view().page().panes[0].styles["actual_current_0"].color, QColor(1, 2, 3));
    }

    void limitsOfAnAxisAreTypedAndKept() {
        Bench b;
        b.menuAt(b.forces().area().center(), "plots.menu.limits");
        auto* dialog = b.view().findChild<QDialog*>("plots.limits.dialog");
        QVERIFY(dialog != nullptr);
        const auto field = [&](const char* name) {
            return dialog->findChild<QLineEdit*>(QLatin1String(name));
        };
        QVERIFY(field("plots.limits.low1") == nullptr);  // there is no second axis
        QVERIFY(!field("plots.limits.low0")->isEnabled());
        dialog->findChild<QCheckBox*>("plots.limits.fixed0")->setChecked(true);
        field("plots.limits.low0")->setText("80");
        field("plots.limits.high0")->setText("-12,5");
        auto* accept = dialog->findChild<QPushButton*>("plots.limits.accept");
        QTest::mouseClick(accept, Qt::LeftButton);
        QVERIFY(dialog->isVisible() &&
                dialog->findChild<QLabel*>("plots.limits.problem")->text().contains("less"));
        field("plots.limits.high0")->setText("812.5");
        QTest::mouseClick(accept, Qt::LeftButton);
        const auto shows = [&](double low, double high) {
            return near(b.forces().range().min(), low, 1e-9) && near(b.forces().range().max(), high, 1e-9);
        };
        QVERIFY(shows(80, 812.5));
        b.runTo(70);
        QVERIFY(shows(80, 812.5));
        // The layout and the other pages keep the limits. A zoom is temporary.
        QVERIFY(b.dock.arrangement().contains("\"limits\":[80,812.5]"));
        b.wheelAt({5, b.forces().area().center().y()}, 2);
        QVERIFY(!shows(80, 812.5));
        b.view().fit();
        QVERIFY(shows(80, 812.5));
        b.menuAt(b.forces().area().center(), "plots.menu.release");
        QVERIFY(b.forces().range().max() < 150 && !b.forces().isZoomed());
        QVERIFY(!b.dock.arrangement().contains("limits\":["));
    }

    void invalidStylesOfALayoutAreIgnored() {
        QByteArray json =
            "{'pages':[{'plots':[{'signals':['a','b'],'limits':[3,3],'right_limits':[1,'x'],'styles':["
            "{'signal':'a','color':'not a colour','line':'wavy'},{'signal':'','right':true},"
            "{'signal':'b','color':'#0a0B0c','line':'dotted'},5]}]}]}";
        const Result<PlotLayout> layout = PlotLayout::fromJson(json.replace('\'', '"'));
        QVERIFY(layout.ok());
        const PaneLayout& pane = layout->pages[0].panes[0];
        QVERIFY(!pane.limits && !pane.rightLimits);
        QCOMPARE(pane.styles.keys(), QStringList("b"));
        QCOMPARE(pane.styles["b"].color, QColor(10, 11, 12));
        QCOMPARE(pane.styles["b"].line, CurveStyle::Line::Dotted);
        QVERIFY(!pane.styles["b"].right);
    }

    // ---- spectrum, XY, time axis
    void spectrumShowsItsWindowAndResolution() {
        Bench b;
        b.menu("plots.layout.analysis")->trigger();
        auto* analysis = b.dock.findChild<PlotAnalysis*>();
        QVERIFY(analysis->isVisible());
        b.view().addSignals({"actual_q_1"});
        b.view().setCursor(PlotView::Cursor::A, 10);
        b.view().setCursor(PlotView::Cursor::B, 50);
        auto* box = analysis->findChild<QComboBox*>("plots.analysis.signal");
        QTRY_VERIFY_WITH_TIMEOUT(box->findData(b.id("actual_q_1")) >= 0, 60'000);
        box->setCurrentIndex(box->findData(b.id("actual_q_1")));
        Q_EMIT box->activated(box->currentIndex());
        QVERIFY2(analysis->title().contains("Hann window of 8192") && analysis->title().contains("0.061 Hz"),
                 qPrintable(analysis->title()));
        QVERIFY(analysis->title().contains("10.000") && analysis->title().contains("50.000"));
        // The oscillation has a period of 2 pi seconds.
        const QVector<QPointF>& lines = analysis->canvas().points();
        const auto top = std::max_element(lines.begin(), lines.end(),
                                          [](const QPointF& a, const QPointF& c) { return a.y() < c.y(); });
        QVERIFY(std::abs(top->x() - 1 / 6.2832) < 0.061);
        QVERIFY(top->y() > 0.7 && top->y() < 1.01);
        QCOMPARE(analysis->canvas().xAxis().title, QString("Frequency [Hz]"));
        // If the range is too short, the panel shows a hint.
        b.view().setCursor(PlotView::Cursor::B, 10.01);
        QTRY_VERIFY_WITH_TIMEOUT(analysis->canvas().points().isEmpty(), 60'000);
        QVERIFY(analysis->canvas().message().contains("longer"));
    }

    void lanesWithoutSpaceDoNotCoverCurves() {
        Bench b;
        QTest::mouseClick(b.button("plots.valuesKey"), Qt::LeftButton);
        const auto lowest = [&] {
            double bottom = 0;
            for (const auto& pane : b.view().panes()) {
                bottom = std::max(bottom, pane->area().bottom());
            }
            return bottom;
        };
        for (const int height : {1, 260, 320, 700}) {
            b.dock.resize(900, height);
            QTest::qWait(1);
            const LaneItem& lane = b.view().laneItem();
            QVERIFY2(!lane.isVisible() || lane.area().top() >= lowest(), qPrintable(QString::number(height)));
            QVERIFY(height == 260 || height == 320 || lane.isVisible() == (height > 320));
        }
    }

    void theAnalysisSelectorStaysUnderThePointer() {
        Bench b;
        b.menu("plots.layout.analysis")->trigger();
        b.view().addSignals({"actual_q_1"});
        b.dock.resize(1, 400);  // minimum width
        auto* analysis = b.dock.findChild<PlotAnalysis*>();
        auto* kind = b.dock.findChild<QAbstractButton*>("plots.analysis.kind.1");
        QTRY_VERIFY_WITH_TIMEOUT(kind != nullptr && kind->isVisible(), 60'000);
        const QRect before(kind->mapTo(analysis, QPoint()), kind->size());
        const int least = b.dock.minimumSizeHint().width();
        QTest::mouseClick(kind, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(b.dock.findChild<QWidget*>("plots.analysis.over")->isVisible(), 60'000);
        QTest::qWait(1);
        QCOMPARE(QRect(kind->mapTo(analysis, QPoint()), kind->size()), before);
        QCOMPARE(b.dock.minimumSizeHint().width(), least);
    }

    void oneSignalIsPlottedOverAnother() {
        Bench b;
        b.menu("plots.layout.analysis")->trigger();
        auto* analysis = b.dock.findChild<PlotAnalysis*>();
        b.view().addSignals({"actual_q_1"});
        b.view().setCursor(PlotView::Cursor::A, 19.999);
        b.view().setCursor(PlotView::Cursor::B, 21.999);
        auto* over = analysis->findChild<QComboBox*>("plots.analysis.over");
        QVERIFY(!over->isVisible());
        QCoreApplication::processEvents();  // processes the pending layout requests
        auto* kind = analysis->findChild<SegmentedControl*>("plots.analysis.kind");
        QTest::mouseClick(kind->segment(1), Qt::LeftButton);
        QVERIFY(over->isVisible());
        auto* signal = analysis->findChild<QComboBox*>("plots.analysis.signal");
        QTRY_VERIFY_WITH_TIMEOUT(over->findData(b.id("actual_q_1")) >= 0, 60'000);
        over->setCurrentIndex(over->findData(b.id("actual_q_1")));
        signal->setCurrentIndex(signal->findData(b.id("actual_TCP_force_2")));
        Q_EMIT signal->activated(signal->currentIndex());
        const QVector<QPointF>& points = analysis->canvas().points();
        QCOMPARE(points.size(), qsizetype(1000));
        for (const QPointF& point : points) {
            QVERIFY(std::abs(point.x() - std::sin(point.y())) < 1e-5);
        }
        QVERIFY2(analysis->title().contains("1000"), qPrintable(analysis->title()));
    }

    /// The values of a long recording are calculated in the background, and the panel stays responsive.
    void statisticsCoverAWholeLongRecording() {
        const test::Long recorded;
        Bench b;
        b.dock.resize(1500, 700);
        b.dock.openRecording(recorded.path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        const QString key = QStringLiteral("long.mcap/actual_TCP_force_2");
        const int force = b.dock.store().find(key);
        QVERIFY(force >= 0 && b.view().panes()[0]->shows(force));
        const double begin = b.dock.store().timesOf("long.mcap")->firstTime();
        b.menu("plots.layout.values")->trigger();
        b.view().setCursor(PlotView::Cursor::A, begin + 300);
        b.view().setCursor(PlotView::Cursor::B, begin + 1300);
        auto* table = b.dock.findChild<QTableWidget*>("plots.values.table");
        int row = -1;
        const auto cell = [&](int column) {
            for (row = 0; row < table->rowCount(); ++row) {
                if (table->item(row, 0)->text().contains("Fz")) {
                    return table->item(row, column)->text();
                }
            }
            return QString();
        };
        constexpr int kMin = 4;
        constexpr int kMax = 5;
        QTRY_COMPARE_WITH_TIMEOUT(cell(kMin), QString("…"), 60'000);
        auto* between = b.dock.findChild<QLabel*>("plots.values.between");
        QVERIFY(between->text().contains("calculating"));
        QTRY_COMPARE_WITH_TIMEOUT(cell(kMin), QString("−40.0"), 60'000);
        QCOMPARE(cell(kMax), QString("40.0"));
        QVERIFY(!between->text().contains("calculating"));
        // After the cursor has moved, the value is displayed when the table is next updated.
        b.view().setCursor(PlotView::Cursor::B, begin + 1100);
        QTRY_VERIFY_WITH_TIMEOUT(between->text().contains("800"), 60'000);
        QCOMPARE(cell(kMin), QString("−40.0"));

        b.menu("plots.layout.analysis")->trigger();
        auto* analysis = b.dock.findChild<PlotAnalysis*>();
        const auto choose = [&](const char* name) {
            auto* box = analysis->findChild<QComboBox*>(name);
            QTRY_VERIFY_WITH_TIMEOUT(box->findData(force) >= 0, 60'000);
            box->setCurrentIndex(box->findData(force));
            Q_EMIT box->activated(box->currentIndex());
        };
        choose("plots.analysis.signal");
        QTRY_VERIFY_WITH_TIMEOUT(analysis->canvas().message().contains("Reading the recording"), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(analysis->title().contains("Hann window of 8192"), 60'000);
        QVERIFY2(analysis->title().contains("300.000 to 1100.000 s"), qPrintable(analysis->title()));
        const QVector<QPointF>& lines = analysis->canvas().points();
        const auto top = std::max_element(lines.begin(), lines.end(),
                                          [](const QPointF& a, const QPointF& c) { return a.y() < c.y(); });
        // The amplitude is one radian per thousand rows.
        QVERIFY2(std::abs(top->x() - 0.5 / 6.2832) < 0.062, qPrintable(QString::number(top->x())));
        analysis->setKind(PlotAnalysis::Kind::Xy);
        QTRY_VERIFY_WITH_TIMEOUT(analysis->title().contains("1 of every 8"), 60'000);
        QVERIFY(analysis->canvas().points().size() > 49'000);
        for (const QPointF& point : analysis->canvas().points()) {
            QVERIFY(std::abs(point.y()) <= 40);
        }
        // A signal derived through the menu of a curve belongs to the recording.
        const auto norm =
            b.dock.store().derive(QStringLiteral("|F| [N] = norm(%1)").arg(DerivedSignal::written(key)));
        QVERIFY(norm.ok());
        b.view().addSignals({b.dock.store().info(*norm).key});
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.store().computedPart(*norm), 1.0, 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(!b.curve(*norm).range().isEmpty(), 60'000);
        b.view().fit();
        QTRY_VERIFY_WITH_TIMEOUT(b.curve(*norm).range().max == 40, 60'000);
    }

    /// The menu of a curve derives signals from columns with any name.
    void theMenuDerivesSignalsFromForeignColumns() {
        Bench b;
        QTemporaryDir folder;
        const QString path = folder.filePath("a {strange} one = 2.csv");
        {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("time,\"Fx [N] = a name of more letters than anybody would read\"\n");
            for (int i = 0; i < 2000; ++i) {
                file.write(QByteArray::number(i * 0.002, 'f', 4) + ',' + QByteArray::number(i * 0.5) + '\n');
            }
        }
        b.dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        const PlotPane& pane = *b.view().panes()[0];
        QVERIFY(!pane.shown().empty());
        const int before = b.dock.store().count();
        b.menuAt(pane.area().center(), "plots.menu.derivative");
        QCOMPARE(b.dock.store().count(), before + 1);
        QVERIFY(std::abs(b.dock.store().value(before, 1000) - 250) < 1e-3);
    }

    void timeAxisUsesTheChosenOrigin() {
        Bench b;
        const auto choose = [&](TimeAxis axis) {
            b.menu("plots.layout.save");
            for (QAction* action : b.dock.findChild<QMenu*>("plots.layout.time")->actions()) {
                if (action->data().toInt() == static_cast<int>(axis)) {
                    action->trigger();
                    return;
                }
            }
        };
        b.view().showRange(20, 50);
        for (const QString& label : b.view().timeLabels()) {
            QVERIFY2(label.startsWith(QChar(0x2212)) || label.startsWith('-'), qPrintable(label));
        }
        choose(TimeAxis::Controller);
        QVERIFY2(b.view().timeLabels().contains("30 s"), qPrintable(b.view().timeLabels().join('|')));
        choose(TimeAxis::Clock);
        static const QRegularExpression kClock("^\\d\\d:\\d\\d:\\d\\d$");
        QVERIFY(!b.view().timeLabels().isEmpty());
        for (const QString& label : b.view().timeLabels()) {
            QVERIFY2(kClock.match(label).hasMatch(), qPrintable(label));
        }
        // After a restart, the controller's clock is shown and exported.
        b.restartedAt = b.next;
        b.runTo(90);
        choose(TimeAxis::Controller);
        b.view().showRange(65, 85);
        QVERIFY2(b.view().timeLabels().contains("10 s"), qPrintable(b.view().timeLabels().join('|')));
        QVERIFY2(!b.view().timeLabels().contains("70 s"), qPrintable(b.view().timeLabels().join('|')));
        QTemporaryDir folder;
        const QString path = folder.filePath("range.csv");
        const SignalStore& store = b.dock.store();
        QVERIFY(exportCsv(store, {store.find("actual_TCP_force_2")}, 50, 80, path).ok());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        file.readLine();
        int rows = 0;
        for (; !file.atEnd(); ++rows) {
            const QByteArrayList cells = file.readLine().trimmed().split(',');
            const double time = cells.at(1).toDouble();  // of the test
            QVERIFY(near(cells.at(0).toDouble(), time > 60.001 ? time - 60.002 : time, 1e-4));
        }
        QVERIFY(rows > 14'000);
        choose(TimeAxis::Clock);
        // The time axis is saved with the layout.
        const QByteArray kept = b.dock.arrangement();
        choose(TimeAxis::Relative);
        b.dock.arrange(kept);
        QVERIFY(b.view().timeAxis() == TimeAxis::Clock);
    }

    void theAxisOfARecordingHasTheClocksOfTheRecording() {
        Bench b;
        QTemporaryDir folder;
        const QString path = folder.filePath("run.csv");
        {
            // After five seconds, the controller was restarted.
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("# start: 2026-11-27T10:00:00.000000000Z\ntimestamp,actual_TCP_force_0\n");
            for (int i = 0; i < 1000; ++i) {
                file.write(QByteArray::number((i < 500 ? 700 : -4) + i * 0.01, 'f', 2) + ",1\n");
            }
        }
        b.dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        const double begin = b.dock.store().timesOf("run.csv")->firstTime();
        const auto labelsOf = [&](TimeAxis axis) {
            b.dock.setTimeAxis(axis);
            b.view().showRange(begin, begin + 10);
            return b.view().timeLabels();
        };
        const auto hasAll = [](const QStringList& labels, const QStringList& expected) {
            return std::all_of(expected.begin(), expected.end(),
                               [&labels](const QString& each) { return labels.contains(each); });
        };
        const QStringList relative = labelsOf(TimeAxis::Relative);
        QVERIFY2(hasAll(relative, {"2 s", "4 s", "8 s"}), qPrintable(relative.join('|')));
        const QStringList controller = labelsOf(TimeAxis::Controller);
        QVERIFY2(hasAll(controller, {"702 s", "704 s", "2 s", "4 s"}), qPrintable(controller.join('|')));
        const QStringList clock = labelsOf(TimeAxis::Clock);
        const QDateTime start(QDate(2026, 11, 27), QTime(10, 0), Qt::UTC);
        const auto at = [&start](int seconds) {
            return start.addSecs(seconds).toLocalTime().toString("HH:mm:ss");
        };
        QVERIFY2(hasAll(clock, {at(2), at(8)}), qPrintable(clock.join('|')));
        // The readout of a cursor has the same origin.
        b.dock.setTimeAxis(TimeAxis::Relative);
        b.view().setCursor(PlotView::Cursor::A, begin + 2.5);
        QVERIFY2(b.view().readout().contains("2.500"), qPrintable(b.view().readout()));
    }

    // ---- signals
    void aDoubleClickInTheListPutsTheSignalOntoThePlot() {
        Bench b;
        auto* key = b.button("plots.signals");
        auto* tree = b.dock.findChild<QTreeView*>("signals.tree");
        QVERIFY(!tree->isVisible());
        QTest::mouseClick(key, Qt::LeftButton);
        QVERIFY(tree->isVisible() && key->isChecked());
        b.list("torque tcp");
        const QModelIndex family = b.rowOf("TCP torque [Nm]");
        QVERIFY(family.isValid());
        tree->scrollTo(family);
        const QPoint place = tree->visualRect(family).center();
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(tree->viewport(), Qt::LeftButton, {}, place);
        QVERIFY(b.forces().shows(b.id("actual_TCP_force_0")));
        for (const char* torque : {"actual_TCP_force_3", "actual_TCP_force_4", "actual_TCP_force_5"}) {
            QVERIFY2(b.forces().shows(b.id(torque)), torque);
        }
        // The signal list can be operated with the keyboard alone.
        b.list("joint positions shoulder");
        const QModelIndex shoulder = b.rowOf("Shoulder");
        QVERIFY(shoulder.isValid());
        tree->setCurrentIndex(shoulder);
        tree->setFocus();
        QTest::keyClick(tree, Qt::Key_Return);
        QVERIFY(b.forces().shows(b.id("actual_q_1")));
        QVERIFY(!b.curve(b.id("actual_q_1")).range().isEmpty());
        QVERIFY2(b.forces().unit().isEmpty(), "a plot with newtons and radians shows a unit");
    }

    void listFindsWordsInAnyOrderAndReportsEmptyResults() {
        Bench b;
        b.dock.setSignalsShown(true);
        b.list("elbow temperatures");
        QVERIFY(b.rowOf("Elbow").isValid());
        QVERIFY(!b.rowOf("TCP force [N]").isValid());
        b.list("tcp_force_scalar");
        QVERIFY(b.rowOf("TCP force, norm [N]").isValid());
        b.list("qqxyz");
        QVERIFY(b.dock.findChild<QWidget*>("signals.nothingFound")->isVisible());
        b.list("");
        QVERIFY(b.rowOf("TCP force [N]").isValid());
        QVERIFY(!b.dock.findChild<QWidget*>("signals.nothingFound")->isVisible());
    }

    void dropPositionDeterminesTheTarget_data() {
        QTest::addColumn<double>("along");
        QTest::addColumn<double>("down");
        QTest::addColumn<int>("panes");
        QTest::addColumn<int>("at");
        QTest::addColumn<int>("column");
        QTest::newRow("into the plot") << 0.5 << 0.5 << 2 << 0 << 0;
        QTest::newRow("below it") << 0.5 << 0.95 << 3 << 1 << 0;
        QTest::newRow("above it") << 0.5 << 0.05 << 3 << 0 << 0;
        QTest::newRow("beside it") << 0.97 << 0.5 << 3 << 2 << 1;
    }
    void dropPositionDeterminesTheTarget() {
        QFETCH(double, along);
        QFETCH(double, down);
        QFETCH(int, panes);
        QFETCH(int, at);
        QFETCH(int, column);
        Bench b;
        const QRectF area = b.forces().area();
        b.drop({area.left() + along * area.width(), area.top() + down * area.height()}, {"actual_q_1"});
        QCOMPARE(static_cast<int>(b.view().panes().size()), panes);
        const PlotPane& pane = *b.view().panes()[static_cast<std::size_t>(at)];
        QVERIFY(pane.shows(b.id("actual_q_1")));
        QCOMPARE(pane.column(), column);
        QVERIFY(!b.curve(b.id("actual_q_1")).range().isEmpty());
        // Both columns show the same time.
        const QRectF& there = pane.area();
        QVERIFY(near(b.view().timeAt(there.left()), b.view().window().start(), 1e-9));
        QVERIFY(near(b.view().timeAt(there.right() - 1e-6), b.view().window().end(), 0.001));
        for (const auto& one : b.view().panes()) {
            for (const auto& other : b.view().panes()) {
                QVERIFY(one == other || !one->area().intersects(other->area()));
            }
        }
    }

    void bitsAndModesBecomeLanes() {
        Bench b;
        b.drop(b.forces().area().center(), {"actual_digital_input_bits.3", "robot_mode"});
        QCOMPARE(b.view().panes().size(), std::size_t{2});
        const LaneItem* input = b.view().signalLane(b.id("actual_digital_input_bits.3"));
        QVERIFY(input != nullptr);
        QCOMPARE(input->segments().size(), std::size_t{3});
        QVERIFY(input->segments()[1].kind == LaneKind::High);
        QVERIFY(near(input->segments()[1].start, 40, 0.05));
        QVERIFY(near(input->segments()[1].end, 50, 0.05));
        const LaneItem* mode = b.view().signalLane(b.id("robot_mode"));
        QCOMPARE(mode->segments().front().label, b.dock.store().info(b.id("robot_mode")).stateName(7));
        QVERIFY(mode->area().top() > input->area().bottom());
        // Removes the lane again.
        b.menuAt(input->area().center(), "plots.menu.removeLane");
        QVERIFY(b.view().signalLane(b.id("actual_digital_input_bits.3")) == nullptr);
        QVERIFY(b.view().signalLane(b.id("robot_mode")) != nullptr);
    }

    void plotMenuMovesAndRemovesPlots() {
        Bench b;
        b.menuAt(b.forces().area().center(), "plots.menu.move");
        QCOMPARE(b.view().panes().size(), std::size_t{3});
        QVERIFY(b.view().panes()[1]->shows(b.id("actual_TCP_force_2")));
        QVERIFY(!b.forces().shows(b.id("actual_TCP_force_2")));
        b.menuAt(b.view().panes()[1]->area().center(), "plots.menu.removePane");
        QCOMPARE(b.view().panes().size(), std::size_t{2});
        b.menuAt(b.forces().area().center(), "plots.menu.beside");
        QCOMPARE(b.view().panes().size(), std::size_t{3});
        QVERIFY(b.view().panes()[2]->shown().empty());
        QVERIFY(!b.dock.grab().isNull());
        b.drop(b.view().panes()[2]->area().center(), {"actual_q_1"});
        QVERIFY(b.view().panes()[2]->shows(b.id("actual_q_1")));
        QTest::keyClick(&b.view(), Qt::Key_Delete, Qt::ControlModifier);
        QVERIFY(b.view().panes()[2]->shown().empty());
    }

    void pagesShowTheSameTimeAndCursors() {
        Bench b;
        b.view().pause();
        b.view().setSpan(7);
        b.view().setCursor(PlotView::Cursor::A, 55.0);
        PlotView* first = &b.view();
        auto* menu = b.button("plots.layout")->menu();
        const auto run = [menu](const char* name) {
            Q_EMIT menu->aboutToShow();
            menu->findChild<QAction*>(QLatin1String(name), Qt::FindDirectChildrenOnly)->trigger();
        };
        auto* tabs = b.dock.findChild<QTabBar*>("plots.pages");
        QVERIFY(!tabs->isVisible());
        run("plots.layout.addPage");
        QVERIFY(tabs->isVisible());
        QVERIFY(&b.view() != first);
        QCOMPARE(b.view().window().span(), 7.0);
        QCOMPARE(b.view().cursor(PlotView::Cursor::A).value(), 55.0);
        b.drop(b.view().panes()[0]->area().center(), {"actual_q_1", "robot_mode"});
        b.view().setCursor(PlotView::Cursor::B, 56.0);
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(0).center());
        QVERIFY(&b.view() == first);
        QCOMPARE(b.view().cursor(PlotView::Cursor::B).value(), 56.0);
        // Saving and restoring reproduces the same plots.
        const QByteArray kept = b.dock.arrangement();
        LiveHistory anotherLive(b.session);
        PlotDock another(b.session, anotherLive);
        another.arrange(kept);
        QCOMPARE(another.arrangement(), kept);
        QCOMPARE(another.pages().count(), 2);
        another.arrange("what is this");
        QCOMPARE(another.arrangement(), kept);
        QTemporaryDir folder;
        QVERIFY(b.dock.saveArrangement(folder.filePath("mine.json")).ok());
        run("plots.layout.standard");
        QCOMPARE(b.dock.pages().count(), 1);
        QVERIFY(b.dock.openArrangement(folder.filePath("mine.json")).ok());
        QCOMPARE(b.dock.arrangement(), kept);
        QVERIFY(!b.dock.openArrangement(folder.filePath("none.json")).ok());
        run("plots.layout.removePage");
        QCOMPARE(b.dock.pages().count(), 1);
        QVERIFY(b.view().panes()[0]->shows(b.id("actual_q_1")));
    }

    void additionalSignalsAreRequested() {
        Bench b;
        QSignalSpy asked(&b.dock.store(), &SignalStore::furtherFieldsChanged);
        b.drop(b.forces().area().center(), {"tcp_force_scalar"});
        QCOMPARE(asked.count(), 1);
        test::SampleStream further;
        further.layout = std::make_shared<const receive::SampleLayout>(
            std::vector<std::string>{"timestamp", "tcp_force_scalar"});
        for (int i = 0; i < 500; ++i) {
            further.set(further.add(59 + i * 0.002, static_cast<std::uint64_t>(i) + 1), "tcp_force_scalar",
                        33);
        }
        further.frame([&b](const SampleBatch& batch) { Q_EMIT b.session.extraSamplesReceived(batch); });
        b.runTo(61);
        QVERIFY((b.curve(b.id("tcp_force_scalar")).range() == MinMax{33, 33}));
        QTest::keyClick(&b.view(), Qt::Key_Delete, Qt::ControlModifier);
        QCOMPARE(asked.last()[0].toStringList(), QStringList());
    }

    // ---- performance
    void aScrollingViewPaintsOnlyItsNewColumns() {
        Bench b;
        const int columns = static_cast<int>(b.forces().curves()[0]->columns().size());
        QVERIFY(columns > 1000);
        for (int frame = 1; frame <= 20; ++frame) {
            b.runTo(60 + frame * 0.1);  // nearly five columns per frame
            // Fz grows, so the scale occasionally changes and the whole plot is repainted.
            const int painted = b.forces().sheet().columnsPainted();
            QVERIFY2(painted <= 12 || painted == columns, qPrintable(QString::number(painted)));
            const int below = b.view().panes()[1]->sheet().columnsPainted();
            QVERIFY2(below > 0 && below <= 12, qPrintable(QString::number(below)));
        }
        // The cached image equals a complete repaint.
        for (const auto& pane : b.view().panes()) {
            pane->holdValues(-20, 80);
        }
        b.runTo(62.5);
        b.runTo(63);
        const QImage kept = b.view().grab().toImage();
        b.view().setHidden(b.id("actual_current_1"), true);
        b.view().setHidden(b.id("actual_current_1"), false);
        QCOMPARE(b.view().panes()[1]->sheet().columnsPainted(), columns);
        const QImage repainted = b.view().grab().toImage();
        QCOMPARE(kept, repainted);
    }

    void hiddenPlotsAreNotDrawn() {
        Bench b;
        b.dock.hide();
        const std::int64_t shown = b.view().panes()[0]->curves()[0]->raster();
        b.runTo(70);
        QCOMPARE(b.view().panes()[0]->curves()[0]->raster(), shown);
        b.dock.show();
        QVERIFY(b.view().panes()[0]->curves()[0]->raster() > shown);
    }

    // Otherwise, the button would move away from the pointer when the panel has its minimum height.
    void buttonsDoNotIncreaseThePanelHeight_data() {
        QTest::addColumn<QString>("key");
        QTest::newRow("values") << "plots.valuesKey";
        QTest::newRow("signals") << "plots.signals";
    }
    void buttonsDoNotIncreaseThePanelHeight() {
        QFETCH(QString, key);
        Bench b;
        QTRY_VERIFY_WITH_TIMEOUT(b.dock.minimumSizeHint().height() > 0, 60'000);
        const int before = b.dock.minimumSizeHint().height();
        QTest::mouseClick(b.button(qPrintable(key)), Qt::LeftButton);
        QTest::qWait(1);
        QTRY_VERIFY2_WITH_TIMEOUT(
            b.dock.minimumSizeHint().height() <= before,
            qPrintable(QStringLiteral("%1, was %2").arg(b.dock.minimumSizeHint().height()).arg(before)),
            60'000);
        QTest::mouseClick(b.button(qPrintable(key)), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.minimumSizeHint().height(), before, 60'000);
    }

    // ---- values, notes, alarms
    void aClickInARecordingPlacesCursorA() {
        Bench b;
        QTemporaryDir folder;
        b.view().pause();
        b.view().setCursor(PlotView::Cursor::A, 40.0);
        b.dock.openRecording(writeDay(folder, QStringLiteral("day.csv")));
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        const double begin = b.dock.store().timesOf(QStringLiteral("day.csv"))->firstTime();
        b.view().setCursor(PlotView::Cursor::A, begin - 1000);
        const QPoint place(b.view().viewport()->width() / 2, 60);
        QTest::mouseClick(b.view().viewport(), Qt::LeftButton, {}, place);
        QVERIFY(b.view().cursor(PlotView::Cursor::A) > begin);
        QVERIFY(!b.view().cursor(PlotView::Cursor::B));
    }

    void tableShowsStatisticsBetweenTheCursors() {
        Bench b;
        b.view().pause();
        QTest::mouseClick(b.button("plots.valuesKey"), Qt::LeftButton);
        auto* table = b.dock.findChild<QTableWidget*>("plots.values.table");
        QVERIFY(table->isVisible());
        b.view().setCursor(PlotView::Cursor::A, 40.0);
        b.view().setCursor(PlotView::Cursor::B, 50.0);
        const auto cell = [&](const QString& column) {
            for (int c = 0; c < table->columnCount(); ++c) {
                if (table->horizontalHeaderItem(c)->text() == column && table->rowCount() > 2) {
                    return table->item(2, c)->text();  // Fz, which equals the time
                }
            }
            return QString();
        };
        QTRY_COMPARE_WITH_TIMEOUT(cell("B − A"), QString("10.0"), 60'000);
        QCOMPARE(cell("Min"), QString("40.0"));
        QCOMPARE(cell("Max"), QString("50.0"));
        QCOMPARE(cell("Mean"), QString("45.00"));
        QCOMPARE(cell("Peak to peak"), QString("10.0"));
        QCOMPARE(cell("Slope per second"), QString("1.00"));
        QCOMPARE(cell("Std"), QString("2.887"));  // 10 / sqrt(12)
        QCOMPARE(cell("RMS"), QString("45.09"));
        QVERIFY(b.dock.findChild<QLabel*>("plots.values.between")->text().contains("10.0000 s"));
        QVERIFY(b.dock.findChild<QLabel*>("plots.values.between")->text().contains("0.100 Hz"));
        table->setFocus();
        QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
        QVERIFY(QApplication::clipboard()->text().contains("Fz [N]\t40.0\t50.0\t10.0"));
        // Other programs read only numbers with an ASCII minus sign.
        b.view().setCursor(PlotView::Cursor::B, 30.0);
        QTRY_COMPARE_WITH_TIMEOUT(cell("B − A"), QString("−10.0"), 60'000);
        QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
        QVERIFY2(QApplication::clipboard()->text().contains("Fz [N]\t40.0\t30.0\t-10.0"),
                 qPrintable(QApplication::clipboard()->text()));
    }

    void aNoteIsNotPlacedAtAnInvisibleCursor() {
        Bench b;
        b.view().pause();
        b.view().setCursor(PlotView::Cursor::A, 45.0);
        b.view().showRange(40.0, 50.0);
        QCOMPARE(b.view().noteTime(), 45.0);
        b.view().showRange(46.0, 56.0);
        QCOMPARE(b.view().noteTime(), b.view().window().end());
    }

    void noteIsWrittenWithNAtItsTime() {
        Bench b;
        b.view().pause();
        b.view().setCursor(PlotView::Cursor::A, 45.0);
        const test::EventSpy notes(b.session.journal(), JournalEvent::Kind::Note);
        const test::EventSpy messages(b.session.journal());
        QTimer::singleShot(0, &b.dock, [] {
            QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() != nullptr, 60'000);
            QTest::keyClicks(QApplication::activeModalWidget()->findChild<QLineEdit*>(), "here it slipped");
            QTest::keyClick(QApplication::activeModalWidget()->findChild<QLineEdit*>(), Qt::Key_Return);
        });
        const QImage before = b.view().grab().toImage();
        QTest::keyClick(&b.view(), Qt::Key_N);
        QCOMPARE(b.dock.marks().marks().size(), std::size_t{1});
        QCOMPARE(b.dock.marks().marks()[0].text, QString("here it slipped"));
        QCOMPARE(b.dock.marks().marks()[0].time, 45.0);
        // Recordings store the note at the time of its flag, 15 s before the newest sample, rather than at
        // the current time.
        QCOMPARE(notes.count(), 1);
        QCOMPARE(messages.count(), 0);
        QCOMPARE(notes.last().text, QString("here it slipped"));
        const qint64 stored = notes.last().noteUtcNs / 1'000'000 + 15'000;
        QVERIFY(stored >= b.framed.first.toMSecsSinceEpoch() - 1 &&
                stored <= b.framed.second.toMSecsSinceEpoch() + 1);
        QVERIFY(b.view().grab().toImage() != before);
    }

    void aThresholdAlarmsOncePerExcursion() {
        Bench b;
        const double limit = 65;
        b.dock.marks().add({"actual_TCP_force_2", limit, true});
        b.dock.marks().add({"actual_current_0", 0.5, false});
        const test::EventSpy messages(b.session.journal());
        b.runTo(64.9);
        QCOMPARE(messages.count(), 0);
        b.runTo(66);
        b.runTo(67);
        QCOMPARE(messages.count(), 1);
        QVERIFY(messages.last().text.contains("Fz is above 65.0 N"));
        QCOMPARE(b.dock.marks().marks().size(), std::size_t{1});
        QVERIFY(near(b.dock.marks().marks()[0].time, 65.002, 0.0021));
        // Thresholds are saved with the plots and removed through the plot menu.
        LiveHistory anotherLive(b.session);
        PlotDock another(b.session, anotherLive);
        another.arrange(b.dock.arrangement());
        QCOMPARE(another.marks().thresholds(), b.dock.marks().thresholds());
        b.menuAt(b.forces().area().center(), "plots.menu.noAlarm");
        QCOMPARE(b.dock.marks().thresholds().size(), 1);
        b.menuAt(b.forces().area().center(), "plots.menu.alarmAbove");
        QCOMPARE(b.dock.marks().thresholds().size(), 2);
        QVERIFY(near(b.dock.marks().thresholds()[1].limit, b.forces().valueAt(b.forces().area().center().y()),
                     0.5));
    }

    // A second recording is not shifted by the time between the two clicks.
    void recordingsOpenedOneAfterTheOtherBeginTogether() {
        Bench b;
        QTemporaryDir folder;
        b.dock.openRecording(writeDay(folder, QStringLiteral("one.csv")));
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.store().recordings().size(), 1, 60'000);
        b.runTo(75);
        b.dock.openRecording(writeDay(folder, QStringLiteral("two.csv")));
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.store().recordings().size(), 2, 60'000);
        QCOMPARE(b.dock.store().timesOf(QStringLiteral("two.csv"))->firstTime(),
                 b.dock.store().timesOf(QStringLiteral("one.csv"))->firstTime());
    }

    // The menu belongs to the curve under the pointer, even if another signal is shown at the cursors.
    void theMenuOfACurveIsForThisCurve() {
        Bench b;
        b.view().setReadoutSignal(b.id("actual_TCP_force_0"));
        const int force = b.id("actual_TCP_force_2");
        const PlotPane& pane = b.forces();
        const double time = b.view().timeAt(pane.area().center().x());
        const double value = b.dock.store().valueAt(force, time).value();
        QCOMPARE(pane.curveAt(QPointF(pane.area().center().x(), pane.yAt(value) + 3)),
                 std::optional<int>(force));
        b.menuAt(QPointF(pane.area().center().x(), pane.yAt(value)), "plots.menu.alarmAbove");
        QCOMPARE(b.dock.marks().thresholds().size(), 1);
        QCOMPARE(b.dock.marks().thresholds()[0].key, QStringLiteral("actual_TCP_force_2"));
        QVERIFY(near(b.dock.marks().thresholds()[0].limit, value, 1));
        // From the legend, the newest value is proposed.
        b.menuAt(pane.legendEntry(force).center(), "plots.menu.alarmAbove");
        QCOMPARE(b.dock.marks().thresholds().size(), 2);
        QVERIFY(near(b.dock.marks().thresholds()[1].limit,
                     b.dock.store().valueAt(force, b.view().window().end()).value(), 1));
    }

    // ---- derived signals
    void theMenuDerivesSignals() {
        Bench b;
        b.menuAt(b.forces().area().center(), "plots.menu.norm");
        QCOMPARE(b.forces().shown().size(), std::size_t{4});
        const int norm = b.forces().shown().back();
        QVERIFY(near(b.dock.store().valueAt(norm, 50).value(), 50, 1e-3));  // also for past samples
        b.view().setReadoutSignal(b.id("actual_TCP_force_2"));
        b.menuAt(b.forces().area().center(), "plots.menu.derivative");
        QCOMPARE(b.view().panes().size(), std::size_t{3});
        const int slope = b.view().panes()[1]->shown().front();
        QVERIFY(near(b.dock.store().valueAt(slope, 50).value(), 1, 1e-2));
        b.runTo(62);
        QVERIFY(near(b.dock.store().valueAt(slope, 61.5).value(), 1, 1e-2));
        QVERIFY(near(b.dock.store().valueAt(norm, 61.5).value(), 61.5, 1e-3));
        // The signal is saved with the layout.
        LiveHistory anotherLive(b.session);
        PlotDock another(b.session, anotherLive);
        another.arrange(b.dock.arrangement());
        QCOMPARE(another.arrangement(), b.dock.arrangement());
    }

    void anExpressionIsTypedUnderTheList() {
        Bench b;
        b.dock.setSignalsShown(true);
        auto* line = b.dock.findChild<QLineEdit*>("signals.derivation");
        auto* problem = b.dock.findChild<QLabel*>("signals.derivation.problem");
        line->setFocus();
        QTest::keyClicks(line, "Twice [N] = 2 * actual_TCP_force_9");
        QTest::keyClick(line, Qt::Key_Return);
        QVERIFY(problem->isVisible() && problem->text().contains("actual_TCP_force_9"));
        QTest::keyClick(line, Qt::Key_Backspace);
        QVERIFY(!problem->isVisible());
        QTest::keyClicks(line, "2");
        QTest::keyClick(line, Qt::Key_Return);
        QVERIFY(!problem->isVisible() && line->text().isEmpty());
        const int twice = b.forces().shown().back();
        QCOMPARE(b.dock.store().info(twice).longLabel, QString("Twice"));
        QVERIFY(near(b.dock.store().valueAt(twice, 50).value(), 100, 1e-3));
        b.list("twice");
        QVERIFY(b.rowOf("Twice [N]").isValid());
    }

    // ---- recordings
    // 10 Hz, without a robot: all rows, and the rows between the cursors, with the values in the file.
    void exportsTheRowsOfARecording() {
        QTemporaryDir folder;
        const QString path = folder.filePath("slow.csv");
        QList<QByteArray> rows;
        {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            for (int i = 0; i < 600; ++i) {
                rows << QByteArray::number(5000 + i * 0.1, 'f', 1) + ',' + QByteArray::number(i * 0.25);
            }
            file.write("timestamp,actual_TCP_force_2\n" + rows.join('\n') + '\n');
        }
        RobotSession session;
        LiveHistory dockLive(session);
        PlotDock dock(session, dockLive);
        session.shutDown();
        dock.resize(1500, 375);
        dock.show();
        dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(dock.pages().count(), 2, 60'000);
        const auto linesOf = [](const QString& name) {
            QFile file(name);
            return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().split('\n')
                                                  : QList<QByteArray>();
        };
        const auto valuesOf = [](const QByteArray& line) {
            return std::pair(line.split(',').value(0).toDouble(), line.split(',').value(1).toDouble());
        };
        QVERIFY(dock.exportTo(folder.filePath("all.csv")));
        const QList<QByteArray> all = linesOf(folder.filePath("all.csv"));
        QCOMPARE(all.size(), 601);
        QCOMPARE(all[0], QByteArray("timestamp,actual_TCP_force_2"));
        for (int i = 0; i < 600; ++i) {
            QCOMPARE(valuesOf(all[i + 1]), valuesOf(rows[i]));
        }
        const SeriesBuffer& times = *dock.store().timesOf("slow.csv");
        dock.view().setCursor(PlotView::Cursor::A, times.time(200));
        dock.view().setCursor(PlotView::Cursor::B, times.time(100));
        QVERIFY(dock.exportTo(folder.filePath("part.csv"), PlotDock::ExportRange::BetweenCursors));
        const QList<QByteArray> part = linesOf(folder.filePath("part.csv"));
        QCOMPARE(part.size(), 102);
        QCOMPARE(valuesOf(part[1]), valuesOf(rows[100]));
        QCOMPARE(valuesOf(part.last()), valuesOf(rows[200]));
        QVERIFY(dock.exportTo(folder.filePath("all.h5")));
        QVERIFY(dock.exportTo(folder.filePath("all.mcap")));
        QVERIFY(dock.exportTo(folder.filePath("all.png")));
    }

    // Notes of the file, and notes added in the window.
    void exportsTheNotesOfTheRange_data() {
        QTest::addColumn<QString>("suffix");
        QTest::newRow("CSV") << QStringLiteral("csv");
        QTest::newRow("MCAP") << QStringLiteral("mcap");
        QTest::newRow("HDF5") << QStringLiteral("h5");
    }
    void exportsTheNotesOfTheRange() {
        QFETCH(QString, suffix);
        const QTemporaryDir folder;
        Bench b;
        const QString path = writeDay(folder, QStringLiteral("day.csv"));
        QFile notes(folder.filePath("day.notes.csv"));
        QVERIFY(notes.open(QIODevice::WriteOnly));
        notes.write(
            "row,utc,level,source,text\n1000,,20,note,early\n3000,,20,note,\"in the file, \"\"A\"\"\"\n"
            "4500,,30,robot,warning\n5500,,20,trigger,Trigger: x > 1 (2)\n9000,,20,note,late\n");
        notes.close();
        b.dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        const double begin = b.dock.store().timesOf(QStringLiteral("day.csv"))->firstTime();
        const auto& marks = b.dock.marks().marks();
        const auto cause = std::find_if(marks.begin(), marks.end(),
                                        [](const PlotMark& mark) { return mark.text.startsWith("Trigger"); });
        QVERIFY(cause != marks.end() && near(cause->time, begin + 55, 0.02));
        b.dock.addNote(begin + 40, QStringLiteral("in the window ü"));
        b.dock.addNote(begin + 70, QStringLiteral("afterwards"));
        b.view().setCursor(PlotView::Cursor::A, begin + 20);
        b.view().setCursor(PlotView::Cursor::B, begin + 50);
        const auto notesIn = [&](const char* name, PlotDock::ExportRange range) {
            const QString file = folder.filePath(QLatin1String(name) + '.' + suffix);
            if (!b.dock.exportTo(file, range)) {
                return QStringLiteral("not exported");
            }
            const auto back = recording::openRecording(file);
            QStringList found(back ? (*back)->problems() : QStringList("not readable"));
            for (const recording::RecordedEvent& event :
                 back ? (*back)->events() : std::vector<recording::RecordedEvent>()) {
                found << QStringLiteral("%1 %2 %3 %4")
                             .arg(std::lround(event.seconds))
                             .arg(event.level)
                             .arg(event.source, event.text);
            }
            return found.join(QStringLiteral(" | "));
        };
        QCOMPARE(notesIn("part", PlotDock::ExportRange::BetweenCursors),
                 QString("10 20 note in the file, \"A\" | 20 20 note in the window ü | 25 30 robot warning"));
        QCOMPARE(notesIn("all", PlotDock::ExportRange::Visible),
                 QString("10 20 note early | 30 20 note in the file, \"A\" | 40 20 note in the window ü | "
                         "45 30 robot warning | 55 20 trigger Trigger: x > 1 (2) | "
                         "70 20 note afterwards | 90 20 note late"));
    }

    void exportsTheNotesOfLiveData() {
        const QTemporaryDir folder;
        Bench b;
        const QString path = folder.filePath("live.csv");
        b.dock.addNote(20, QStringLiteral("before"));
        b.dock.addNote(45, QStringLiteral("slipped"));
        b.view().setCursor(PlotView::Cursor::A, 40.0);
        b.view().setCursor(PlotView::Cursor::B, 50.0);
        QVERIFY(b.dock.exportTo(path, PlotDock::ExportRange::BetweenCursors));
        const auto back = recording::openRecording(path).value();
        QCOMPARE(back->events().size(), std::size_t(1));
        QCOMPARE(back->events()[0].text, QString("slipped"));
        QCOMPARE(back->events()[0].source, QString(recording::kNoteSource));
        QVERIFY(near(back->events()[0].seconds, 5, 0.003));
        // If the range contains no notes, the notes of an earlier export to the same file are removed.
        b.view().setCursor(PlotView::Cursor::A, 46.0);
        QVERIFY(b.dock.exportTo(path, PlotDock::ExportRange::BetweenCursors));
        QVERIFY(recording::openRecording(path).value()->events().empty());
    }

    void recordingsInOnePlotAreDistinguishable() {
        Bench b;
        QTemporaryDir folder;
        for (const char* name : {"a.csv", "b.csv"}) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("timestamp,actual_TCP_force_2\n1,1\n2,2\n3,3\n");
            file.close();
            const int pages = b.dock.pages().count();
            b.dock.openRecording(file.fileName());
            QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), pages + 1, 60'000);
        }
        const SignalStore& store = b.dock.store();
        const auto pens = [&](const std::vector<int>& shown) {
            return curvePens(store, shown, Theme::current());
        };
        const std::vector<int> both{store.find("a.csv/actual_TCP_force_2"),
                                    store.find("b.csv/actual_TCP_force_2")};
        QVERIFY(pens(both)[0].color() != pens(both)[1].color());
        QVERIFY(curveLabel(store, both, both[0]).contains("a.csv"));
        QVERIFY(curveLabel(store, both, both[1]).contains("b.csv"));
        QCOMPARE(curveLabel(store, {both[0]}, both[0]), store.info(both[0]).label);
        // Earlier curves keep their pens when curves are added, and all pens differ.
        std::vector<int> shown;
        std::vector<QPen> before;
        for (const char* key : {"actual_TCP_force_2", "a.csv/actual_TCP_force_2", "actual_current_0",
                                "b.csv/actual_TCP_force_2", "actual_TCP_force_0", "actual_current_1",
                                "actual_TCP_force_1", "actual_current_2"}) {
            shown.push_back(store.find(key));
            const std::vector<QPen> now = pens(shown);
            QVERIFY(std::equal(before.begin(), before.end(), now.begin()));
            for (std::size_t i = 0; i + 1 < now.size(); ++i) {
                QVERIFY2(now[i].color() != now.back().color() || now[i].style() != now.back().style() ||
                             now[i].dashPattern() != now.back().dashPattern(),
                         key);
            }
            before = now;
        }
    }

    void recordingIsOpenedNextToLiveData() {
        Bench b;
        QTemporaryDir folder;
        const QString path = folder.filePath("yesterday.csv");
        {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("timestamp,actual_TCP_force_2,actual_digital_input_bits,mine,packages_lost\n");
            for (int i = 0; i < 5000; ++i) {
                const double time = 700 + i * 0.002 + (i >= 4000 ? 2 : 0);
                file.write(QByteArray::number(time, 'f', 4) + ',' + QByteArray::number(i * 0.01) + ',' +
                           (i < 2500 ? "0" : "8") + ",7," + (i == 4000 ? "1000" : "0") + '\n');
            }
        }
        QFile notes(folder.filePath("yesterday.notes.csv"));
        QVERIFY(notes.open(QIODevice::WriteOnly));
        notes.write("row,utc,level,source,text\n1000,,20,note,jammed\n1500,,30,robot,not a note\n");
        notes.close();
        const test::EventSpy messages(b.session.journal());
        b.dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        QCOMPARE(b.dock.marks().marks().size(), std::size_t(1));
        const PlotMark& mark = b.dock.marks().marks().front();
        QCOMPARE(mark.text, QString("jammed"));
        QCOMPARE(mark.recording, QString("yesterday.csv"));
        QVERIFY(near(mark.time, b.dock.history().lastTime() - 11.998 + 2, 0.01));
        QVERIFY2(messages.last().text.contains("yesterday.csv"), qPrintable(messages.last().text));
        SignalStore& store = b.dock.store();
        const int force = store.find("yesterday.csv/actual_TCP_force_2");
        QVERIFY(force >= 0 && b.view().panes()[0]->shows(force));
        QCOMPARE(store.info(force).longLabel, QString("Fz"));
        // The recording ends at the end of the history and is displayed completely.
        const double end = b.dock.history().lastTime();
        QVERIFY(near(b.view().window().end(), end, 0.01));
        QVERIFY(near(b.view().window().span(), 11.998, 0.01));
        QVERIFY(near(store.valueAt(force, end).value(), 49.99, 1e-3));
        QVERIFY2(!store.valueAt(force, end - 3).has_value(), "there is a value inside the gap");
        QVERIFY(!b.curve(force).range().isEmpty());
        // Live data are displayed next to the recording on the same axes, and bits of the recording as lanes.
        b.drop(b.view().panes()[0]->area().center(),
               {"actual_TCP_force_2", "yesterday.csv/actual_digital_input_bits.3", "yesterday.csv/mine"});
        QVERIFY(b.view().panes()[0]->shows(b.id("actual_TCP_force_2")));
        QVERIFY(b.view().panes()[0]->shows(store.find("yesterday.csv/mine")));
        const LaneItem* lane = b.view().signalLane(store.find("yesterday.csv/actual_digital_input_bits.3"));
        QVERIFY(lane != nullptr && lane->segments().size() >= 2);
        QVERIFY(store.extraFields().isEmpty());
        b.dock.setSignalsShown(true);
        b.list("yesterday");
        QVERIFY(b.rowOf("yesterday.csv").isValid());
        // The same file is opened again, starting at cursor A.
        b.view().setCursor(PlotView::Cursor::A, 50.0);
        b.dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 3, 60'000);
        QVERIFY(near(store.valueAt(store.find("yesterday.csv (2)/actual_TCP_force_2"), 51).value(), 5, 0.02));
        // Closing the recordings keeps the live signals, and data continue to arrive.
        b.dock.closeRecordings();
        QVERIFY(b.dock.marks().marks().empty());
        QCOMPARE(b.dock.pages().count(), 2);  // without the page that showed only the second recording
        QCOMPARE(store.find("yesterday.csv/actual_TCP_force_2"), -1);
        b.dock.pages().setCurrent(1);
        QVERIFY(b.view().panes()[0]->shows(b.id("actual_TCP_force_2")));
        b.view().follow();
        b.runTo(61);
        QVERIFY(near(b.view().window().end(), 61, 0.003));
    }

    void standardPlotsKeepThePagesOfRecordings() {
        Bench b;
        QTemporaryDir folder;
        b.dock.pages().addPage(PageLayout::standard());
        b.dock.openRecording(writeDay(folder, QStringLiteral("day.csv")));
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 3, 60'000);
        b.view().setCursor(PlotView::Cursor::A, b.view().window().start() + 5);
        b.runTo(61);
        auto* menu = b.button("plots.layout")->menu();
        Q_EMIT menu->aboutToShow();
        menu->findChild<QAction*>("plots.layout.standard", Qt::FindDirectChildrenOnly)->trigger();
        QCOMPARE(b.dock.pages().count(), 2);  // one live page and the recording
        QCOMPARE(b.dock.store().recordings().size(), 1);
        QVERIFY(b.dock.pages().pageOf(b.dock.store().recordings().front()) >= 0);
        QCOMPARE(b.view().recordingInFront(), QString());
        QVERIFY2(b.view().window().follows(), "not paused at the time of the recording");
        QVERIFY(b.view().panes()[0]->shows(b.id("actual_TCP_force_2")));
        b.runTo(62);
        QVERIFY(near(b.view().window().end(), 62, 0.003));
        QCOMPARE(b.view().window().span(), 30.0);
    }

    void largeNumbersFitLeftOfThePlot() {
        Bench b;
        const auto isClear = [&b] {
            const QImage image = b.view().grab().toImage();
            for (int y = 0; y < image.height(); ++y) {
                if (image.pixel(1, y) != image.pixel(0, 0) || image.pixel(2, y) != image.pixel(0, 0)) {
                    return false;
                }
            }
            return true;
        };
        QVERIFY(isClear());
        for (const auto& [low, high] :
             {std::pair{-12'345'678.0, 12'345'678.0}, {1'000'000.0, 1'000'200.0}, {-12.0, 12.0}}) {
            b.forces().holdValues(low, high);
            QVERIFY2(isClear(), qPrintable(QString::number(high)));
        }
    }

    // The page keeps its range, its curves and its time labels, while live data arrive.
    void liveDataDoNotExtendAPageOfARecording_data() {
        QTest::addColumn<int>("key");
        QTest::newRow("as opened") << 0;
        QTest::newRow("all data") << static_cast<int>(Qt::Key_F);
        QTest::newRow("at the end") << static_cast<int>(Qt::Key_End);
    }
    void liveDataDoNotExtendAPageOfARecording() {
        QFETCH(int, key);
        Bench b;
        const QTemporaryDir folder;
        const QString name = QStringLiteral("day.csv");
        // The recording continues after the live data, at 50 s ... 150 s.
        b.view().setCursor(PlotView::Cursor::A, 50.0);
        b.dock.openRecording(writeDay(folder, name));
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        b.dock.setTimeAxis(TimeAxis::Controller);
        if (key != 0) {
            b.view().setFocus();
            QTest::keyClick(&b.view(), static_cast<Qt::Key>(key));
        }
        const double start = b.view().window().start();
        const double end = b.view().window().end();
        const QStringList labels = b.view().timeLabels();
        QCOMPARE(end, b.dock.store().timesOf(name)->lastTime());
        QVERIFY2(labels.contains(QLatin1String("750 s")), qPrintable(labels.join('|')));
        const auto unchanged = [&](const char* when) {
            const TimeWindow& window = b.view().window();
            if (window.start() == start && window.end() == end && b.view().timeLabels() == labels) {
                return QString();
            }
            return QStringLiteral("%1: %2 ... %3 instead of %4 ... %5, %6")
                .arg(QLatin1String(when))
                .arg(window.start())
                .arg(window.end())
                .arg(start)
                .arg(end)
                .arg(b.view().timeLabels().join('|'));
        };
        b.runTo(65);
        QCOMPARE(unchanged("data"), QString());
        Q_EMIT b.session.linkBegan();
        b.runTo(70);
        QCOMPARE(unchanged("connected"), QString());
        b.restartedAt = b.next;
        b.runTo(80);
        QCOMPARE(unchanged("controller restarted"), QString());
        SessionState lost = running(80, false);
        lost.link = LinkState::Lost;
        lost.sequence = 1;
        lost.quality.ageMs = 200e3;
        Q_EMIT b.session.stateChanged(lost);
        QCOMPARE(unchanged("no data"), QString());
        b.view().setSpan(b.view().window().span());
        b.runTo(300);
        QCOMPARE(unchanged("later data"), QString());
        // The page cannot be scrolled beyond the end of the recording, even after the live page was shown.
        b.view().scrollBy(1e3);
        QCOMPARE(b.view().window().end(), end);
        b.dock.pages().setCurrent(0);
        b.view().follow();
        QVERIFY(b.view().window().end() > 290);
        b.dock.pages().setCurrent(1);
        QCOMPARE(b.view().window().end(), end);
        for (const auto& pane : b.view().panes()) {
            for (const auto& curve : pane->curves()) {
                const ColumnGrid& grid = b.view().gridOf(*b.dock.store().timesOf(name));
                for (std::size_t i = 0; i < curve->columns().size(); ++i) {
                    QVERIFY(curve->columns()[i].isEmpty() ||
                            grid.start + static_cast<double>(i) * grid.width <= end);
                }
            }
        }
        // With a live signal on the page, its range includes the live data.
        b.view().addSignals({QStringLiteral("actual_TCP_force_2")});
        b.view().follow();
        QVERIFY(b.view().window().end() > 290);
    }

    void aTableWithoutAClearTimeIsOpenedWithTheChosenFormat() {
        Bench b;
        QTemporaryDir folder;
        const QString path = folder.filePath("lab.csv");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("stamp,b\n");
        for (int i = 0; i < 100; ++i) {
            file.write(QByteArray::number(10 * i) + ',' + QByteArray::number(i) + '\n');
        }
        file.close();
        const auto dialog = [&] { return b.dock.findChild<QDialog*>("plots.table.dialog"); };
        const auto open = [&] {
            QTest::mouseClick(dialog()->findChild<QPushButton*>("plots.table.open"), Qt::LeftButton);
        };
        b.dock.openRecording(path);
        QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr, 60'000);
        QVERIFY(
            dialog()->findChild<QPlainTextEdit*>("plots.table.preview")->toPlainText().startsWith("stamp,b"));
        // The unit is still unknown, so the dialog opens again.
        dialog()->findChild<QComboBox*>("plots.table.time")->setCurrentText("stamp");
        QPointer<QDialog> first = dialog();
        open();
        QTRY_VERIFY_WITH_TIMEOUT(first.isNull() && dialog() != nullptr, 60'000);
        QCOMPARE(dialog()->findChild<QComboBox*>("plots.table.time")->currentText(), QString("stamp"));
        auto* unit = dialog()->findChild<QComboBox*>("plots.table.unit");
        unit->setCurrentIndex(unit->findText("ms"));
        open();
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        QVERIFY(near(
            b.dock.store().timesOf("lab.csv")->lastTime() - b.dock.store().timesOf("lab.csv")->firstTime(),
            0.99, 1e-6));
        // For a table with the same header, also in another window, the dialog contains the same choice.
        const QByteArray arrangement = b.dock.arrangement();
        Bench other;
        other.dock.arrange(arrangement);
        const QString next = folder.filePath("next.csv");
        QVERIFY(file.copy(next));
        other.dock.openRecording(next);
        const auto again = [&] { return other.dock.findChild<QDialog*>("plots.table.dialog"); };
        QTRY_VERIFY_WITH_TIMEOUT(again() != nullptr, 60'000);
        QCOMPARE(again()->findChild<QComboBox*>("plots.table.time")->currentText(), QString("stamp"));
        QCOMPARE(again()->findChild<QComboBox*>("plots.table.unit")->currentText(), QString("ms"));
        QPointer<QDialog> second = again();
        QTest::mouseClick(again()->findChild<QPushButton*>("plots.table.open"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(second.isNull() && other.dock.store().timesOf("next.csv") != nullptr,
                                 60'000);
        // The choice is stored by header. The key of a table without a header is empty.
        QVERIFY(OpenTableDialog::headerOf(next) == "stamp,b");
        QFile numbers(folder.filePath("numbers.csv"));
        QVERIFY(numbers.open(QIODevice::WriteOnly) && numbers.write("# a note\n1,2\n3,4\n") > 0);
        numbers.close();
        QCOMPARE(OpenTableDialog::headerOf(numbers.fileName()), QString());
    }

    void aTableWithoutAHeaderOffersItsColumnsByNumber() {
        Bench b;
        QTemporaryDir folder;
        const QString path = folder.filePath("bare.csv");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        for (int i = 0; i < 100; ++i) {
            file.write(QByteArray::number(10 * i) + ',' + QByteArray::number(i) + ",5\n");
        }
        file.close();
        const auto dialog = [&] { return b.dock.findChild<QDialog*>("plots.table.dialog"); };
        const auto box = [&](const char* name) {
            return dialog()->findChild<QComboBox*>(QStringLiteral("plots.table.") + QLatin1String(name));
        };
        const auto names = [&] {
            QStringList all;
            for (int i = 1; i < box("time")->count(); ++i) {
                all << box("time")->itemText(i);
            }
            return all;
        };
        const auto open = [&] {
            QTest::mouseClick(dialog()->findChild<QPushButton*>("plots.table.open"), Qt::LeftButton);
        };
        const QStringList numbered{"column 1", "column 2", "column 3"};
        b.dock.openRecording(path);
        QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr, 60'000);
        QCOMPARE(names(), numbered);
        // The names follow the choice, and the selected column is kept.
        box("time")->setCurrentIndex(1);
        box("header")->setCurrentIndex(box("header")->findData(1));
        QCOMPARE(names(), QStringList({"0", "0", "5"}));
        QCOMPARE(box("time")->currentIndex(), 1);
        box("header")->setCurrentIndex(box("header")->findData(0));
        QCOMPARE(names(), numbered);
        QCOMPARE(box("time")->currentText(), QStringLiteral("column 1"));
        // The unit is unknown. The dialog opens again with the reason.
        QPointer<QDialog> first = dialog();
        open();
        QTRY_VERIFY_WITH_TIMEOUT(first.isNull() && dialog() != nullptr, 60'000);
        const QString reason = dialog()->findChild<QLabel*>("plots.table.reason")->text();
        QVERIFY2(reason.contains("unit") && !reason.contains("--"), qPrintable(reason));
        QCOMPARE(box("time")->currentText(), QStringLiteral("column 1"));
        box("unit")->setCurrentIndex(box("unit")->findText("ms"));
        open();
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        // The time column is not a curve.
        QStringList shown;
        for (const int signal : b.dock.pages().view().panes().front()->shown()) {
            shown << b.dock.store().info(signal).field;
        }
        QCOMPARE(shown, QStringList({"column 2", "column 3"}));
    }

    void aRecordingIsComparedWithTheModelOfItsArm() {
        Bench b;
        QTemporaryDir folder;
        const QString path = folder.filePath("stiff.csv");
        {
            // An arm at standstill. After a second, its elbow deviates by one degree.
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("timestamp");
            for (const char* field : {"target_q", "actual_q"}) {
                for (int joint = 0; joint < 6; ++joint) {
                    file.write(QByteArray(",") + field + '_' + QByteArray::number(joint));
                }
            }
            for (int i = 0; i < 1000; ++i) {
                file.write('\n' + QByteArray::number(700 + i * 0.002, 'f', 4) + ",0,-1.5,1.5,-1,1,0,0,-1.5," +
                           (i < 500 ? "1.5" : "1.517453") + ",-1,1,0");
            }
        }
        b.dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        auto* band = b.dock.findChild<ComparisonBand*>();
        auto* key = b.dock.findChild<QToolButton*>("plots.comparison.key");
        auto* compare = b.dock.findChild<QToolButton*>("plots.comparison.compare");
        QVERIFY(band->isHidden());
        // Input for the dialog. A comparison requires the model of the arm.
        int asked = 0;
        const auto answer = [&](double limit, const char* model) {
            QTimer::singleShot(0, &b.dock, [&asked, limit, model] {
                auto* dialog = qobject_cast<ComparisonDialog*>(QApplication::activeModalWidget());
                if (dialog == nullptr) {
                    return;
                }
                auto* accept = dialog->findChild<QPushButton*>("plots.comparison.accept");
                auto* models = dialog->findChild<QComboBox*>("plots.comparison.model");
                asked += accept->isEnabled() == (models->currentIndex() >= 0) ? 1 : 0;
                models->setCurrentIndex(models->findText(model));
                dialog->findChild<QDoubleSpinBox*>("plots.comparison.joint")->setValue(limit);
                accept->click();
            });
        };
        QMenu* menu = b.dock.findChild<QMenu*>("plots.layout.menu");
        Q_EMIT menu->aboutToShow();
        auto* action = menu->findChild<QAction*>("plots.layout.compare");
        QVERIFY(action->isEnabled());
        answer(2, "UR5e");
        action->trigger();
        QCOMPARE(asked, 1);
        // Without the payload, the currents cannot be compared, and another arm would match as well.
        QTRY_COMPARE_WITH_TIMEOUT(
            band->words(),
            QString(
                "No deviation from the model of a UR5e, but the recorded values may fit other models too"),
            60'000);
        QVERIFY2(band->details().contains("actual_current"), qPrintable(band->details()));
        QVERIFY(!key->isVisible() && b.dock.marks().marks().empty());

        const test::EventSpy parted(b.session.journal(), JournalEvent::Kind::Recording);
        answer(0.5, "UR5e");
        QTest::mouseClick(compare, Qt::LeftButton);
        QCOMPARE(asked, 2);
        QTRY_COMPARE_WITH_TIMEOUT(
            band->words(), QString("Arm and model diverge at 1.000 s: Elbow deviates by 1.00°"), 60'000);
        QCOMPARE(parted.count(), 1);
        QCOMPARE(parted.front().recording, path);
        QVERIFY(near(parted.front().moment.value(), 1, 1e-6));
        QCOMPARE(b.dock.marks().marks().size(), std::size_t(1));
        const double begin = b.dock.store().timesOf("stiff.csv")->firstTime();
        QVERIFY(near(b.dock.marks().marks()[0].time, begin + 1, 1e-6));
        QTest::mouseClick(key, Qt::LeftButton);
        QVERIFY(near(*b.view().cursor(PlotView::Cursor::A), begin + 1, 1e-6));
        const PlotLayout kept = PlotLayout::fromJson(b.dock.arrangement()).value();
        QVERIFY(near(kept.modelLimits.jointPosition, 0.5 * 3.14159265 / 180, 1e-6));

        // After cancelling, no result is shown, not even the previous result.
        answer(0.5, "UR5e");
        QTest::mouseClick(compare, Qt::LeftButton);
        QVERIFY(b.dock.marks().marks().empty());
        QVERIFY(key->isVisible());
        QCOMPARE(key->text(), QString("Cancel"));
        QTest::mouseClick(key, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(band->words(), QString("Not compared with the arm model."), 60'000);
        QCOMPARE(parted.count(), 1);

        // The result belongs only to this page.
        b.dock.pages().setCurrent(0);
        QVERIFY(band->isHidden());
        b.dock.pages().setCurrent(1);
        QVERIFY(band->isVisible());
        b.dock.closeRecordings();
        QVERIFY(band->isHidden());
    }

    void aRecordingIsShownWithoutARobot() {
        RobotSession session;
        session.shutDown();
        LiveHistory dockLive(session);
        PlotDock dock(session, dockLive);
        dock.resize(1200, 400);
        dock.show();
        QTemporaryDir folder;
        QFile file(folder.filePath("other;tool.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("time [s];pressure\n0;1\n1;4\n2;2\n");
        file.close();
        dock.openRecording(file.fileName());
        QTRY_COMPARE_WITH_TIMEOUT(dock.pages().count(), 2, 60'000);
        const int pressure = dock.store().find("other;tool.csv/pressure");
        QVERIFY(dock.view().panes()[0]->shows(pressure));
        QCOMPARE(dock.store().valueAt(pressure, 1.5).value(), 4.0);
        QCOMPARE(dock.view().window().start(), 0.0);
        QVERIFY(dock.view().panes()[0]->curves()[0]->range() == (MinMax{1, 4}));
        // The page is not saved for the next start, because an empty page named after a file is useless.
        LiveHistory nextLive(session);
        PlotDock next(session, nextLive);
        next.arrange(dock.arrangement());
        QCOMPARE(next.pages().count(), 1);
        QVERIFY(next.view().panes()[0]->shows(next.store().find("actual_TCP_force_2")));
        QVERIFY(!next.grab().isNull());
    }

    void damageOfARecordingIsReportedAndDrawnAsAGap() {
        Bench b;
        QTemporaryDir folder;
        const QString path = folder.filePath("damaged.mcap");
        std::string bytes = test::madeFile(*recording::mcapFormat({.compression = 0}), 6000);
        QVERIFY(test::writeFile(path, bytes));
        const auto reader = recording::mcap::Reader::open(path).value();
        // The first chunk contains rows. Other chunks contain the log and the summaries.
        std::vector<recording::mcap::ChunkIndex> chunks = reader->chunks();
        const std::uint16_t rows = chunks.front().messageIndexes.front().first;
        std::erase_if(chunks, [&](const auto& chunk) { return reader->messagesIn(chunk, rows) == 0; });
        QVERIFY(chunks.size() > 2);
        bytes[static_cast<std::size_t>(chunks[1].offset + 1000)] ^= 1;
        QVERIFY(test::writeFile(path, bytes));
        const test::EventSpy messages(b.session.journal());
        b.dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        b.runTo(61);
        const auto reportCount = [&] {
            return std::count_if(messages.begin(), messages.end(), [](const auto& message) {
                return message.severity == Severity::Warning && message.text.contains("damaged.mcap") &&
                       message.text.contains("checksum") && message.text.contains("row");
            });
        };
        QVERIFY2(reportCount() == 1, qPrintable(messages.last().text));
        const int empty = emptyColumnsWithin(b.curve(b.id("damaged.mcap/actual_TCP_force_2")));
        QVERIFY2(empty > 20, qPrintable(QString::number(empty)));
        b.view().fit();
        b.runTo(62);
        QCOMPARE(reportCount(), 1);
    }

    void anIncompleteRecordingIsReportedWithTheReason() {
        Bench b;
        QTemporaryDir folder;
        const QString path = folder.filePath("half.mcap");
        const std::string bytes = test::madeFile(*recording::mcapFormat({.compression = 0}), 6000);
        QVERIFY(test::writeFile(path, bytes.substr(0, bytes.size() / 2)));
        const test::EventSpy messages(b.session.journal());
        b.dock.openRecording(path);
        QTRY_COMPARE_WITH_TIMEOUT(messages.count(), 1, 60'000);
        QVERIFY(messages.last().severity == Severity::Warning);
        QVERIFY2(messages.last().text.contains("ends in the middle"), qPrintable(messages.last().text));
    }

    /// The rows of a long recording are read when they are shown.
    void damageFoundLaterIsReportedOnce() {
        Bench b;
        const test::Long made(100'000);
        QFile file(made.path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray bytes = file.readAll();
        file.close();
        constexpr double kDamaged = 60;  // [s]
        {
            const auto reader = recording::mcap::Reader::open(made.path).value();
            const auto& chunks = reader->chunks();
            const auto secondsOf = [&](const auto& chunk) {
                return static_cast<double>(chunk.startTime - chunks.front().startTime) * 1e-9;
            };
            const auto chunk = std::find_if(chunks.begin(), chunks.end(), [&](const auto& each) {
                return secondsOf(each) >= kDamaged && each.length > 1000;
            });
            QVERIFY(chunk != chunks.end() && secondsOf(*chunk) < kDamaged + 2);
            const auto at = static_cast<qsizetype>(chunk->offset + chunk->length / 2);
            bytes[at] = static_cast<char>(bytes[at] ^ 1);
        }
        QVERIFY(test::writeFile(made.path, bytes.toStdString()));
        const test::EventSpy messages(b.session.journal());
        b.dock.openRecording(made.path);
        QTRY_COMPARE_WITH_TIMEOUT(b.dock.pages().count(), 2, 60'000);
        QTRY_COMPARE_WITH_TIMEOUT(messages.count(), 1, 60'000);
        QVERIFY2(messages.last().text.contains("Opened"), qPrintable(messages.last().text));
        const double begin = b.dock.store().timesOf("long.mcap")->firstTime();
        b.view().showRange(begin + kDamaged - 2, begin + kDamaged + 4);
        b.view().showSharp();
        b.runTo(61);
        QCOMPARE(messages.count(), 2);
        QVERIFY(messages.last().severity == Severity::Warning);
        QVERIFY2(messages.last().text.contains("row") && messages.last().text.contains("long.mcap"),
                 qPrintable(messages.last().text));
        QVERIFY(emptyColumnsWithin(b.curve(b.id("long.mcap/actual_TCP_force_2"))) > 20);
        b.view().showRange(begin + kDamaged - 1, begin + kDamaged + 3);
        b.view().showSharp();
        b.runTo(62);
        QCOMPARE(messages.count(), 2);
    }

    void invalidRecordingIsReportedWithoutChanges() {
        Bench b;
        QTemporaryDir folder;
        const test::EventSpy messages(b.session.journal());
        b.dock.openRecording(folder.filePath("none.mcap"));
        QTRY_COMPARE_WITH_TIMEOUT(messages.count(), 1, 60'000);
        QFile file(folder.filePath("picture.mcap"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(3000, '\x89'));
        file.close();
        b.dock.openRecording(file.fileName());
        QTRY_COMPARE_WITH_TIMEOUT(messages.count(), 2, 60'000);
        for (const auto& message : messages) {
            QVERIFY(message.severity == Severity::Error);
        }
        QCOMPARE(b.dock.pages().count(), 1);
    }

    void picturesAreCopiedToTheClipboard() {
        Bench b;
        QApplication::clipboard()->clear();
        auto* menu = b.button("plots.layout")->menu();
        Q_EMIT menu->aboutToShow();
        menu->findChild<QAction*>("plots.layout.copy", Qt::FindDirectChildrenOnly)->trigger();
        QVERIFY(QApplication::clipboard()->image().width() > 500);
    }

    // ---- the same mouse actions and keys as in other parts of the application
    void mouseButtonsPanZoomToARangeAndShowAll() {
        Bench b;
        QWidget* viewport = b.view().viewport();
        QTest::mousePress(viewport, Qt::MiddleButton, {}, b.at(50));
        QTest::mouseMove(viewport, b.at(50) + QPoint(200, 0));
        QTest::mouseRelease(viewport, Qt::MiddleButton, {}, b.at(50) + QPoint(200, 0));
        QVERIFY(!b.view().window().follows());
        QVERIFY(b.view().window().end() < 57);
        QVERIFY(!b.view().cursor(PlotView::Cursor::A));

        const QRectF area = b.forces().area();
        const QPoint from(static_cast<int>(area.left()) + 200, static_cast<int>(area.top()) + 20);
        const QPoint to = from + QPoint(300, 60);
        const double t0 = b.view().timeAt(from.x());
        const double t1 = b.view().timeAt(to.x());
        const double high = b.forces().valueAt(from.y());
        QTest::mousePress(viewport, Qt::LeftButton, Qt::ShiftModifier, from);
        QTest::mouseMove(viewport, from + QPoint(50, 20));
        QTest::mouseMove(viewport, to);
        QTest::mouseRelease(viewport, Qt::LeftButton, Qt::ShiftModifier, to);
        QVERIFY(near(b.view().window().start(), t0, 1e-6) && near(b.view().window().end(), t1, 1e-6));
        QVERIFY(b.forces().isZoomed());
        QVERIFY(near(b.forces().range().max(), high, 1e-6));

        QTest::mouseClick(viewport, Qt::LeftButton, {}, from);
        QTest::mouseDClick(viewport, Qt::LeftButton, {}, from);
        QVERIFY(!b.forces().isZoomed());
        QVERIFY(b.view().window().span() > 59.9);
        QVERIFY2(!b.view().cursor(PlotView::Cursor::A), "the first click of a double click placed a cursor");
    }

    void contextMenuHasTheColoursOfTheScheme() {
        applyTheme(*qApp, Theme::dark());
        const auto light = qScopeGuard([] { applyTheme(*qApp, Theme::light()); });
        Bench b;
        QContextMenuEvent event(QContextMenuEvent::Mouse, b.at(50),
                                b.view().viewport()->mapToGlobal(b.at(50)));
        QApplication::sendEvent(b.view().viewport(), &event);
        auto* menu = b.view().findChild<QMenu*>(QStringLiteral("plots.menu"));
        QVERIFY(menu != nullptr);
        const QColor background = menu->grab().toImage().pixelColor(4, 2);
        delete menu;
        QCOMPARE(background.name(), Theme::dark().raised.name());
    }

    void bothThemesDrawWithoutAWarning() {
        Bench b;
        applyTheme(*qApp, Theme::dark());
        QVERIFY(!b.dock.grab().isNull());
        applyTheme(*qApp, Theme::light());
        b.dock.resize(700, 240);
        QVERIFY(!b.dock.grab().isNull());
    }
};

QTEST_MAIN(TestPlotDock)
#include "tst_plot_dock.moc"
