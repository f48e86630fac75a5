// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One page of plots: charts stacked in columns, lanes of states under them, and two cursors over one time axis.
// Dragging and the wheel move through time, signals are dropped onto it; nothing done here reaches the robot.

#include <QDateTime>
#include <QGraphicsView>
#include <QHash>
#include <QStringList>
#include <QTimer>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "robot/station/history/history_file.h"
#include "robot/station/history/series_buffer.h"
#include "widgets/plots/plot_layout.h"
#include "widgets/plots/time_window.h"

namespace tiller {

class CursorItem;
class LaneItem;
class PlotMarks;
class PlotPane;
class SignalStore;
class StateLane;

class PlotView : public QGraphicsView {
    Q_OBJECT

public:
    enum class Cursor { A, B };
    /// Where a signal goes that is dropped onto a plot.
    enum class Place { Into, Above, Below, Beside };

    /// store, lane, marks  must outlive the view
    PlotView(SignalStore& store, const StateLane& lane, PlotMarks& marks, QWidget* parent = nullptr);
    ~PlotView() override;

    /// Data came or the time went on, with or without data: shows the newest. Cheap when nothing changed or
    /// nobody sees it.
    /// seconds  since the last call; paces the calm of the scales
    void refresh(double seconds);

    /// The range, cursors and signal that another view of the same history shows, and its page if asked for.
    void showLike(const PlotView& other, bool page);

    // What is shown.
    PageLayout page() const;
    /// Returns  false, and changes nothing, if the robot cannot be asked for so many signals
    bool setPage(const PageLayout& page);
    /// States become lanes, wherever they are put. What is there already, or does not exist, is passed over.
    /// Returns  false if the robot cannot be asked for so many
    bool addSignals(const QStringList& keys, int pane, Place place = Place::Into);
    /// Into the plot whose signal the cursors read.
    bool addSignals(const QStringList& keys);
    void removeSignal(int pane, int signal);
    void removePane(int pane);
    void removeLane(int signal);
    PlotMarks& marks() const { return marks_; }
    /// All that is shown, lanes too.
    QSet<int> signalsShown() const;
    /// Those that something shown is of.
    QStringList recordingsShown() const;

    const TimeWindow& window() const { return window_; }
    /// clock  the time of the day of a moment on the time axis, if somebody knows
    void setTimeAxis(TimeAxis axis, std::function<QDateTime(double)> clock);
    TimeAxis timeAxis() const { return timeAxis_; }
    /// What stands under the plots, from left to right.
    QStringList timeLabels() const { return timeLabels_; }
    void setSpan(double seconds);
    void pause();
    /// Back to the newest samples.
    void follow();
    void scrollBy(double seconds);
    void showRange(double from, double to);
    /// All that is known, each plot at its best scale.
    void fit();

    std::optional<double> cursor(Cursor which) const { return cursors_[index(which)]; }
    /// A moment on the time axis [s]; nothing takes the cursor away.
    void setCursor(Cursor which, std::optional<double> time);
    /// Cursor A stands there, in sight.
    void goTo(double time);
    int readoutSignal() const { return readoutSignal_; }
    void setReadoutSignal(int signal);
    /// "A–B Δt 1.200 s · ΔFz −9.8 N", "A −12.300 s · Fz −4.1 N", or empty.
    QString readout() const;
    bool isHidden(int signal) const;
    void setHidden(int signal, bool hidden);
    /// Counts the TCP force from what it is at the end of the range shown; false: there is none.
    bool zeroForce();
    /// Shows it as the robot measures it again.
    void clearZero();
    bool isForceZeroed() const { return !offsets_.isEmpty(); }
    /// "Zeroed: Fx −0.3 · Fy +1.2 · Fz −9.8 N taken off"; empty unless it is.
    QString zeroText() const;
    const std::vector<std::unique_ptr<PlotPane>>& panes() const { return panes_; }
    const LaneItem& laneItem() const { return *laneItem_; }
    /// Shows all that a long recording has to tell, which otherwise comes in the course of some frames.
    void showSharp();
    /// Null: there is no lane of that signal.
    const LaneItem* signalLane(int signal) const;
    /// The samples behind a picture are shown as they fall into these columns.
    const ColumnGrid& gridOf(const SeriesBuffer& history) const;
    /// The plot over which a place of the view is, labels included.
    PlotPane& paneAt(const QPointF& place) const;
    int paneIndex(const PlotPane& pane) const;
    /// The signal whose name in a legend, or lane, is at this place.
    std::optional<int> legendAt(const QPointF& place) const;
    std::optional<int> laneAt(const QPointF& place) const;
    /// The curves decide about its scale again.
    void releaseValues(PlotPane& pane);
    double timeAt(double x) const;
    double xAt(double time) const;

