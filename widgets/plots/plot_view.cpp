// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_view.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QGraphicsScene>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <QResizeEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "robot/station/history/plot_marks.h"
#include "robot/station/history/recorded_lane.h"
#include "robot/station/history/signal_lane.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/history/state_lane.h"
#include "robot/station/text/format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/curve_look.h"
#include "widgets/plots/plot_menu.h"
#include "widgets/plots/plot_overlay.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/signals/signal_tree.h"

namespace tiller {

namespace {

constexpr double kLeft = PlotPane::kValueWidth;
constexpr double kRight = 10;
constexpr double kTop = 22;         // space for the letters of the cursors and the legend [px]
constexpr double kBetween = 24;     // space between two plots, for the legend of the lower plot [px]
constexpr double kTimeLabels = 20;  // space below the lowest plot [px]
constexpr double kLaneHeight = 14;
constexpr double kLaneGap = 2;
constexpr double kBottom = 10;
constexpr double kMinHeight = 24;  // minimum height of a plot [px]

double niceTickStep(double span, double width) {
    const double least = span / std::max(1.0, width / 110.0);  // minimum distance of labels [s]
    static constexpr double kSteps[] = {0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1,    2,    5,    10,
                                        20,    30,   60,   120,  300, 600, 900, 1800, 3600, 7200, 14400};
    for (const double step : kSteps) {
        if (step >= least) {
            return step;
        }
    }
    return 28800;
}

// Curves that have moved by fewer columns since the last repaint are repainted only after kCalmFrame.
constexpr double kQuickColumns = 3;
constexpr double kCalmFrame = 0.03;  // [s]
constexpr double kGrab = 6;          // distance within which a cursor is grabbed [px]
constexpr double kZoomPerNotch = 0.8;
constexpr int kCoarseStep = 10;  // factor for arrow keys with Shift

}  // namespace

PlotView::PlotView(SignalStore& store, const StateLane& lane, PlotMarks& marks, QWidget* parent)
    : QGraphicsView(parent)
    , store_(store)
    , lane_(lane)
    , marks_(marks)
    , scene_(std::make_unique<QGraphicsScene>())
    , laneItem_(new LaneItem)
    , readoutSignal_(store.find(QStringLiteral("actual_TCP_force_2"))) {
    setObjectName(QStringLiteral("plots.view"));
    setAccessibleName(tr("Plots over time"));
    setAccessibleDescription(
        tr("A and B place the cursors. Left and Right move the active cursor. Up and Down select the signal "
           "at the cursors. H hides the curve of this signal; Ctrl+Delete removes it. Plus and Minus change "
           "the time range, or the value scale with Ctrl; Ctrl+0 scales automatically. N adds a note, F "
           "shows all data, and End returns to the newest samples."));
    setScene(scene_.get());
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAcceptDrops(true);
    setBackgroundBrush(Qt::NoBrush);
    // Restrict the style to the view. Without a selector, its menus and tooltips would inherit the
    // transparent background.
    setStyleSheet(QStringLiteral("QGraphicsView { background: transparent; }"));
    scene_->setItemIndexMethod(QGraphicsScene::NoIndex);
    scene_->addItem(laneItem_);
    connect(&marks_, &PlotMarks::marksChanged, viewport(), qOverload<>(&QWidget::update));
    connect(&marks_, &PlotMarks::thresholdsChanged, viewport(), qOverload<>(&QWidget::update));
    sharpen_.setSingleShot(true);
    connect(&store_, &SignalStore::computedFurther, &sharpen_, qOverload<>(&QTimer::start));
    connect(&sharpen_, &QTimer::timeout, this, [this] {
        if (isVisible()) {
            show(-1, HistoryFile::Effort::Turn);
            viewport()->update();
        }
    });
    build(PageLayout::standard());
}

PlotView::~PlotView() {
    store_.want(this, {});
    // The scene also contains the charts, which belong to the panes. Destroy the panes before the scene.
    panes_.clear();
    setScene(nullptr);
}

// ---- content

void PlotView::build(const PageLayout& page) {
    name_ = page.name;
    panes_.clear();
    for (const SignalLane& lane : lanes_) {
        delete lane.item;
    }
    lanes_.clear();
    grids_.clear();
    columns_ = 1;
    for (const PaneLayout& wanted : page.panes) {
        std::vector<int> shown;
        for (const QString& key : wanted.shown) {
            if (const int signal = store_.findOrDerive(key);
                signal >= 0 && store_.buffer(signal) != nullptr) {
                shown.push_back(signal);
            }
        }
        auto& pane = panes_.emplace_back(std::make_unique<PlotPane>(*scene_, store_, std::move(shown)));
        pane->setColumn(wanted.column);
        pane->setShare(wanted.share);
        columns_ = std::max(columns_, wanted.column + 1);
        for (const int signal : pane->shown()) {
            pane->setHidden(signal, wanted.hidden.contains(store_.info(signal).key));
            pane->setOffset(signal, offsets_.value(signal, 0));
            if (const auto style = wanted.styles.find(store_.info(signal).key);
                style != wanted.styles.end()) {
                pane->setStyle(signal, *style);
            }
        }
        pane->setLimits(PlotPane::Side::Left, wanted.limits);
        pane->setLimits(PlotPane::Side::Right, wanted.rightLimits);
    }
    if (panes_.empty()) {
        panes_.push_back(std::make_unique<PlotPane>(*scene_, store_, std::vector<int>()));
    }
    for (const QString& key : page.lanes) {
        if (const int signal = store_.find(key); signal >= 0 && store_.buffer(signal) != nullptr) {
            auto* item = new LaneItem(store_.info(signal).longLabel);
            item->setToolTip(store_.info(signal).family + QStringLiteral(" · ") +
                             store_.info(signal).longLabel);
            scene_->addItem(item);
            lanes_.push_back({signal, item});
        }
    }
    for (const Cursor which : {Cursor::A, Cursor::B}) {
        auto& items = cursorItems_[index(which)];
        qDeleteAll(items);
        items.clear();
        for (int column = 0; column < columns_; ++column) {
            auto* item = new CursorItem(which == Cursor::A ? QStringLiteral("A") : QStringLiteral("B"));
            item->hide();
            scene_->addItem(item);
            items.push_back(item);
        }
    }
    if (const std::vector<int> curves = curvesShown();
        !curves.empty() && std::find(curves.begin(), curves.end(), readoutSignal_) == curves.end()) {
        readoutSignal_ = curves.front();
    }
    const QSet<int> shown = signalsShown();
    showsLive_ = shown.isEmpty() || std::any_of(shown.begin(), shown.end(),
                                                [this](int signal) { return !store_.isRecorded(signal); });
    for (const auto& pane : panes_) {
        pane->setEmphasis(readoutSignal_);
    }
    layOut();
    Q_EMIT readoutChanged();
}

PageLayout PlotView::page() const {
    PageLayout page;
    page.name = name_;
    for (const auto& pane : panes_) {
        PaneLayout one{{}, {}, pane->column(), pane->share()};
        for (const int signal : pane->shown()) {
            one.shown.append(store_.info(signal).key);
            if (pane->isHidden(signal)) {
                one.hidden.append(store_.info(signal).key);
            }
            if (const CurveStyle style = pane->style(signal); style != CurveStyle()) {
                one.styles[store_.info(signal).key] = style;
            }
        }
        one.limits = pane->limits(PlotPane::Side::Left);
        one.rightLimits = pane->limits(PlotPane::Side::Right);
        page.panes.append(one);
    }
    for (const SignalLane& lane : lanes_) {
        page.lanes.append(store_.info(lane.signal).key);
    }
    return page;
}

bool PlotView::setPage(const PageLayout& wanted) {
    PageLayout page = wanted;
    // Renumber the columns consecutively.
    std::map<int, int> columns;
    for (const PaneLayout& pane : page.panes) {
        columns[pane.column] = 0;
    }
    int next = 0;
    for (auto& [column, place] : columns) {
        place = next++;
    }
    for (PaneLayout& pane : page.panes) {
        pane.column = columns[pane.column];
    }
    QSet<int> shown;
    const auto add = [&](const QStringList& keys) {
        for (const QString& key : keys) {
            if (const int signal = store_.findOrDerive(key); signal >= 0) {
                shown.insert(signal);
            }
        }
    };
    for (const PaneLayout& pane : page.panes) {
        add(pane.shown);
    }
    add(page.lanes);
    if (!want(shown)) {
        Q_EMIT tooManySignals();
        return false;
    }
    build(page);
    show(-1);
    viewport()->update();
    Q_EMIT pageChanged();
    return true;
}

bool PlotView::want(const QSet<int>& shown) {
    QSet<int> all = shown;
    for (const int signal : shown) {
        if (store_.isRecorded(signal)) {
            const std::vector<int> ofLane = recordedLaneSignals(store_, store_.recordingOf(signal));
            all.unite(QSet<int>(ofLane.begin(), ofLane.end()));
        }
    }
    // If the store cannot also provide the signals of the state lanes, show the curves without them.
    return store_.want(this, all) || store_.want(this, shown);
}

bool PlotView::addSignals(const QStringList& keys, int pane, Place place) {
    PageLayout page = this->page();
    QStringList curves;
    for (const QString& key : keys) {
        const int signal = store_.findOrDerive(key);
        if (signal < 0) {
            continue;
        }
        QStringList& into = store_.info(signal).isState() ? page.lanes : curves;
        const int most = store_.info(signal).isState() ? PlotLayout::kMaxLanes : PlotLayout::kMaxSignals;
        if (!into.contains(key) && into.size() < most) {
            into.append(key);
        }
    }
    const int at = std::clamp(pane, 0, static_cast<int>(page.panes.size()) - 1);
    PaneLayout& target = page.panes[at];
    if (!curves.isEmpty() && place == Place::Into) {
        for (const QString& key : std::as_const(curves)) {
            if (!target.shown.contains(key) && target.shown.size() < PlotLayout::kMaxSignals) {
                target.shown.append(key);
            }
        }
    } else if (!curves.isEmpty() && page.panes.size() < PlotLayout::kMaxPanes) {
        PaneLayout added{curves, {}, target.column, 1};
        if (place == Place::Beside) {
            added.column = std::min(target.column + 1, PlotLayout::kMaxColumns - 1);
            for (PaneLayout& other : page.panes) {
                const bool moves = other.column > target.column && columns_ < PlotLayout::kMaxColumns;
                other.column += moves ? 1 : 0;
            }
            page.panes.append(added);
            std::stable_sort(page.panes.begin(), page.panes.end(),
                             [](const PaneLayout& a, const PaneLayout& b) { return a.column < b.column; });
        } else {
            // The new plot has the average height. The other plots keep their proportions.
            double shares = 0;
            int count = 0;
            for (const PaneLayout& other : std::as_const(page.panes)) {
                shares += other.column == target.column ? other.share : 0;
                count += other.column == target.column ? 1 : 0;
            }
            added.share = shares / count;
            page.panes.insert(place == Place::Below ? at + 1 : at, added);
        }
    }
    if (page == this->page()) {
        return true;
    }
    const bool done = setPage(page);
    if (done && !curves.isEmpty()) {
        setReadoutSignal(store_.find(curves.first()));
    }
    return done;
}

bool PlotView::addSignals(const QStringList& keys) {
    const PlotPane* pane = paneOf(readoutSignal_);
    return addSignals(keys, pane == nullptr ? 0 : paneIndex(*pane));
}

void PlotView::removeSignal(int pane, int signal) {
    PageLayout page = this->page();
    page.panes[pane].shown.removeAll(store_.info(signal).key);
    setPage(page);
}

void PlotView::removePane(int pane) {
    PageLayout page = this->page();
    if (page.panes.size() > 1) {
        page.panes.remove(pane);
    } else {
        page.panes[pane].shown.clear();
    }
    setPage(page);
}

void PlotView::removeLane(int signal) {
    PageLayout page = this->page();
    page.lanes.removeAll(store_.info(signal).key);
    setPage(page);
}

std::vector<int> PlotView::curvesShown() const {
    std::vector<int> out;
    for (const auto& pane : panes_) {
        out.insert(out.end(), pane->shown().begin(), pane->shown().end());
    }
    return out;
}

QSet<int> PlotView::signalsShown() const {
    const std::vector<int> curves = curvesShown();
    QSet<int> all(curves.begin(), curves.end());
    for (const SignalLane& lane : lanes_) {
        all.insert(lane.signal);
    }
    return all;
}

QStringList PlotView::recordingsShown() const {
    QStringList all;
    const QSet<int> shown = signalsShown();
    for (const int signal : shown) {
        const QString recording = store_.recordingOf(signal);
        if (!recording.isEmpty() && !all.contains(recording)) {
            all.append(recording);
        }
    }
    return all;
}

const RecordedClock* PlotView::recordedClock() const {
    const QSet<int> shown = signalsShown();
    const bool isLive =
        std::any_of(shown.begin(), shown.end(), [this](int signal) { return !store_.isRecorded(signal); });
    const QStringList recordings = recordingsShown();
    const recording::Recording* file =
        !isLive && recordings.size() == 1 ? store_.recorded(recordings.front()) : nullptr;
    if (file != clockOf_) {
        clockOf_ = file;
        recordedClock_.reset();
        if (file != nullptr) {
            recordedClock_.emplace(*file, store_.timesOf(recordings.front())->firstTime());
        }
        tickSpan_ = -1;  // the labels change
    }
    return recordedClock_ ? &*recordedClock_ : nullptr;
}

QString PlotView::recordingInFront() const {
    const QSet<int> shown = signalsShown();
    if (shown.contains(readoutSignal_)) {
        return store_.recordingOf(readoutSignal_);
    }
    const auto recorded =
        std::find_if(shown.begin(), shown.end(), [this](int signal) { return store_.isRecorded(signal); });
    return recorded == shown.end() ? QString() : store_.recordingOf(*recorded);
}

const LaneItem* PlotView::signalLane(int signal) const {
    const auto found = std::find_if(lanes_.begin(), lanes_.end(),
                                    [signal](const SignalLane& lane) { return lane.signal == signal; });
    return found == lanes_.end() ? nullptr : found->item;
}

// ---- layout

void PlotView::layOut() {
    const QSizeF size = viewport()->size();
    scene_->setSceneRect(QRectF(QPointF(0, 0), size));
    const bool hasRight =
        std::any_of(panes_.begin(), panes_.end(), [](const auto& pane) { return pane->hasRight(); });
    const double beside = kLeft + (hasRight ? PlotPane::kValueWidth : 0);
    const double width = std::max(40.0, std::floor((size.width() - kRight) / columns_ - beside));
    const double lanes = kLaneHeight + static_cast<double>(lanes_.size()) * (kLaneHeight + kLaneGap);
    int most = 0;  // plots per column
    for (int column = 0; column < columns_; ++column) {
        most = std::max(most, static_cast<int>(std::ranges::count(panes_, column, &PlotPane::column)));
    }
    // Hide the lanes if there is not enough space. Otherwise, they would cover the curves.
    const double least = kTop + most * kMinHeight + (most - 1) * kBetween;
    const double below = size.height() - kBottom - kTimeLabels;
    const bool roomy = below - lanes >= least;
    const double bottom = below - (roomy ? lanes : 0);
    for (int column = 0; column < columns_; ++column) {
        double shares = 0;
        int count = 0;
        for (const auto& pane : panes_) {
            shares += pane->column() == column ? pane->share() : 0;
            count += pane->column() == column ? 1 : 0;
        }
        const double heights = std::max(count * kMinHeight, bottom - kTop - (count - 1) * kBetween);
        const double left = kLeft + column * (width + beside);
        double top = kTop;
        for (const auto& pane : panes_) {
            if (pane->column() == column) {
                const double height = --count == 0 ? std::max(kMinHeight, bottom - top)
                                                   : std::round(heights * pane->share() / shares);
                pane->setArea({left, top, width, height});
                top += height + kBetween;
            }
        }
    }
    double top = bottom + kTimeLabels;
    laneItem_->setView({kLeft, top, width, kLaneHeight}, window_.start(), window_.end());
    laneItem_->setVisible(roomy);
    for (const SignalLane& lane : lanes_) {
        top += kLaneHeight + kLaneGap;
        lane.item->setVisible(roomy);
        lane.item->setView({kLeft, top, width, kLaneHeight}, window_.start(), window_.end());
    }
    tickSpan_ = -1;
}

const QRectF& PlotView::areaAt(double x) const {
    const PlotPane* found = panes_.front().get();
    for (const auto& pane : panes_) {
        if (x >= pane->area().left() - kLeft && pane->area().left() > found->area().left()) {
            found = pane.get();
        }
    }
    return found->area();
}

double PlotView::timeAt(double x) const {
    const QRectF& area = areaAt(x);
    return window_.start() + (x - area.left()) / area.width() * window_.span();
}

double PlotView::xAt(double time) const {
    const QRectF& area = panes_.front()->area();
    return area.left() + (time - window_.start()) / window_.span() * area.width();
}

// ---- time

void PlotView::measure() {
    // During an outage, the lane extends beyond the last sample. Live data do not extend a page of
    // recordings.
    const SeriesBuffer& history = store_.live();
    double oldest = showsLive_ ? history.firstTime() : 0;
    double newest = showsLive_ ? std::max(history.lastTime(), lane_.endTime()) : 0;
    bool any = showsLive_ && !history.isEmpty();
    for (const auto& [shown, grid] : grids_) {
        if (shown != &history && !shown->isEmpty()) {
            oldest = any ? std::min(oldest, shown->firstTime()) : shown->firstTime();
            newest = any ? std::max(newest, shown->lastTime()) : shown->lastTime();
            any = true;
        }
    }
    window_.setHistory(oldest, newest);
}

void PlotView::refresh(double seconds) {
    measure();
    sinceShown_ += seconds;
    // A paused view changes only when its oldest samples are dropped from the history.
    const bool isExtended = showsLive_ && shownEnd_ != store_.live().end();
    if (window_.follows() && (isExtended || shownNewest_ != window_.newest()) && isDue()) {
        show(sinceShown_);
    }
}

bool PlotView::isDue() const {
    if (!isVisible() || QWidget::window()->isMinimized()) {
        return false;
    }
    const double columns =
        std::abs(window_.newest() - shownNewest_) / window_.span() * panes_.front()->area().width();
    return sinceShown_ >= kCalmFrame || columns >= kQuickColumns || shownEnd_ <= 0 ||
           shownEnd_ == store_.live().end();  // no new samples: only the lane and the time axis change
}

void PlotView::showEvent(QShowEvent* event) {
    QGraphicsView::showEvent(event);
    measure();
    show(-1);
}

void PlotView::showLike(const PlotView& other, bool page) {
    offsets_ = other.offsets_;
    if (page) {
        setPage(other.page());
    }
    window_ = other.window_;
    measure();
    reference_ = other.reference_;
    cursors_ = other.cursors_;
    for (const auto& pane : panes_) {
        for (const int signal : pane->shown()) {
            pane->setOffset(signal, offsets_.value(signal, 0));
        }
    }
    if (page) {
        for (std::size_t i = 0; i < std::min(panes_.size(), other.panes_.size()); ++i) {
            panes_[i]->showLike(*other.panes_[i]);
        }
        setReadoutSignal(other.readoutSignal_);
    }
    rewind();
}

void PlotView::rewind() {
    show(-1);
    Q_EMIT windowChanged();
}

const ColumnGrid& PlotView::gridOf(const SeriesBuffer& history) const {
    return grids_.at(&history);
}

void PlotView::show(double seconds, HistoryFile::Effort effort) {
    shownEnd_ = store_.live().end();
    shownNewest_ = window_.newest();
    sinceShown_ = 0;
    if (window_.follows()) {
        reference_ = window_.newest();
        constexpr double kAgedEvery = 0.1;
        if ((cursors_[0] || cursors_[1]) && std::abs(reference_ - agedAt_) >= kAgedEvery) {
            agedAt_ = reference_;
            Q_EMIT readoutAged();
        }
    }
    const double t0 = window_.start();
    const double t1 = window_.end();
    // Use columns on a fixed time raster, so that a moving curve does not flicker.
    const QRectF& area = panes_.front()->area();
    const int columns = std::max(1, static_cast<int>(std::ceil(area.width() * devicePixelRatioF())));
    const double width = window_.span() / columns;
    std::map<const SeriesBuffer*, bool> cut;
    bool isSharp = true;
    const auto grids = [&](const SeriesBuffer& history) -> const ColumnGrid& {
        ColumnGrid& grid = grids_[&history];
        if (!std::exchange(cut[&history], true)) {
            const auto cutNow = [&] {
                history.cut(std::floor(t0 / width) * width, width, columns + 1, grid);
            };
            cutNow();
            if (history.isInFile() && !grid.empty()) {
                const std::uint64_t known = history.revision();
                isSharp = !store_.sharpen(history, grid.edges.front() - 1, grid.edges.back() + 1, columns,
                                          effort) &&
                          isSharp;
                if (history.revision() != known) {
                    cutNow();  // cut again with the times of the loaded rows
                }
            }
        }
        return grid;
    };
    for (const auto& pane : panes_) {
        pane->show(grids, t0, t1, seconds);
    }
    laneItem_->setView(laneItem_->area(), t0, t1);
    const QString recording = recordingInFront();
    laneItem_->setSegments(recording.isEmpty()
                               ? lane_.visible(t0, t1, width * 2)
                               : recordedLane(store_, recording, grids(*store_.timesOf(recording))));
    for (const SignalLane& lane : lanes_) {
        lane.item->setView(lane.item->area(), t0, t1);
        lane.item->setSegments(signalSegments(store_, lane.signal, grids(*store_.buffer(lane.signal))));
    }
    placeTicks();
    placeCursors();
    if (!isSharp) {
        sharpen_.start();
    } else {
        sharpen_.stop();
    }
}

void PlotView::showSharp() {
    while (sharpen_.isActive()) {
        show(-1, HistoryFile::Effort::Turn);
    }
}

void PlotView::setTimeAxis(TimeAxis axis, std::function<QDateTime(double)> clock) {
    timeAxis_ = axis;
    clock_ = std::move(clock);
    tickSpan_ = -1;
    placeTicks();
    viewport()->update();
}

void PlotView::placeTicks() {
    // Reference of the labels. The time of day refers to midnight, so that ticks are round numbers. A
    // recording has its own clocks. If the recording lacks the selected clock, the axis shows the time since
    // its start.
    const RecordedClock* recorded = recordedClock();
    const auto controllerTime = [&](double time) {
        return recorded ? recorded->controllerTime(time).value_or(time - recorded->begin())
                        : store_.controllerTime(time);
    };
    double reference = timeAxis_ == TimeAxis::Controller ? window_.end() - controllerTime(window_.end())
                       : recorded                        ? recorded->begin()
                       : timeAxis_ == TimeAxis::Relative ? reference_
                                                         : 0;
    QDateTime midnight;
    if (timeAxis_ == TimeAxis::Clock) {
        constexpr double kMsPerSecond = 1e3;
        constexpr std::int64_t kNsPerMs = 1'000'000;
        QDateTime now;
        if (recorded) {
            const auto utcNs = recorded->utcNs(window_.end());
            now = utcNs ? QDateTime::fromMSecsSinceEpoch(*utcNs / kNsPerMs) : QDateTime();
        } else if (clock_) {
            now = clock_(window_.end());
        }
        if (now.isValid()) {
            midnight = now.date().startOfDay();
            reference = window_.end() - static_cast<double>(midnight.msecsTo(now)) / kMsPerSecond;
        }
    }
    const double end = window_.end() - reference;
    if (tickSpan_ == window_.span() && std::abs(tickEnd_ - end) < 1e-9) {
        return;
    }
    tickSpan_ = window_.span();
    tickEnd_ = end;
    const double start = end - tickSpan_;
    const double width = panes_.front()->area().width();
    const double step = niceTickStep(tickSpan_, width);
    const bool minutes = step >= 60 && timeAxis_ != TimeAxis::Controller;
    const double unit = minutes ? 60 : 1;
    const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step / unit) - 1e-9)));
    const auto label = [&](double value) {
        if (midnight.isValid()) {
            const QDateTime then = midnight.addMSecs(std::llround(value * 1e3));
            return then.toString(step < 1 ? QStringLiteral("HH:mm:ss.zzz") : QStringLiteral("HH:mm:ss"));
        }
        // The clock of the controller may have been restarted within the window.
        const double shown = timeAxis_ == TimeAxis::Controller ? controllerTime(value + reference) : value;
        return format::number(shown / unit, digits) + (minutes ? tr(" min") : tr(" s"));
    };
    std::vector<AxisTick> ticks;
    timeLabels_.clear();
    for (auto i = std::llround(std::ceil(start / step)); i <= std::llround(std::floor(end / step)); ++i) {
        const double value = static_cast<double>(i) * step;
        // Omit labels that would be cut off at the edge.
        const double room = (value - start) / tickSpan_ * width;
        const bool isNow = i == 0 && timeAxis_ == TimeAxis::Relative && !recorded;
        if (isNow || room < 24 || (end - value) / tickSpan_ * width < 24) {
            continue;
        }
        ticks.push_back({value, label(value)});
        timeLabels_ << ticks.back().label;
    }
    for (const auto& pane : panes_) {
        const bool lowest = std::none_of(panes_.begin(), panes_.end(), [&pane](const auto& other) {
            return other->column() == pane->column() && other->area().top() > pane->area().top();
        });
        pane->setTimeTicks(start, end, lowest ? ticks : std::vector<AxisTick>());
    }
}

