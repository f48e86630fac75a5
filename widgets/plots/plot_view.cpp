// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_view.h"

#include <QApplication>
#include <QGraphicsScene>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QResizeEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/common/format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/plot_overlay.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/state_lane.h"

namespace tiller {

namespace {

constexpr double kLeft = 56;  // room for the labels of the vertical axes [px]
constexpr double kRight = 10;
constexpr double kTop = 22;         // the cursors' letters, the legend
constexpr double kBetween = 24;     // two plots: the lower one's legend
constexpr double kTimeLabels = 20;  // under the lowest plot
constexpr double kLaneHeight = 14;
constexpr double kBottom = 10;
constexpr double kUpperShare = 0.54;

double niceTickStep(double span, double width) {
    const double least = span / std::max(1.0, width / 110.0);  // labels want this many pixels each
    static constexpr double kSteps[] = {0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1,   2,   5,
                                        10,    20,   30,   60,   120, 300, 600, 900, 1800};
    for (const double step : kSteps) {
        if (step >= least) {
            return step;
        }
    }
    return 1800;
}

// A curve that goes on by less than this many pixels is drawn anew at most 30 times a second: more is not seen.
constexpr double kQuickColumns = 3;
constexpr double kCalmFrame = 0.03;  // [s]
constexpr double kGrab = 6;          // a cursor is taken hold of within this distance [px]
constexpr double kZoomPerNotch = 0.8;
constexpr int kCoarse = 10;  // arrow keys with Shift

}  // namespace

PlotView::PlotView(const SeriesBuffer& history, const StateLane& lane, QWidget* parent)
    : QGraphicsView(parent)
    , history_(history)
    , lane_(lane)
    , scene_(std::make_unique<QGraphicsScene>())
    , laneItem_(new LaneItem) {
    setObjectName(QStringLiteral("plots.view"));
    setAccessibleName(tr("Plots of TCP force and joint current over time"));
    setAccessibleDescription(tr(
        "A and B place the cursors, the arrow keys move them, up and down choose the signal they read; "
        "H hides its curve; plus and minus change the time window, with Ctrl the scale of the values, Ctrl+0 "
        "lets the curves decide about it again; End goes back to the newest samples"));
    setScene(scene_.get());
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setBackgroundBrush(Qt::NoBrush);
    setStyleSheet(QStringLiteral("background: transparent;"));
    scene_->setItemIndexMethod(QGraphicsScene::NoIndex);
    panes_.push_back(
        std::make_unique<PlotPane>(*scene_, QStringLiteral("force"), plot_signals::tcpForce(), 5));
    panes_.push_back(
        std::make_unique<PlotPane>(*scene_, QStringLiteral("current"), plot_signals::jointCurrent(), 0.5));
    scene_->addItem(laneItem_);
    for (const Cursor which : {Cursor::A, Cursor::B}) {
        auto*& item = cursorItems_[index(which)];
        item = new CursorItem(which == Cursor::A ? QStringLiteral("A") : QStringLiteral("B"));
        item->hide();
        scene_->addItem(item);
    }
    setReadoutSignal(readoutSignal_);
    layOut();
}

PlotView::~PlotView() {
    // The charts are items of the scene and belong to the panes: they must go before it.
    panes_.clear();
    setScene(nullptr);
}

void PlotView::layOut() {
    const QSizeF size = viewport()->size();
    scene_->setSceneRect(QRectF(QPointF(0, 0), size));
    const double width = std::max(40.0, size.width() - kLeft - kRight);
    const double plots =
        std::max(60.0, size.height() - kTop - kBetween - kTimeLabels - kLaneHeight - kBottom);
    const double upper = std::round(plots * kUpperShare);
    panes_[0]->setArea({kLeft, kTop, width, upper});
    panes_[1]->setArea({kLeft, kTop + upper + kBetween, width, plots - upper});
    laneItem_->setView({kLeft, kTop + plots + kBetween + kTimeLabels, width, kLaneHeight}, window_.start(),
                       window_.end());
    tickSpan_ = -1;
}

double PlotView::timeAt(double x) const {
    const QRectF& area = panes_[0]->area();
    return window_.start() + (x - area.left()) / area.width() * window_.span();
}

double PlotView::xAt(double time) const {
    const QRectF& area = panes_[0]->area();
    return area.left() + (time - window_.start()) / window_.span() * area.width();
}

void PlotView::measure() {
    // While no data come the lane goes on alone: the outage is as long as it lasts.
    window_.setHistory(history_.firstTime(), std::max(history_.lastTime(), lane_.endTime()));
}

void PlotView::refresh(double seconds) {
    measure();
    sinceShown_ += seconds;
    // What is frozen stays as it is on the screen; only its oldest samples may fall out of the history.
    if (window_.follows() && (shownEnd_ != history_.end() || shownNewest_ != window_.newest()) && isDue()) {
        show(sinceShown_);
    }
}

bool PlotView::isDue() const {
    if (QWidget::window()->isMinimized()) {
        return false;
    }
    const double columns =
        std::abs(window_.newest() - shownNewest_) / window_.span() * panes_[0]->area().width();
    return sinceShown_ >= kCalmFrame || columns >= kQuickColumns || shownEnd_ <= 0 ||
           shownEnd_ == history_.end();  // an outage: nothing else is drawn
}

void PlotView::showLike(const PlotView& other) {
    window_ = other.window_;
    reference_ = other.reference_;
    cursors_ = other.cursors_;
    forceZeroed_ = other.forceZeroed_;
    for (std::size_t i = 0; i < panes_.size(); ++i) {
        panes_[i]->showLike(*other.panes_[i]);
    }
    setReadoutSignal(other.readoutSignal_);
    rewind();
}

void PlotView::rewind() {
    show(-1);
    Q_EMIT windowChanged();
}

void PlotView::show(double seconds) {
    shownEnd_ = history_.end();
    shownNewest_ = window_.newest();
    sinceShown_ = 0;
    if (window_.follows()) {
        reference_ = window_.newest();
    }
    const double t0 = window_.start();
    const double t1 = window_.end();
    // Columns lie on a fixed raster of time, so that a moving curve moves as a whole and does not shimmer.
    const QRectF& area = panes_[0]->area();
    const int columns = std::max(1, static_cast<int>(std::ceil(area.width() * devicePixelRatioF())));
    const double width = window_.span() / columns;
    history_.cut(std::floor(t0 / width) * width, width, columns + 1, grid_);
    for (const auto& pane : panes_) {
        pane->show(history_, grid_, t0, t1, seconds);
    }
    laneItem_->setView(laneItem_->area(), t0, t1);
    laneItem_->setSegments(lane_.visible(t0, t1, width * 2));
    placeTicks();
    placeCursors();
}

void PlotView::placeTicks() {
    const double end = window_.end() - reference_;
    if (tickSpan_ == window_.span() && std::abs(tickEnd_ - end) < 1e-9) {
        return;
    }
    tickSpan_ = window_.span();
    tickEnd_ = end;
    const double start = end - tickSpan_;
    const double step = niceTickStep(tickSpan_, panes_[0]->area().width());
    const bool minutes = step >= 60;
    const double unit = minutes ? 60 : 1;
    const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step / unit) - 1e-9)));
    std::vector<AxisTick> ticks;
    for (auto i = std::llround(std::ceil(start / step)); i <= std::llround(std::floor(end / step)); ++i) {
        const double value = static_cast<double>(i) * step;
        // A label at the very edge would be cut off.
        const double room = (value - start) / tickSpan_ * panes_[0]->area().width();
        if (i == 0 || room < 24 || (end - value) / tickSpan_ * panes_[0]->area().width() < 24) {
            continue;
        }
        ticks.push_back({value, format::number(value / unit, digits) + (minutes ? tr(" min") : tr(" s"))});
    }
    panes_[0]->setTimeTicks(start, end, {});
    panes_[1]->setTimeTicks(start, end, ticks);
}