    QSize sizeHint() const override { return {1490, 340}; }
    QSize minimumSizeHint() const override { return {320, 130}; }

Q_SIGNALS:
    /// Span, pause or place in history changed.
    void windowChanged();
    void readoutChanged();
    void zeroChanged();
    /// Plots, their signals or lanes are others.
    void pageChanged();
    /// More signals were asked for than a robot takes.
    void tooManySignals();
    /// A note for this moment is wanted.
    void noteWanted(double time);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;

private:
    static std::size_t index(Cursor which) { return which == Cursor::A ? 0 : 1; }
    enum class Drag { None, Undecided, Pan, Cursor, Legend, Frame };
    struct SignalLane {
        int signal;
        LaneItem* item;
    };
    struct Target {
        int pane = -1;
        Place place = Place::Into;
        QRectF mark;
    };

    void layOut();
    void build(const PageLayout& page);
    /// Tells the window how far history and lane reach.
    void measure();
    /// The window changed by hand: shows it at once, with the best scales.
    void rewind();
    void show(double seconds, HistoryFile::Effort effort = HistoryFile::Effort::Draft);
    /// So much has changed that a new picture is worth its cost.
    bool isDue() const;
    void placeTicks();
    void placeCursors();
    void click(const QPointF& point);
    std::optional<Cursor> cursorNear(double x) const;
    bool moveActiveCursor(int pixels);
    void cycleReadout(int by);
    /// The plots' area over which x is.
    const QRectF& areaAt(double x) const;
    PlotPane* paneOf(int signal) const;
    bool isOverValues(const QPointF& place) const;
    void legendClicked(int signal, Qt::KeyboardModifiers modifiers);
    void zoomValues(PlotPane& pane, double factor, double y);
    bool keyWithControl(int key);
    std::optional<double> meanAtTheEnd(int signal) const;
    std::vector<int> forces() const;
    void drawMark(QPainter& painter, const PlotPane& pane, const QString& text) const;
    std::vector<int> curvesShown() const;
    Target targetAt(const QPointF& place) const;
    QRectF frameRect() const;
    void drawMarks(QPainter& painter) const;
    void drawThresholds(QPainter& painter, const PlotPane& pane) const;

    SignalStore& store_;
    const StateLane& lane_;
    PlotMarks& marks_;
    TimeWindow window_;
    std::unique_ptr<QGraphicsScene> scene_;
    std::vector<std::unique_ptr<PlotPane>> panes_;
    int columns_ = 1;
    LaneItem* laneItem_;
    std::vector<SignalLane> lanes_;
    std::array<std::vector<CursorItem*>, 2> cursorItems_;  // one in each column
    std::array<std::optional<double>, 2> cursors_;
    std::array<std::optional<double>, 2> cursorsBefore_;  // the last click
    Cursor active_ = Cursor::A;
    int readoutSignal_;
    std::map<const SeriesBuffer*, ColumnGrid> grids_;
    std::int64_t shownEnd_ = -1;
    double shownNewest_ = 0;
    double sinceShown_ = 0;  // [s]
    double reference_ = 0;   // what the time labels count from [s]
    TimeAxis timeAxis_ = TimeAxis::Relative;
    std::function<QDateTime(double)> clock_;
    QStringList timeLabels_;
    double tickSpan_ = -1;
    double tickEnd_ = 0;
    QTimer sharpen_;              // more is known of what is shown than was read
    QHash<int, double> offsets_;  // by signal; empty: none is zeroed
    QString name_;                // of the page
    Drag drag_ = Drag::None;
    std::optional<int> legendPressed_;
    Target dropTarget_;
    QPointF pressAt_;
    QPointF lastAt_;
};

}  // namespace tiller