void PlotView::placeCursors() {
    double top = panes_.front()->area().top();
    double bottom = panes_.front()->area().bottom();
    for (const auto& pane : panes_) {
        top = std::min(top, pane->area().top());
        bottom = std::max(bottom, pane->area().bottom());
    }
    const double pitch = panes_.front()->area().width() + kLeft;
    for (const Cursor which : {Cursor::A, Cursor::B}) {
        const auto& time = cursors_[index(which)];
        const bool inside = time && *time >= window_.start() && *time <= window_.end();
        int column = 0;
        for (CursorItem* item : cursorItems_[index(which)]) {
            item->setVisible(inside);
            if (inside) {
                item->setLine(xAt(*time) + column * pitch, top - 2, bottom);
                item->setActive(hasFocus() && which == active_);
            }
            ++column;
        }
    }
}

void PlotView::setSpan(double seconds) {
    window_.setSpan(seconds);
    rewind();
}

void PlotView::showRange(double from, double to) {
    measure();
    window_.showRange(from, to);
    rewind();
}

void PlotView::fit() {
    measure();
    for (const auto& pane : panes_) {
        pane->releaseValues();
    }
    if (window_.newest() > window_.oldest()) {
        window_.setSpan(window_.newest() - window_.oldest());
    }
    follow();
}

