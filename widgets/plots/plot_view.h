// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One page of plots: charts stacked in columns, state lanes below them, and two cursors on a common time
// axis. Dragging and the mouse wheel scroll in time. Signals can be dropped onto the plots. The view does not
// affect the robot.

#include <QDateTime>
#include <QGraphicsView>
#include <QHash>
#include <QStringList>
#include <QTimer>
#include <array>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "robot/station/history/history_file.h"
#include "robot/station/history/recorded_clock.h"
#include "robot/station/history/series_buffer.h"
#include "widgets/plots/plot_layout.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/time_window.h"

namespace tiller {

class CursorItem;
class LaneItem;
class PlotMarks;
class SignalStore;
class StateLane;

class PlotView : public QGraphicsView {
    Q_OBJECT

public:
    enum class Cursor { A, B };
    /// Position at which a signal is dropped relative to a plot.
    enum class Place { Into, Above, Below, Beside };

    /// store, lane, marks  must outlive the view
    PlotView(SignalStore& store, const StateLane& lane, PlotMarks& marks, QWidget* parent = nullptr);
    ~PlotView() override;

    /// Shows the newest data. Call this after data have arrived or time has passed. The call takes little
    /// time if nothing has changed or the view is hidden.
    /// seconds  time since the last call, for adapting the scales
    void refresh(double seconds);

    /// Copies range, cursors and readout signal from another view of the same history.
    /// page  if true, also copies the page
    void showLike(const PlotView& other, bool page);

    PageLayout page() const;
    /// Returns  false, without any change, if the robot cannot send this number of signals
    bool setPage(const PageLayout& page);
    /// Adds signals, ignoring existing and unknown ones. State signals are added as lanes, regardless of
    /// `place`.
    /// Returns  false if the robot cannot send this number of signals
    bool addSignals(const QStringList& keys, int pane, Place place = Place::Into);
    /// Adds signals to the plot that contains the signal read by the cursors.
    bool addSignals(const QStringList& keys);
    void removeSignal(int pane, int signal);
    void removePane(int pane);
    void removeLane(int signal);
    PlotMarks& marks() const { return marks_; }
    /// All displayed signals, including lanes.
    QSet<int> signalsShown() const;
    /// Recordings that contain displayed signals.
    QStringList recordingsShown() const;
    /// The recording of the readout signal, otherwise of any signal on the page. Empty if the page is live.
    /// Determines the lane of the robot state, the replayed time, and the recording to which notes are added.
    QString recordingInFront() const;

    const TimeWindow& window() const { return window_; }
    /// clock  returns the time of day for a time on the time axis, if known
    void setTimeAxis(TimeAxis axis, std::function<QDateTime(double)> clock);
    TimeAxis timeAxis() const { return timeAxis_; }
    /// Labels below the plots, from left to right.
    QStringList timeLabels() const { return timeLabels_; }
    void setSpan(double seconds);
    void pause();
    /// Shows the newest samples again and follows them.
    void follow();
    void scrollBy(double seconds);
    void showRange(double from, double to);
    /// Shows the whole time range and scales each plot to its data.
    void fit();

    std::optional<double> cursor(Cursor which) const { return cursors_[index(which)]; }
    /// time  time on the time axis [s]; empty removes the cursor
    void setCursor(Cursor which, std::optional<double> time);
    /// Moves cursor A to this time and makes it visible.
    void goTo(double time);
    /// Time for a new note: the time of the selected cursor if it is visible, otherwise the end of the
    /// visible range.
    double noteTime() const;
    int readoutSignal() const { return readoutSignal_; }
    void setReadoutSignal(int signal);
    /// Values at the cursors, e.g. "A–B Δt 1.200 s · ΔFz −9.8 N", "A −12.300 s · Fz −4.1 N"; may be empty.
    QString readout() const;
    bool isHidden(int signal) const;
    void setHidden(int signal, bool hidden);
    /// Displays the TCP force relative to its value at the end of the displayed range. Returns false without
    /// force data.
    bool zeroForce();
    /// Displays the force as measured.
    void clearZero();
    bool isForceZeroed() const { return !offsets_.isEmpty(); }
    /// Text with the offsets; empty if the force is not zeroed.
    QString zeroText() const;
    const std::vector<std::unique_ptr<PlotPane>>& panes() const { return panes_; }
    const LaneItem& laneItem() const { return *laneItem_; }
    /// Loads and shows all details of a long recording immediately. Without this call, they are loaded over
    /// several frames.
    void showSharp();
    /// Returns null if this signal has no lane.
    const LaneItem* signalLane(int signal) const;
    /// Returns the pixel columns of the displayed range for the samples of a history.
    const ColumnGrid& gridOf(const SeriesBuffer& history) const;
    /// The plot at this position in the view, including the area of its labels.
    PlotPane& paneAt(const QPointF& place) const;
    int paneIndex(const PlotPane& pane) const;
    /// The signal whose legend entry or lane is at this position.
    std::optional<int> legendAt(const QPointF& place) const;
    std::optional<int> laneAt(const QPointF& place) const;
    /// Lets the scale of the pane follow the curves again.
    void releaseValues(PlotPane& pane);
    /// Removes the limits of the value axes of a plot.
    void scaleToCurves(PlotPane& pane);
    double timeAt(double x) const;
    double xAt(double time) const;