void PlotView::placeCursors() {
    const QRectF top = panes_.front()->area();
    const QRectF bottom = panes_.back()->area();
    for (const Cursor which : {Cursor::A, Cursor::B}) {
        CursorItem* item = cursorItems_[index(which)];
        const auto& time = cursors_[index(which)];
        const bool inside = time && *time >= window_.start() && *time <= window_.end();
        item->setVisible(inside);
        if (inside) {
            item->setLine(xAt(*time), top.top() - 2, bottom.bottom());
            item->setActive(hasFocus() && which == active_);
        }
    }
}

void PlotView::setSpan(double seconds) {
    window_.setSpan(seconds);
    rewind();
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

void PlotView::setReadoutSignal(PlotSignal signal) {
    readoutSignal_ = signal;
    for (const auto& pane : panes_) {
        pane->setEmphasis(signal);
    }
    Q_EMIT readoutChanged();
}

std::optional<double> PlotView::valueAt(PlotSignal signal, double time) const {
    // A sample is near enough if the neighbours of this moment are its neighbours: across a gap there is
    // none.
    const std::int64_t after = history_.lowerBound(time);
    const std::int64_t nearest = history_.nearest(time, 0.25);
    if (nearest < 0) {
        return std::nullopt;
    }
    const bool insideGap = after < history_.end() && after > history_.first() && history_.gapBefore(after) &&
                           history_.time(after) != time;
    const bool outside = after == history_.first() && history_.time(after) != time;
    const bool beyond = after == history_.end() && time > history_.lastTime() + 0.05;
    if (insideGap || outside || beyond) {
        return std::nullopt;
    }
    const float value = history_.value(static_cast<int>(signal), nearest);
    return std::isnan(value) ? std::nullopt : std::optional<double>(static_cast<double>(value));
}

QString PlotView::readout() const {
    const auto& a = cursors_[0];
    const auto& b = cursors_[1];
    if (!a && !b) {
        return {};
    }
    QString name = plot_signals::label(readoutSignal_);
    const int digits = plot_signals::digits(readoutSignal_);
    const auto valueText = [&](std::optional<double> value) {
        return (value ? format::signedNumber(*value, digits) : QStringLiteral("–")) + QLatin1Char(' ') +
               plot_signals::unit(readoutSignal_);
    };
    if (a && b) {
        const auto va = valueAt(readoutSignal_, *a);
        const auto vb = valueAt(readoutSignal_, *b);
        std::optional<double> difference;
        if (va && vb) {
            difference = *vb - *va;
        }
        return tr("A–B Δt %1 s · Δ%2 %3").arg(format::number(*b - *a, 3), name, valueText(difference));
    }
    const double time = a ? *a : *b;
    const PlotPane& pane = paneOf(readoutSignal_);
    std::optional<double> value = valueAt(readoutSignal_, time);
    if (value) {
        *value -= pane.offset(readoutSignal_);
    }
    if (forceZeroed_ && &pane == panes_.front().get()) {
        name = tr("%1 (zeroed)").arg(name);
    }
    return tr("%1 %2 s · %3 %4")
        .arg(a ? QStringLiteral("A") : QStringLiteral("B"), format::number(time - reference_, 3), name,
             valueText(value));
}

std::vector<PlotSignal> PlotView::signalsShown() const {
    std::vector<PlotSignal> out;
    for (const auto& pane : panes_) {
        out.insert(out.end(), pane->shown().begin(), pane->shown().end());
    }
    return out;
}

void PlotView::cycleReadout(int by) {
    const std::vector<PlotSignal> shown = signalsShown();
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
        if (pane == panes_.front() && forceZeroed_) {
            marks << zeroText();
        }
        if (pane->isZoomed()) {
            marks << tr("Scale held · double click the axis to let it go");
        }
        drawMark(*painter, *pane, marks.join(QStringLiteral("   ")));
    }
    if (!history_.isEmpty()) {
        return;
    }
    painter->setPen(Theme::current().secondary);
    painter->setFont(textFont(15));
    painter->drawText(panes_[0]->area(), Qt::AlignCenter, tr("No samples yet: connect to a robot"));
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

PlotPane& PlotView::paneAt(double y) const {
    const bool upper = y < panes_.back()->area().top() - PlotPane::kLegendHeight;
    return upper ? *panes_.front() : *panes_.back();
}

PlotPane& PlotView::paneOf(PlotSignal signal) const {
    const auto upper = panes_.front()->shown();
    return std::find(upper.begin(), upper.end(), signal) != upper.end() ? *panes_.front() : *panes_.back();
}

std::optional<PlotSignal> PlotView::legendAt(const QPointF& place) const {
    for (const auto& pane : panes_) {
        if (const auto signal = pane->legendAt(place)) {
            return signal;
        }
    }
    return std::nullopt;
}

void PlotView::legendClicked(PlotSignal signal, Qt::KeyboardModifiers modifiers) {
    if ((modifiers & Qt::ControlModifier) != 0) {
        setReadoutSignal(signal);
    } else {
        setHidden(signal, !isHidden(signal));
    }
}

bool PlotView::isHidden(PlotSignal signal) const {
    return paneOf(signal).isHidden(signal);
}

void PlotView::setHidden(PlotSignal signal, bool hidden) {
    paneOf(signal).setHidden(signal, hidden);
    show(-1);
    viewport()->update();
}

void PlotView::zoomValues(PlotPane& pane, double factor, double y) {
    pane.zoomValues(factor, y);
    show(0);
    viewport()->update();
}

void PlotView::releaseValues(PlotPane& pane) {
    pane.releaseValues();
    show(-1);
    viewport()->update();
}

std::optional<double> PlotView::forceAtTheEnd(PlotSignal signal) const {
    constexpr double kSeconds = 0.25;  // long enough for the noise
    const double end = window_.end();
    double sum = 0;
    int count = 0;
    for (std::int64_t i = history_.lowerBound(end - kSeconds); i < history_.end() && history_.time(i) <= end;
         ++i) {
        const auto value = static_cast<double>(history_.value(static_cast<int>(signal), i));
        if (std::isfinite(value)) {
            sum += value;
            ++count;
        }
    }
    return count == 0 ? std::nullopt : std::optional<double>(sum / count);
}

bool PlotView::zeroForce() {
    PlotPane& pane = *panes_.front();
    std::vector<double> offsets;
    for (const PlotSignal signal : pane.shown()) {
        const auto force = forceAtTheEnd(signal);
        if (!force) {
            return false;
        }
        offsets.push_back(*force);
    }
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        pane.setOffset(pane.shown()[i], offsets[i]);
    }
    forceZeroed_ = true;
    show(-1);
    viewport()->update();
    Q_EMIT readoutChanged();
    Q_EMIT zeroChanged();
    return true;
}