void PlotView::pause() {
    if (window_.follows()) {
        window_.pause();
        rewind();
    }
}

void PlotView::follow() {
    measure();
    window_.follow();
    rewind();
}

void PlotView::scrollBy(double seconds) {
    measure();
    window_.scrollBy(seconds);
    rewind();
}

void PlotView::setCursor(Cursor which, std::optional<double> time) {
    cursors_[index(which)] = time;
    if (time) {
        active_ = which;
    }
    placeCursors();
    Q_EMIT readoutChanged();
}

void PlotView::goTo(double time) {
    if (time < window_.start() || time > window_.end()) {
        const double half = window_.span() / 2;
        showRange(time - half, time + half);
    }
    setCursor(Cursor::A, time);
}

void PlotView::setReadoutSignal(int signal) {
    readoutSignal_ = signal;
    for (const auto& pane : panes_) {
        pane->setEmphasis(signal);
    }
    if (isVisible()) {
        show(0);  // repaint the curves with their new pens, because a paused view draws no frames by itself
    }
    Q_EMIT readoutChanged();
}

double PlotView::noteTime() const {
    const std::optional<double>& cursor = cursors_[index(active_)];
    const bool isShown = cursor && *cursor >= window_.start() && *cursor <= window_.end();
    return isShown ? *cursor : window_.end();
}