    QSize sizeHint() const override { return {1490, 340}; }
    QSize minimumSizeHint() const override { return {320, 130}; }

Q_SIGNALS:
    /// The time range, pause state or position in the history has changed.
    void windowChanged();
    void readoutChanged();
    /// The displayed ages of the cursor times have changed while following; at most 10 times per second.
    void readoutAged();
    void zeroChanged();
    /// Plots, signals or lanes have changed.
    void pageChanged();
    /// The robot cannot send the requested number of signals.
    void tooManySignals();
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
    /// Updates the time limits of the window from the displayed histories and the lane.
    void measure();
    /// Updates immediately with the best scales. Call this after the user has changed the time window.
    void rewind();
    void show(double seconds, HistoryFile::Effort effort = HistoryFile::Effort::Draft);
    /// Requests the signals of the page and of the state lanes of its recordings.
    /// Returns  false if the signals of the page cannot be shown
    bool want(const QSet<int>& shown);
    /// True if the curves have moved far enough, or enough time has passed, since the last repaint.
    bool isDue() const;
    void placeTicks();
    /// The clocks of the recording if the page shows nothing else; otherwise null.
    const RecordedClock* recordedClock() const;
    void placeCursors();
    void click(const QPointF& point);
    std::optional<Cursor> cursorNear(double x) const;
    bool moveActiveCursor(int pixels);
    void cycleReadout(int by);
    /// The plot area of the column at this horizontal position.
    const QRectF& areaAt(double x) const;
    PlotPane* paneOf(int signal) const;
    /// The value axis at this position; empty for other positions.
    std::optional<PlotPane::Side> valuesAt(const QPointF& place) const;
    void legendClicked(int signal, Qt::KeyboardModifiers modifiers);
    void zoomValues(PlotPane& pane, std::initializer_list<PlotPane::Side> sides, double factor, double y);
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
    std::array<std::vector<CursorItem*>, 2> cursorItems_;  // one per column
    std::array<std::optional<double>, 2> cursors_;
    std::array<std::optional<double>, 2> cursorsBefore_;  // positions before the last click
    Cursor active_ = Cursor::A;
    int readoutSignal_;
    std::map<const SeriesBuffer*, ColumnGrid> grids_;
    bool showsLive_ = true;  // the page shows a live signal, or no signal
    std::int64_t shownEnd_ = -1;
    double shownNewest_ = 0;
    double sinceShown_ = 0;  // time since the last repaint [s]
    double reference_ = 0;   // reference of the time labels [s]
    double agedAt_ = 0;      // reference at the last readoutAged() [s]
    TimeAxis timeAxis_ = TimeAxis::Relative;
    std::function<QDateTime(double)> clock_;
    QStringList timeLabels_;
    mutable double tickSpan_ = -1;
    double tickEnd_ = 0;
    mutable const recording::Recording* clockOf_ = nullptr;  ///< recording of recordedClock_
    mutable std::optional<RecordedClock> recordedClock_;
    QTimer sharpen_;              // active while more details of a recording can be loaded
    QHash<int, double> offsets_;  // offsets by signal; empty if not zeroed
    QString name_;
    Drag drag_ = Drag::None;
    std::optional<int> legendPressed_;
    Target dropTarget_;
    QPointF pressAt_;
    QPointF lastAt_;
};

}  // namespace tiller