void PlotView::clearZero() {
    if (!forceZeroed_) {
        return;
    }
    for (const PlotSignal signal : panes_.front()->shown()) {
        panes_.front()->setOffset(signal, 0);
    }
    forceZeroed_ = false;
    show(-1);
    viewport()->update();
    Q_EMIT readoutChanged();
    Q_EMIT zeroChanged();
}

QString PlotView::zeroText() const {
    if (!forceZeroed_) {
        return {};
    }
    QStringList parts;
    for (const PlotSignal signal : panes_.front()->shown()) {
        parts << plot_signals::label(signal) + QLatin1Char(' ') +
                     format::signedNumber(panes_.front()->offset(signal), plot_signals::digits(signal));
    }
    return tr("Zeroed: %1 %2 taken off")
        .arg(parts.join(QStringLiteral(" · ")), plot_signals::unit(panes_.front()->shown().front()));
}

std::optional<PlotView::Cursor> PlotView::cursorNear(double x) const {
    std::optional<Cursor> found;
    double nearest = kGrab;
    for (const Cursor which : {Cursor::A, Cursor::B}) {
        const auto& time = cursors_[index(which)];
        if (time && std::abs(xAt(*time) - x) <= nearest) {
            nearest = std::abs(xAt(*time) - x);
            found = which;
        }
    }
    return found;
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() != Qt::LeftButton) {
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
        const QRectF& area = panes_[0]->area();
        setCursor(active_, timeAt(std::clamp(at.x(), area.left(), area.right())));
    } else if (drag_ == Drag::Pan) {
        const double seconds = timeAt(lastAt_.x()) - timeAt(at.x());
        lastAt_ = at;
        scrollBy(seconds);
    }
    const bool overCursor = drag_ == Drag::Cursor || (drag_ == Drag::None && cursorNear(at.x()));
    const bool overLegend = drag_ == Drag::Legend || (drag_ == Drag::None && legendAt(at));
    viewport()->setCursor(overCursor           ? Qt::SplitHCursor
                          : drag_ == Drag::Pan ? Qt::ClosedHandCursor
                          : overLegend         ? Qt::PointingHandCursor
                                               : Qt::ArrowCursor);
}