QString PlotView::readout() const {
    const auto& a = cursors_[0];
    const auto& b = cursors_[1];
    if (!a && !b) {
        return {};
    }
    const PlotPane* pane = paneOf(readoutSignal_);
    if (pane == nullptr) {
        return a && b ? tr("A–B Δt %1 s").arg(format::number(*b - *a, 3)) : QString();
    }
    const SignalInfo& info = store_.info(readoutSignal_);
    QString name = curveLabel(store_, pane->shown(), readoutSignal_);
    const auto valueText = [&](std::optional<double> value) {
        return value                 ? info.valueText(*value, true)
               : info.unit.isEmpty() ? QStringLiteral("–")
                                     : QStringLiteral("– ") + info.unit;
    };
    if (a && b) {
        const auto va = store_.valueAt(readoutSignal_, *a);
        const auto vb = store_.valueAt(readoutSignal_, *b);
        std::optional<double> difference;
        if (va && vb && !store_.mixesRobots(readoutSignal_, *a, *b)) {
            difference = *vb - *va;
        }
        return tr("A–B Δt %1 s · Δ%2 %3").arg(format::number(*b - *a, 3), name, valueText(difference));
    }
    const double time = a ? *a : *b;
    const RecordedClock* recorded = recordedClock();
    const double zero = recorded ? recorded->begin() : reference_;
    std::optional<double> value = store_.valueAt(readoutSignal_, time);
    if (value) {
        *value -= offsets_.value(readoutSignal_, 0);
    }
    if (offsets_.contains(readoutSignal_)) {
        name = tr("%1 (zeroed)").arg(name);
    }
    return tr("%1 %2 s · %3 %4")
        .arg(a ? QStringLiteral("A") : QStringLiteral("B"), format::number(time - zero, 3), name,
             valueText(value));
}

