// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The plots themselves: two stacked charts, the lane of states and two cursors over one time axis. Dragging
// and the wheel move through time; nothing done here reaches the robot.

#include <QGraphicsView>
#include <array>
#include <memory>
#include <optional>

#include "widgets/plots/plot_signals.h"
#include "widgets/plots/series_buffer.h"
#include "widgets/plots/time_window.h"

namespace tiller {

class CursorItem;
class LaneItem;
class PlotPane;
class StateLane;

class PlotView : public QGraphicsView {
    Q_OBJECT

public:
    enum class Cursor { A, B };

    /// history, lane  must outlive the view
    PlotView(const SeriesBuffer& history, const StateLane& lane, QWidget* parent = nullptr);
    ~PlotView() override;

    /// Data came or the time went on, with or without data: shows the newest. Cheap when nothing changed.
    /// seconds  since the last call; paces the calm of the scales
    void refresh(double seconds);

    /// The range, cursors and signal that another view of the same history shows.
    void showLike(const PlotView& other);

    const TimeWindow& window() const { return window_; }
    void setSpan(double seconds);
    void pause();
    /// Back to the newest samples.
    void follow();
    void scrollBy(double seconds);

    std::optional<double> cursor(Cursor which) const { return cursors_[index(which)]; }
    /// A moment on the time axis [s]; nothing takes the cursor away.
    void setCursor(Cursor which, std::optional<double> time);
    PlotSignal readoutSignal() const { return readoutSignal_; }
    void setReadoutSignal(PlotSignal signal);
    /// "A–B Δt 1.200 s · ΔFz −9.8 N", "A −12.300 s · Fz −4.1 N", or empty.
    QString readout() const;
    bool isHidden(PlotSignal signal) const;
    void setHidden(PlotSignal signal, bool hidden);
    /// Counts the TCP force from what it is at the end of the range shown; false: there is none.
    bool zeroForce();
    /// Shows it as the robot measures it again.
    void clearZero();
    bool isForceZeroed() const { return forceZeroed_; }
    /// "Zeroed: Fx −0.3 · Fy +1.2 · Fz −9.8 N taken off"; empty unless it is.
    QString zeroText() const;
    /// The value of a signal at a moment, as the robot measured it; nothing in a gap or where there are no data.
    std::optional<double> valueAt(PlotSignal signal, double time) const;

    const std::vector<std::unique_ptr<PlotPane>>& panes() const { return panes_; }
    const LaneItem& laneItem() const { return *laneItem_; }
    double timeAt(double x) const;
    double xAt(double time) const;

    QSize sizeHint() const override { return {1490, 340}; }
    QSize minimumSizeHint() const override { return {320, 130}; }

Q_SIGNALS:
    /// Span, pause or place in history changed.
    void windowChanged();
    void readoutChanged();
    void zeroChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;

private:
    static std::size_t index(Cursor which) { return which == Cursor::A ? 0 : 1; }
    enum class Drag { None, Undecided, Pan, Cursor, Legend };

    void layOut();
    /// Tells the window how far history and lane reach.
    void measure();
    /// The window changed by hand: shows it at once, with the best scales.
    void rewind();
    void show(double seconds);
    /// So much has changed that a new picture is worth its cost.
    bool isDue() const;
    void placeTicks();
    void placeCursors();
    void click(const QPointF& point);
    std::optional<Cursor> cursorNear(double x) const;
    bool moveActiveCursor(int pixels);
    void cycleReadout(int by);
    PlotPane& paneAt(double y) const;
    PlotPane& paneOf(PlotSignal signal) const;
    std::optional<PlotSignal> legendAt(const QPointF& place) const;
    void legendClicked(PlotSignal signal, Qt::KeyboardModifiers modifiers);
    void zoomValues(PlotPane& pane, double factor, double y);
    void releaseValues(PlotPane& pane);
    bool keyWithControl(int key);
    std::optional<double> forceAtTheEnd(PlotSignal signal) const;
    void drawMark(QPainter& painter, const PlotPane& pane, const QString& text) const;
    std::vector<PlotSignal> signalsShown() const;

    const SeriesBuffer& history_;
    const StateLane& lane_;
    TimeWindow window_;
    std::unique_ptr<QGraphicsScene> scene_;
    std::vector<std::unique_ptr<PlotPane>> panes_;
    LaneItem* laneItem_;
    std::array<CursorItem*, 2> cursorItems_{};
    std::array<std::optional<double>, 2> cursors_;
    Cursor active_ = Cursor::A;
    PlotSignal readoutSignal_ = PlotSignal::ForceZ;
    ColumnGrid grid_;
    std::int64_t shownEnd_ = -1;
    double shownNewest_ = 0;
    double sinceShown_ = 0;  // [s]
    double reference_ = 0;   // what the time labels count from [s]
    double tickSpan_ = -1;
    double tickEnd_ = 0;
    bool forceZeroed_ = false;
    Drag drag_ = Drag::None;
    std::optional<PlotSignal> legendPressed_;
    QPointF pressAt_;
    QPointF lastAt_;
};

}  // namespace tiller