void PlotView::mouseReleaseEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (drag_ == Drag::Legend) {
        if (legendAt(event->position()) == legendPressed_) {
            legendClicked(*legendPressed_, event->modifiers());
        }
    } else {
        QGraphicsView::mouseReleaseEvent(event);
        event->accept();
    }
    if (drag_ == Drag::Undecided) {
        click(event->position());
    }
    drag_ = Drag::None;
    viewport()->setCursor(Qt::ArrowCursor);
}

void PlotView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && event->position().x() < kLeft && !legendAt(event->position())) {
        event->accept();
        releaseValues(paneAt(event->position().y()));
        return;
    }
    // The second press of a quick pair is a press like any other.
    mousePressEvent(event);
}

void PlotView::click(const QPointF& point) {
    const QRectF area = panes_.front()->area().united(panes_.back()->area());
    if (!area.contains(point)) {
        return;
    }
    const double time = timeAt(point.x());
    // First A, then B, then whichever is nearer.
    Cursor which = Cursor::A;
    if (cursors_[0] && !cursors_[1]) {
        which = Cursor::B;
    } else if (cursors_[0] && cursors_[1]) {
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
    if (at.x() < kLeft || (event->modifiers() & Qt::ControlModifier) != 0) {
        zoomValues(paneAt(at.y()), factor, at.y());
        return;
    }
    window_.zoom(factor, timeAt(at.x()));
    rewind();
}

bool PlotView::moveActiveCursor(int pixels) {
    const auto& time = cursors_[index(active_)];
    if (!time) {
        return false;
    }
    const double moved = *time + pixels * window_.span() / panes_[0]->area().width();
    setCursor(active_, std::clamp(moved, window_.start(), window_.end()));
    return true;
}

bool PlotView::keyWithControl(int key) {
    PlotPane& pane = paneOf(readoutSignal_);
    switch (key) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            zoomValues(pane, kZoomPerNotch, pane.area().center().y());
            return true;
        case Qt::Key_Minus:
            zoomValues(pane, 1 / kZoomPerNotch, pane.area().center().y());
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
    const int pixels = (event->modifiers() & Qt::ShiftModifier) != 0 ? kCoarse : 1;
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
            scrollBy(history_.firstTime() - window_.newest());
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