void PlotView::cycleReadout(int by) {
    const std::vector<int> shown = curvesShown();
    if (shown.empty()) {
        return;
    }
    const auto at = std::find(shown.begin(), shown.end(), readoutSignal_) - shown.begin();
    const auto count = static_cast<std::ptrdiff_t>(shown.size());
    setReadoutSignal(shown[static_cast<std::size_t>((at + by + count) % count)]);
}

void PlotView::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    layOut();
    show(0);
}

void PlotView::changeEvent(QEvent* event) {
    QGraphicsView::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange) {
        for (const auto& pane : panes_) {
            pane->applyTheme();
        }
        if (isVisible()) {
            show(0);  // repaint the curves, because a paused view would otherwise keep its colours
        }
        viewport()->update();
    }
}

void PlotView::drawForeground(QPainter* painter, const QRectF&) {
    if (hasFocus() && QWidget::window()->testAttribute(Qt::WA_KeyboardFocusChange)) {
        painter->setPen(QPen(Theme::current().moving, 2));
        painter->setBrush(Qt::NoBrush);
        painter->drawRoundedRect(QRectF(viewport()->rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
    for (const auto& pane : panes_) {
        QStringList marks;
        const std::vector<int>& shown = pane->shown();
        if (std::any_of(shown.begin(), shown.end(),
                        [this](int signal) { return offsets_.contains(signal); })) {
            marks << zeroText();
        }
        if (pane->isZoomed() && !testAttribute(Qt::WA_DontShowOnScreen)) {
            marks << tr("Fixed scale · double-click the axis to scale automatically");
        }
        drawMark(*painter, *pane, marks.join(QStringLiteral("   ")));
        drawThresholds(*painter, *pane);
    }
    drawMarks(*painter);
    painter->setPen(Theme::current().secondary);
    painter->setFont(textFont(15));
    for (const auto& pane : panes_) {
        if (pane->shown().empty()) {
            painter->drawText(pane->area(), Qt::AlignCenter, tr("Drop signals here"));
        } else if (pane == panes_.front() && store_.live().isEmpty() && !store_.hasRecordings()) {
            painter->drawText(pane->area(), Qt::AlignCenter, tr("No samples yet. Connect to a robot."));
        }
    }
    const Theme& theme = Theme::current();
    if (dropTarget_.pane >= 0 || drag_ == Drag::Frame) {
        painter->setPen(QPen(theme.moving, 2));
        painter->setBrush(theme.movingTint);
        painter->setOpacity(0.5);
        painter->drawRect(drag_ == Drag::Frame ? frameRect() : dropTarget_.mark);
        painter->setOpacity(1);
    }
}

void PlotView::drawMarks(QPainter& painter) const {
    const Theme& theme = Theme::current();
    painter.setFont(textFont(11));
    const QFontMetricsF metrics(painter.font());
    const double pitch = panes_.front()->area().width() + kLeft;
    const auto& all = marks_.marks();
    const QStringList recordings = recordingsShown();
    const auto first = std::lower_bound(all.begin(), all.end(), window_.start(),
                                        [](const PlotMark& mark, double time) { return mark.time < time; });
    for (int column = 0; column < columns_; ++column) {
        double free = 0;  // end of the previous text
        // Clip to the areas of the curves, because only these are repainted when the view moves.
        QRectF curves;
        for (const auto& pane : panes_) {
            curves |= pane->column() == column ? pane->area() : QRectF();
        }
        painter.save();
        painter.setClipRect(curves, Qt::IntersectClip);
        for (auto mark = first; mark != all.end() && mark->time <= window_.end(); ++mark) {
            if (mark->recording.isEmpty() ? !showsLive_ : !recordings.contains(mark->recording)) {
                continue;
            }
            const double x = std::floor(xAt(mark->time) + column * pitch) + 0.5;
            const QColor color = mark->alarm ? theme.alarm : theme.secondary;
            painter.setPen(QPen(color, 1));
            for (const auto& pane : panes_) {
                if (pane->column() == column) {
                    painter.drawLine(QPointF(x, pane->area().top()), QPointF(x, pane->area().bottom() - 1));
                }
            }
            // Draw a flag, and its text if there is enough space.
            const std::array<QPointF, 3> flag = {QPointF(x, kTop), QPointF(x + 7, kTop + 4),
                                                 QPointF(x, kTop + 8)};
            painter.setBrush(color);
            painter.drawPolygon(flag.data(), static_cast<int>(flag.size()));
            const double words = std::min(metrics.horizontalAdvance(mark->text) + 2, 180.0);
            if (x + 9 > free) {
                painter.setPen(mark->alarm ? theme.alarm : theme.text);
                painter.drawText(QRectF(x + 9, kTop, words, metrics.height()),
                                 Qt::AlignLeft | Qt::AlignVCenter,
                                 metrics.elidedText(mark->text, Qt::ElideRight, words));
                free = x + 9 + words + 6;
            }
        }
        painter.restore();
    }
}

void PlotView::drawThresholds(QPainter& painter, const PlotPane& pane) const {
    const Theme& theme = Theme::current();
    for (const Threshold& threshold : marks_.thresholds()) {
        const int signal = store_.find(threshold.key);
        const double y =
            std::floor(pane.yAt(threshold.limit - pane.offset(signal), pane.sideOf(signal))) + 0.5;
        if (!pane.shows(signal) || pane.isHidden(signal) || y < pane.area().top() ||
            y > pane.area().bottom()) {
            continue;
        }
        QPen pen(theme.alarm, 1);
        pen.setDashPattern({5, 4});
        painter.setPen(pen);
        painter.drawLine(QPointF(pane.area().left(), y), QPointF(pane.area().right() - 1, y));
        painter.setFont(textFont(11));
        constexpr double kWords = 14;  // height of the text [px]
        const bool above =
            threshold.above ? y - kWords - 1 >= pane.area().top() : y + kWords + 1 > pane.area().bottom();
        const QRectF words(pane.area().left() + 4, above ? y - kWords - 1 : y + 1, pane.area().width() - 8,
                           kWords);
        painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, marks_.words(threshold));
    }
}

void PlotView::drawMark(QPainter& painter, const PlotPane& pane, const QString& text) const {
    if (text.isEmpty()) {
        return;
    }
    const Theme& theme = Theme::current();
    painter.setFont(textFont(12, QFont::Bold));
    const QRectF& area = pane.area();
    const QFontMetricsF metrics(painter.font());
    const double width = std::min(metrics.horizontalAdvance(text) + 12, area.width());
    const QRectF box(area.right() - width, area.top() + 1, width, metrics.height() + 2);
    painter.setPen(theme.moving);
    painter.setBrush(theme.movingTint);
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(theme.text);
    painter.drawText(box, Qt::AlignCenter, metrics.elidedText(text, Qt::ElideRight, width - 8));
}

PlotPane& PlotView::paneAt(const QPointF& place) const {
    const double left = areaAt(place.x()).left();
    PlotPane* found = nullptr;
    for (const auto& pane : panes_) {
        const bool below = place.y() >= pane->area().top() - PlotPane::kLegendHeight;
        if (pane->area().left() == left && (found == nullptr || below)) {
            found = pane.get();
        }
    }
    return *found;
}

int PlotView::paneIndex(const PlotPane& pane) const {
    return static_cast<int>(
        std::find_if(panes_.begin(), panes_.end(), [&pane](const auto& one) { return one.get() == &pane; }) -
        panes_.begin());
}

PlotPane* PlotView::paneOf(int signal) const {
    const auto found = std::find_if(panes_.begin(), panes_.end(),
                                    [signal](const auto& pane) { return pane->shows(signal); });
    return found == panes_.end() ? nullptr : found->get();
}

std::optional<PlotPane::Side> PlotView::valuesAt(const QPointF& place) const {
    const QRectF& area = areaAt(place.x());
    if (place.x() < area.left()) {
        return PlotPane::Side::Left;
    }
    return place.x() > area.right() && paneAt(place).hasRight() ? std::optional(PlotPane::Side::Right)
                                                                : std::nullopt;
}

std::optional<int> PlotView::legendAt(const QPointF& place) const {
    for (const auto& pane : panes_) {
        if (const auto signal = pane->legendAt(place)) {
            return signal;
        }
    }
    return std::nullopt;
}

std::optional<int> PlotView::laneAt(const QPointF& place) const {
    for (const SignalLane& lane : lanes_) {
        if (lane.item->boundingRect().contains(place)) {
            return lane.signal;
        }
    }
    return std::nullopt;
}

void PlotView::legendClicked(int signal, Qt::KeyboardModifiers modifiers) {
    if ((modifiers & Qt::ControlModifier) != 0) {
        setReadoutSignal(signal);
    } else {
        setHidden(signal, !isHidden(signal));
    }
}

bool PlotView::isHidden(int signal) const {
    const PlotPane* pane = paneOf(signal);
    return pane != nullptr && pane->isHidden(signal);
}

void PlotView::setHidden(int signal, bool hidden) {
    for (const auto& pane : panes_) {
        pane->setHidden(signal, hidden);
    }
    show(-1);
    viewport()->update();
    Q_EMIT pageChanged();
}

void PlotView::zoomValues(PlotPane& pane, std::initializer_list<PlotPane::Side> sides, double factor,
                          double y) {
    for (const PlotPane::Side side : sides) {
        pane.zoomValues(side, factor, y);
    }
    show(0);
    viewport()->update();
}

void PlotView::scaleToCurves(PlotPane& pane) {
    pane.setLimits(PlotPane::Side::Left, std::nullopt);
    pane.setLimits(PlotPane::Side::Right, std::nullopt);
    releaseValues(pane);
}

void PlotView::releaseValues(PlotPane& pane) {
    pane.releaseValues();
    show(-1);
    viewport()->update();
    Q_EMIT pageChanged();  // the limits may have changed
}

std::optional<double> PlotView::meanAtTheEnd(int signal) const {
    constexpr double kSeconds = 0.25;  // long enough to average the noise [s]
    const SeriesBuffer& history = *store_.buffer(signal);
    const double end = window_.end();
    double sum = 0;
    int count = 0;
    for (std::int64_t i = history.lowerBound(end - kSeconds); i < history.end() && history.time(i) <= end;
         ++i) {
        const double value = store_.value(signal, i);
        if (std::isfinite(value)) {
            sum += value;
            ++count;
        }
    }
    return count == 0 ? std::nullopt : std::optional<double>(sum / count);
}

std::vector<int> PlotView::forces() const {
    std::vector<int> all;
    for (int i = 0; i < 3; ++i) {
        all.push_back(store_.find(QStringLiteral("actual_TCP_force_%1").arg(i)));
    }
    return all;
}

bool PlotView::zeroForce() {
    QHash<int, double> offsets;
    for (const int signal : forces()) {
        const auto force = meanAtTheEnd(signal);
        if (!force) {
            return false;
        }
        offsets.insert(signal, *force);
    }
    offsets_ = offsets;
    for (const auto& pane : panes_) {
        for (const int signal : forces()) {
            pane->setOffset(signal, offsets_.value(signal));
        }
    }
    show(-1);
    viewport()->update();
    Q_EMIT readoutChanged();
    Q_EMIT zeroChanged();
    return true;
}

void PlotView::clearZero() {
    if (offsets_.isEmpty()) {
        return;
    }
    offsets_.clear();
    for (const auto& pane : panes_) {
        for (const int signal : forces()) {
            pane->setOffset(signal, 0);
        }
    }
    show(-1);
    viewport()->update();
    Q_EMIT readoutChanged();
    Q_EMIT zeroChanged();
}

QString PlotView::zeroText() const {
    if (offsets_.isEmpty()) {
        return {};
    }
    QStringList parts;
    for (const int signal : forces()) {
        const SignalInfo& info = store_.info(signal);
        parts << info.label + QLatin1Char(' ') + format::signedNumber(offsets_.value(signal), info.digits);
    }
    return tr("Zeroed (offset %1 %2)")
        .arg(parts.join(QStringLiteral(" · ")), store_.info(forces().front()).unit);
}

std::optional<PlotView::Cursor> PlotView::cursorNear(double x) const {
    std::optional<Cursor> found;
    double nearest = kGrab;
    for (const Cursor which : {Cursor::A, Cursor::B}) {
        const auto& time = cursors_[index(which)];
        const double offset = areaAt(x).left() - panes_.front()->area().left();
        if (time && std::abs(xAt(*time) + offset - x) <= nearest) {
            nearest = std::abs(xAt(*time) + offset - x);
            found = which;
        }
    }
    return found;
}

QRectF PlotView::frameRect() const {
    const QRectF& area = paneAt(pressAt_).area();
    return QRectF(pressAt_, lastAt_).normalized().intersected(area);
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() == Qt::MiddleButton && drag_ == Drag::None) {
        pressAt_ = lastAt_ = event->position();
        drag_ = Drag::Pan;
        return;
    }
    if (event->button() != Qt::LeftButton || drag_ != Drag::None) {
        return;
    }
    legendPressed_ = legendAt(event->position());
    if (legendPressed_) {
        drag_ = Drag::Legend;
        return;
    }
    QGraphicsView::mousePressEvent(event);
    event->accept();
    if (scene()->mouseGrabberItem() != nullptr) {
        return;
    }
    pressAt_ = lastAt_ = event->position();
    if ((event->modifiers() & Qt::ShiftModifier) != 0 && paneAt(pressAt_).area().contains(pressAt_)) {
        drag_ = Drag::Frame;
        return;
    }
    drag_ = Drag::Undecided;
    if (const auto near = cursorNear(pressAt_.x())) {
        drag_ = Drag::Cursor;
        active_ = *near;
        placeCursors();
    }
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    event->accept();
    const QPointF at = event->position();
    if (drag_ == Drag::Undecided && (at - pressAt_).manhattanLength() >= QApplication::startDragDistance()) {
        drag_ = Drag::Pan;
        lastAt_ = pressAt_;
    }
    if (drag_ == Drag::Cursor) {
        const QRectF& area = areaAt(pressAt_.x());
        setCursor(active_, window_.start() + (std::clamp(at.x(), area.left(), area.right()) - area.left()) /
                                                 area.width() * window_.span());
    } else if (drag_ == Drag::Pan) {
        const double seconds = (lastAt_.x() - at.x()) / panes_.front()->area().width() * window_.span();
        lastAt_ = at;
        scrollBy(seconds);
    } else if (drag_ == Drag::Frame) {
        lastAt_ = at;
        viewport()->update();
    }
    const bool overCursor = drag_ == Drag::Cursor || (drag_ == Drag::None && cursorNear(at.x()));
    const bool overLegend = drag_ == Drag::Legend || (drag_ == Drag::None && legendAt(at));
    viewport()->setCursor(overCursor             ? Qt::SplitHCursor
                          : drag_ == Drag::Pan   ? Qt::ClosedHandCursor
                          : drag_ == Drag::Frame ? Qt::CrossCursor
                          : overLegend           ? Qt::PointingHandCursor
                                                 : Qt::ArrowCursor);
}

void PlotView::mouseReleaseEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() == Qt::MiddleButton && drag_ == Drag::Pan) {
        drag_ = Drag::None;
        viewport()->setCursor(Qt::ArrowCursor);
        return;
    }
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (drag_ == Drag::Legend) {
        if (legendAt(event->position()) == legendPressed_) {
            legendClicked(*legendPressed_, event->modifiers());
        }
    } else if (drag_ == Drag::Frame) {
        lastAt_ = event->position();
        const QRectF frame = frameRect();
        PlotPane& pane = paneAt(pressAt_);
        drag_ = Drag::None;
        if (frame.width() >= QApplication::startDragDistance() &&
            frame.height() >= QApplication::startDragDistance()) {
            pane.holdBetween(frame.bottom(), frame.top());
            showRange(timeAt(frame.left()), timeAt(frame.right()));
        }
        viewport()->update();
    } else {
        QGraphicsView::mouseReleaseEvent(event);
        event->accept();
    }
    if (drag_ == Drag::Undecided) {
        cursorsBefore_ = cursors_;
        click(event->position());
    }
    drag_ = Drag::None;
    viewport()->setCursor(Qt::ArrowCursor);
}

