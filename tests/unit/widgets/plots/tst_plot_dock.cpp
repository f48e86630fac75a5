// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plot panel with real mouse, wheel and key events, fed with samples of the test's own.
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QMenu>
#include <QPainter>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/sample_stream.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/theme.h"
#include "widgets/plots/curve_item.h"
#include "widgets/plots/plot_dock.h"
#include "widgets/plots/plot_overlay.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/plot_view.h"
#include "widgets/plots/state_lane.h"
#include "widgets/session/robot_session.h"

using namespace tiller;

namespace {

/// 500 Hz, Fz = time in newtons, so that every read-out can be checked by head.
struct Bench {
    RobotSession session;
    PlotDock dock{session};
    test::SampleStream stream;
    int next = 0;  ///< the sample that comes next

    Bench() {
        session.shutDown();  // frames come when the test says so
        dock.resize(1500, 375);
        dock.show();
        runTo(60);
    }
    /// One frame with everything until then.
    void runTo(double seconds) {
        const int until = static_cast<int>(std::lround(seconds / 0.002)) + 1;
        for (; next < until; ++next) {
            const double time = next * 0.002;
            receive::Sample& sample = stream.add(time, static_cast<std::uint64_t>(next) + 1);
            std::fill(sample.values.begin(), sample.values.end(), 0.0);
            stream.set(sample, "timestamp", time);
            stream.set(sample, "actual_TCP_force_2", time);
            stream.set(sample, "actual_current_0", 1);
        }
        stream.frame([this](const SampleBatch& batch) { Q_EMIT session.samplesReceived(batch); });
        Q_EMIT session.stateChanged(session.state());
    }
    PlotView& view() { return dock.view(); }
    QPoint at(double time) { return {static_cast<int>(std::lround(view().xAt(time))), 100}; }
    void wheel(double time, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const QPointF place = at(time);
        QWheelEvent event(place, view().viewport()->mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(view().viewport(), &event);
    }
    PlotPane& forces() { return *view().panes()[0]; }
    /// A click on a name in a legend.
    void clickLegend(PlotSignal signal, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const auto& panes = view().panes();
        const auto entry = [&] {
            const QRectF upper = panes[0]->legendEntry(signal);
            return upper.isEmpty() ? panes[1]->legendEntry(signal) : upper;
        };
        QTRY_VERIFY(!entry().isEmpty());
        QTest::mouseClick(view().viewport(), Qt::LeftButton, modifiers, entry().center().toPoint());
    }
    CurveItem& curve(PlotSignal signal) {
        for (const auto& pane : view().panes()) {
            for (CurveItem* curve : pane->curves()) {
                if (curve->signal() == static_cast<int>(signal)) {
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

}  // namespace

class TestPlotDock : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void showsTheNewestThirtySecondsAtFirst() {
        Bench b;
        QCOMPARE(b.view().window().span(), 30.0);
        QVERIFY(near(b.view().window().end(), 60, 0.003));
        b.runTo(61);
        QVERIFY(near(b.view().window().end(), 61, 0.003));
    }

    void pauseFreezesTheViewWhileDataGoOn() {
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

    void theWindowIsChosenFromTheMenu() {
        Bench b;
        for (QAction* action : b.button("plots.span")->menu()->actions()) {
            action->trigger();
            QCOMPARE(b.view().window().span(), action->data().toDouble());
            QVERIFY(b.button("plots.span")->text().startsWith(action->text()));
        }
        QCOMPARE(b.button("plots.span")->menu()->actions().size(), 6);
    }

    void draggingGoesBackInHistory() {
        Bench b;
        QWidget* viewport = b.view().viewport();
        const double held = 50;
        QTest::mousePress(viewport, Qt::LeftButton, {}, b.at(held));
        const QPoint to = b.at(held) + QPoint(300, 0);
        QTest::mouseMove(viewport, b.at(held) + QPoint(60, 0));
        QTest::mouseMove(viewport, to);
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, to);
        QVERIFY(!b.view().window().follows());
        QVERIFY2(near(b.view().timeAt(to.x()), held, 0.1),
                 "the moment taken hold of is still under the pointer");
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

    void clicksPlaceTheCursorsAndTheReadoutSaysTheirDifference() {
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
        QVERIFY(b.view().readoutSignal() == PlotSignal::CurrentBase);
        QTest::keyClick(&b.view(), Qt::Key_Up);
        QVERIFY(b.view().readoutSignal() == PlotSignal::ForceZ);
        QTest::keyClick(&b.view(), Qt::Key_PageUp);
        QVERIFY(near(b.view().window().end(), 45, 0.003));
        QTest::keyClick(&b.view(), Qt::Key_End);
        QVERIFY(b.view().window().follows());
    }

    void aClickOnANameInALegendHidesItsCurve() {
        Bench b;
        const double wide = b.forces().range().max();
        b.clickLegend(PlotSignal::ForceZ);
        QVERIFY2(b.view().isHidden(PlotSignal::ForceZ),
                 qPrintable(QDebug::toString(b.forces().legendEntry(PlotSignal::ForceZ))));
        QVERIFY(!b.curve(PlotSignal::ForceZ).isVisible());
        QVERIFY(b.curve(PlotSignal::ForceX).isVisible());
        QVERIFY2(b.forces().range().max() < wide, "the scale is that of the curves that are shown");
        b.clickLegend(PlotSignal::CurrentShoulder);
        QVERIFY(!b.curve(PlotSignal::CurrentShoulder).isVisible());
        QVERIFY(!b.view().cursor(PlotView::Cursor::A));  // no click into the plot
        // New data, another link and other colours change nothing about it.
        b.runTo(61);
        Q_EMIT b.session.linkBegan();
        b.runTo(63);
        applyTheme(*qApp, Theme::dark());
        applyTheme(*qApp, Theme::light());
        QVERIFY(!b.curve(PlotSignal::ForceZ).isVisible());
        QVERIFY(!b.curve(PlotSignal::CurrentShoulder).isVisible());
        b.clickLegend(PlotSignal::ForceZ);
        QVERIFY(b.curve(PlotSignal::ForceZ).isVisible());
        QVERIFY(b.forces().range().max() > 60);
        QVERIFY(!b.curve(PlotSignal::CurrentShoulder).isVisible());
    }

    void aNameInALegendIsReadWithControl() {
        Bench b;
        b.clickLegend(PlotSignal::CurrentElbow, Qt::ControlModifier);
        QVERIFY(b.view().readoutSignal() == PlotSignal::CurrentElbow);
        QVERIFY(!b.view().isHidden(PlotSignal::CurrentElbow));
        QTest::keyClick(&b.view(), Qt::Key_H);
        QVERIFY(b.view().isHidden(PlotSignal::CurrentElbow));
        QTest::keyClick(&b.view(), Qt::Key_H);
        QVERIFY(!b.view().isHidden(PlotSignal::CurrentElbow));
    }

    void theWheelOverTheValuesZoomsThem() {
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
        // New data leave it as it is.
        b.runTo(70);
        QVERIFY(near(b.forces().range().max() - b.forces().range().min(), span * 0.64, 1e-6));
        QTest::mouseDClick(b.view().viewport(), Qt::LeftButton, {}, axis.toPoint());
        QVERIFY(!b.forces().isZoomed());
        QVERIFY(b.forces().range().max() - b.forces().range().min() > span * 0.9);
        // With Ctrl anywhere over a plot, and by keys for the plot whose signal is read.
        b.wheelAt(b.view().panes()[1]->area().center(), 1, Qt::ControlModifier);
        QVERIFY(b.view().panes()[1]->isZoomed());
        QVERIFY(!b.forces().isZoomed());
        QTest::keyClick(&b.view(), Qt::Key_Plus, Qt::ControlModifier);
        QVERIFY(b.forces().isZoomed());
        QTest::keyClick(&b.view(), Qt::Key_0, Qt::ControlModifier);
        QVERIFY(!b.forces().isZoomed());
        QCOMPARE(b.view().window().span(), time);
    }

    void zeroCountsTheForceFromNowAndSaysSo() {
        Bench b;
        b.view().setCursor(PlotView::Cursor::A, 60.0);
        QVERIFY2(b.readout().contains("Fz +60.0 N"), qPrintable(b.readout()));
        const QImage plain = b.view().grab().toImage();
        QTest::mouseClick(b.button("plots.zero"), Qt::LeftButton);
        QVERIFY(b.button("plots.zero")->isChecked());
        // The mean of the last quarter of a second of Fz = time.
        QVERIFY(near(b.forces().offset(PlotSignal::ForceZ), 59.875, 0.01));
        QVERIFY2(b.readout().contains("Fz (zeroed) +0.1 N"), qPrintable(b.readout()));
        QVERIFY(b.view().zeroText().contains("Fz +59.9"));
        QVERIFY(b.forces().range().max() < 20);
        QVERIFY2(b.view().grab().toImage() != plain, "the plot carries a mark");
        // What was measured stays.
        QVERIFY(near(b.view().valueAt(PlotSignal::ForceZ, 50).value(), 50, 0.01));
        b.runTo(70);
        QVERIFY(near(b.forces().offset(PlotSignal::ForceZ), 59.875, 0.01));
        QTemporaryDir folder;
        QVERIFY(b.dock.exportTo(folder.filePath("zeroed.svg")));
        QFile picture(folder.filePath("zeroed.svg"));
        QVERIFY(picture.open(QIODevice::ReadOnly));
        QVERIFY(picture.readAll().contains("Zeroed"));
        // And the way back.
        QTest::mouseClick(b.button("plots.zero"), Qt::LeftButton);
        QVERIFY(!b.button("plots.zero")->isChecked());
        QVERIFY(b.view().zeroText().isEmpty());
        QVERIFY(b.forces().range().max() > 60);
        QVERIFY2(b.readout().contains("Fz +60.0 N"), qPrintable(b.readout()));
    }

    // Its tool weighs something else.
    void anotherRobotIsNotZeroed() {
        Bench b;
        QTest::mouseClick(b.button("plots.zero"), Qt::LeftButton);
        Q_EMIT b.session.linkBegan();
        QVERIFY(!b.view().isForceZeroed());
        QVERIFY(!b.button("plots.zero")->isChecked());
    }

    void withoutSamplesThereIsNothingToZero() {
        RobotSession session;
        PlotDock dock(session);
        dock.resize(900, 300);
        dock.show();
        QSignalSpy messages(&session, &RobotSession::message);
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

    void thereIsNoValueInAGap() {
        Bench b;
        b.next += 2000;  // four seconds lost
        b.runTo(70);
        QVERIFY(b.view().valueAt(PlotSignal::ForceZ, 59.9).has_value());
        QVERIFY(!b.view().valueAt(PlotSignal::ForceZ, 62).has_value());
        QVERIFY(!b.view().valueAt(PlotSignal::ForceZ, 60.05).has_value());
        QVERIFY(near(b.view().valueAt(PlotSignal::ForceZ, 65).value(), 65, 0.01));
        // Nor a line across it.
        const CurveItem& fz = *b.view().panes()[0]->curves()[2];
        const auto column = [&](double time) {
            const double share = (time - b.view().window().start()) / b.view().window().span();
            return fz
                .columns()[static_cast<std::size_t>(share * static_cast<double>(fz.columns().size() - 1))];
        };
        QVERIFY(std::isnan(column(62).left));
        QVERIFY(!std::isnan(column(59.5).left));
        QVERIFY(!std::isnan(column(65).left));
    }

    void aCurveIsDrawnWhereItsValuesAre() {
        SeriesBuffer history(1, 4096);
        std::array<float, 1> row{};
        for (int i = 0; i < 4000; ++i) {
            row[0] = i < 2000 ? 2.0F : 8.0F;
            history.append(i * 0.001, row);
        }
        for (const double span : {4.0, 0.05}) {  // through columns of many samples, and through single ones
            CurveItem curve(0, nullptr);
            curve.setPen(QPen(Qt::red, 2));
            ColumnGrid grid;
            const double t0 = 2.0 - span / 2;
            history.cut(t0, span / 200, 200, grid);
            curve.sample(history, grid);
            curve.setView(QRectF(0, 0, 200, 100), t0, t0 + span, 0, 10);
            QImage image(200, 100, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::white);
            QPainter painter(&image);
            curve.paint(&painter, nullptr, nullptr);
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
            b.dock.setJogLabel(i >= 400 && i < 500 ? QStringLiteral("X+") : QString());
            Q_EMIT b.session.stateChanged(running(i * 0.1, i >= 400 && i < 500));
        }
        b.runTo(60.1);
        const auto& seen = b.view().laneItem().segments();
        QCOMPARE(seen.size(), std::size_t{3});
        QCOMPARE(seen[0].label, QString("Idle"));
        QCOMPARE(seen[1].label, QString("Jog X+"));
        QVERIFY(seen[1].kind == LaneKind::Moving);
        QVERIFY(near(seen[1].start, 40, 1e-6));
        QVERIFY(near(seen[1].end, 50, 1e-6));
    }

    void anOutageIsGreyAndAsLongAsItLasted() {
        Bench b;
        Q_EMIT b.session.stateChanged(running(59, true));
        Q_EMIT b.session.stateChanged(running(60, true));
        SessionState lost = running(60, true);
        lost.link = LinkState::Lost;
        for (int frame = 1; frame <= 100; ++frame) {
            lost.quality.ageMs = frame * 50;
            Q_EMIT b.session.stateChanged(lost);
        }
        // It goes on while it lasts, and the time axis with it.
        QVERIFY(near(b.view().window().end(), 65, 0.003));
        const auto seen = b.view().laneItem().segments();
        QCOMPARE(seen.size(), std::size_t{2});
        QVERIFY(seen[0].kind == LaneKind::Moving);
        QVERIFY(near(seen[0].end, 60, 0.003));
        QVERIFY(seen[1].kind == LaneKind::NoData);
        QCOMPARE(seen[1].label, QString("No data"));
        QVERIFY(near(seen[1].end, 65, 0.003));

        // What comes back stands behind it.
        b.next = 33'000;
        b.runTo(66.1);
        Q_EMIT b.session.stateChanged(running(66.1, false));
        const auto& after = b.dock.lane().segments();
        QVERIFY(after.back().kind == LaneKind::Idle);
        const LaneSegment& outage = after[after.size() - 2];
        QVERIFY(outage.kind == LaneKind::NoData);
        QVERIFY(near(outage.start, 60, 0.003));
        QVERIFY(near(outage.end, 66, 0.003));
    }

    // Too short for the header to say it, and still not a motion.
    void aShortSilenceIsNotDrawnAsMotion() {
        Bench b;
        Q_EMIT b.session.stateChanged(running(60, true));
        b.next = 30'400;  // 0.8 s later
        b.runTo(61);
        Q_EMIT b.session.stateChanged(running(61, true));
        const auto& segments = b.dock.lane().segments();
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

    // Whatever the window's colours: a white page with a title, and neither keys nor pixels where lines will do.
    void picturesAreForPaper() {
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
        QVERIFY(svg.contains("TCP force and joint currents"));
        QVERIFY(svg.contains("controller time"));
        QVERIFY(svg.contains("Fz"));
        for (const char* unit : {" N", " A", " s"}) {
            QVERIFY2(
                svg.contains(QByteArray(unit) + "\n</text>") || svg.contains(QByteArray(unit) + "</text>"),
                unit);
        }
        QVERIFY(svg.contains("<path") || svg.contains("<polyline"));
        QVERIFY2(!svg.contains("<image"), "curves are drawn as pixels");
        QVERIFY(!svg.contains("Record"));
        const QByteArray pdf = bytesOf("a.pdf");
        QVERIFY(pdf.startsWith("%PDF"));
        QVERIFY2(!pdf.contains("/Subtype /Image"), "curves are drawn as pixels");
        QVERIFY(Theme::current().isDark());
    }

    void aFileOfAnotherKindIsRefusedAndLeftAlone() {
        Bench b;
        QTemporaryDir folder;
        QFile file(folder.filePath("picture.gif"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
        file.close();
        QSignalSpy messages(&b.session, &RobotSession::message);
        QVERIFY(!b.dock.exportTo(file.fileName()));
        QVERIFY(messages.last().at(1).toString().contains(".svg"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("mine"));
    }

    void anExportThatFailsSaysWhy() {
        Bench b;
        QSignalSpy messages(&b.session, &RobotSession::message);
        QVERIFY(!b.dock.exportTo("/nonexistent/folder/x.csv"));
        QVERIFY(!b.dock.exportTo("/nonexistent/folder/x.png"));
        QCOMPARE(messages.count(), 2);
        for (const auto& message : messages) {
            QVERIFY(message.at(0).value<Severity>() == Severity::Error);
            QVERIFY(!message.at(1).toString().isEmpty());
        }
    }

    void recordingWithoutARobotSaysWhatToDo() {
        Bench b;
        QTemporaryDir folder;
        b.dock.setRecordingChoice({.folder = folder.path()});
        QSignalSpy messages(&b.session, &RobotSession::message);
        QTest::mouseClick(b.button("plots.record"), Qt::LeftButton);
        QVERIFY(messages.count() >= 1);
        QVERIFY(messages.last().at(1).toString().contains("connect", Qt::CaseInsensitive));
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

    void theMenuBesideRecordSaysWhatIsRecordedAndChangesIt() {
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

    void bothSchemesDrawWithoutAWarning() {
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