void PlotView::mouseDoubleClickEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (event->button() != Qt::LeftButton || legendAt(at)) {
        // Treat the second press of the double click as a single press.
        mousePressEvent(event);
        return;
    }
    event->accept();
    if (const auto side = valuesAt(at)) {
        paneAt(at).setLimits(*side, std::nullopt);
        releaseValues(paneAt(at));
        return;
    }
    if (paneAt(at).area().contains(at)) {
        // Revert the cursor position that the first click has set.
        cursors_ = cursorsBefore_;
        Q_EMIT readoutChanged();
        fit();
    }
}

void PlotView::click(const QPointF& point) {
    if (!paneAt(point).area().contains(point)) {
        return;
    }
    if (const PlotPane& pane = paneAt(point); !pane.shown().empty() && !pane.shows(readoutSignal_)) {
        setReadoutSignal(pane.shown().back());
    }
    const double time = timeAt(point.x());
    // The first click places cursor A, and the second click places cursor B. Further clicks move the nearest
    // cursor. A cursor that was placed in the data of another page counts as not placed.
    const auto isPlaced = [this](Cursor cursor) {
        const std::optional<double>& at = cursors_[index(cursor)];
        return at && *at >= window_.oldest() && *at <= window_.newest();
    };
    Cursor which = Cursor::A;
    if (isPlaced(Cursor::A) && !isPlaced(Cursor::B)) {
        which = Cursor::B;
    } else if (isPlaced(Cursor::A)) {
        which = std::abs(*cursors_[1] - time) < std::abs(*cursors_[0] - time) ? Cursor::B : Cursor::A;
    }
    setCursor(which, time);
}

void PlotView::wheelEvent(QWheelEvent* event) {
    event->accept();
    const QPoint angle = event->angleDelta();
    const bool sideways = std::abs(angle.x()) > std::abs(angle.y());
    if (sideways || (event->modifiers() & Qt::ShiftModifier) != 0) {
        const int turned = sideways ? angle.x() : angle.y();
        scrollBy(-turned / 120.0 * window_.span() / 10);
        return;
    }
    const double factor = std::pow(kZoomPerNotch, angle.y() / 120.0);
    const QPointF at = event->position();
    if (const auto side = valuesAt(at)) {
        zoomValues(paneAt(at), {*side}, factor, at.y());
        return;
    }
    if ((event->modifiers() & Qt::ControlModifier) != 0) {
        zoomValues(paneAt(at), {PlotPane::Side::Left, PlotPane::Side::Right}, factor, at.y());
        return;
    }
    window_.zoom(factor, timeAt(at.x()));
    rewind();
}

// ---- drag and drop, menu

PlotView::Target PlotView::targetAt(const QPointF& place) const {
    constexpr double kEdge = 0.2;  // [fraction of the plot's height and width]
    PlotPane& pane = paneAt(place);
    const QRectF& area = pane.area();
    Target target{paneIndex(pane), Place::Into, area};
    const double down = (place.y() - area.top()) / area.height();
    const double along = (place.x() - area.left()) / area.width();
    if (pane.shown().empty()) {
        return target;
    }
    if (along > 1 - kEdge / 2 && columns_ < PlotLayout::kMaxColumns) {
        target.place = Place::Beside;
        target.mark.setLeft(area.center().x());
    } else if (down > 1 - kEdge) {
        target.place = Place::Below;
        target.mark.setTop(area.center().y());
    } else if (down < kEdge) {
        target.place = Place::Above;
        target.mark.setBottom(area.center().y());
    }
    return target;
}

void PlotView::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(QLatin1String(SignalTree::kMime))) {
        event->acceptProposedAction();
    }
}

void PlotView::dragMoveEvent(QDragMoveEvent* event) {
    if (event->mimeData()->hasFormat(QLatin1String(SignalTree::kMime))) {
        dropTarget_ = targetAt(event->position());
        viewport()->update();
        event->acceptProposedAction();
    }
}

void PlotView::dragLeaveEvent(QDragLeaveEvent* event) {
    dropTarget_ = {};
    viewport()->update();
    event->accept();
}

void PlotView::dropEvent(QDropEvent* event) {
    const Target target = targetAt(event->position());
    dropTarget_ = {};
    viewport()->update();
    const QStringList keys = SignalTree::keysIn(event->mimeData());
    if (!keys.isEmpty()) {
        addSignals(keys, target.pane, target.place);
        event->acceptProposedAction();
    }
}

void PlotView::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
    QPointF place = event->pos();
    if (event->reason() == QContextMenuEvent::Keyboard) {
        const PlotPane* pane = paneOf(readoutSignal_);
        place = (pane == nullptr ? *panes_.front() : *pane).area().center();
    }
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("plots.menu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    PlotMenu(*this, store_).fill(*menu, place);
    menu->popup(viewport()->mapToGlobal(place.toPoint()));
}

// ---- keys

bool PlotView::moveActiveCursor(int pixels) {
    const auto& time = cursors_[index(active_)];
    if (!time) {
        return false;
    }
    const double moved = *time + pixels * window_.span() / panes_.front()->area().width();
    setCursor(active_, std::clamp(moved, window_.start(), window_.end()));
    return true;
}

bool PlotView::keyWithControl(int key) {
    PlotPane* const shown = paneOf(readoutSignal_);
    PlotPane& pane = shown == nullptr ? *panes_.front() : *shown;
    switch (key) {
        case Qt::Key_Delete:
            if (shown != nullptr) {
                removeSignal(paneIndex(pane), readoutSignal_);
            }
            return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            zoomValues(pane, {PlotPane::Side::Left, PlotPane::Side::Right}, kZoomPerNotch,
                       pane.area().center().y());
            return true;
        case Qt::Key_Minus:
            zoomValues(pane, {PlotPane::Side::Left, PlotPane::Side::Right}, 1 / kZoomPerNotch,
                       pane.area().center().y());
            return true;
        case Qt::Key_0:
            releaseValues(pane);
            return true;
        default:
            return false;
    }
}

void PlotView::keyPressEvent(QKeyEvent* event) {
    if ((event->modifiers() & Qt::ControlModifier) != 0 && keyWithControl(event->key())) {
        event->accept();
        return;
    }
    const double middle = window_.end() - window_.span() / 2;
    const int pixels = (event->modifiers() & Qt::ShiftModifier) != 0 ? kCoarseStep : 1;
    switch (event->key()) {
        case Qt::Key_A:
            setCursor(Cursor::A, cursors_[0].value_or(middle));
            break;
        case Qt::Key_B:
            setCursor(Cursor::B, cursors_[1].value_or(middle));
            break;
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            setCursor(active_, std::nullopt);
            active_ = cursors_[0] ? Cursor::A : Cursor::B;
            placeCursors();
            break;
        case Qt::Key_Left:
        case Qt::Key_Right: {
            const int sign = event->key() == Qt::Key_Left ? -1 : 1;
            if (!moveActiveCursor(sign * pixels)) {
                scrollBy(sign * window_.span() / 20);
            }
            break;
        }
        case Qt::Key_F:
            fit();
            break;
        case Qt::Key_N:
            Q_EMIT noteWanted(noteTime());
            break;
        case Qt::Key_H:
            setHidden(readoutSignal_, !isHidden(readoutSignal_));
            break;
        case Qt::Key_Up:
            cycleReadout(-1);
            break;
        case Qt::Key_Down:
            cycleReadout(1);
            break;
        case Qt::Key_PageUp:
            scrollBy(-window_.span() / 2);
            break;
        case Qt::Key_PageDown:
            scrollBy(window_.span() / 2);
            break;
        case Qt::Key_Home:
            scrollBy(window_.oldest() - window_.newest());
            break;
        case Qt::Key_End:
            follow();
            break;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            window_.zoom(kZoomPerNotch, middle);
            rewind();
            break;
        case Qt::Key_Minus:
            window_.zoom(1 / kZoomPerNotch, middle);
            rewind();
            break;
        default:
            event->ignore();
            return;
    }
    event->accept();
}

}  // namespace tiller

#include "moc_plot_view.cpp"
