// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_pane.h"

#include <QChart>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QGraphicsTextItem>
#include <QLegend>
#include <QLegendMarker>
#include <QLineSeries>
#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/station/history/signal_store.h"
#include "robot/station/text/format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/axis_labels.h"
#include "widgets/plots/curve.h"
#include "widgets/plots/curve_look.h"
#include "widgets/plots/curve_raster.h"
#include "widgets/plots/grid_lines.h"

namespace tiller {

namespace {

constexpr int kLabelPixels = 13;
constexpr int kLegendPixels = 12;
constexpr double kPixelsPerLine = 28;
// Boxes of the labels [px]. A longer text extends beyond its box without being cut off.
constexpr double kLabelWidth = 80;
constexpr double kLabelHeight = 18;
constexpr double kMinPitch = 14;
constexpr double kTimeGap = 3;
constexpr double kValueGap = 6;
constexpr double kValueWidth = 48;  // the margin of the view is 56 px wide
constexpr double kUnitGap = 8;
constexpr double kUnitLine = 14;

/// Returns the finest grid step suitable for all signals.
double finestStep(const SignalStore& store, const std::vector<int>& shown) {
    double step = shown.empty() ? 0.5 : store.info(shown.front()).step;
    for (const int signal : shown) {
        step = std::min(step, store.info(signal).step);
    }
    return step;
}

/// Returns the labels of the value axis, all of them complete or marked with "…". The last number is followed
/// by the unit, which is an additional text if there is no space for it.
QStringList valueTexts(const std::vector<double>& values, double step, const QString& unit) {
    const QFontMetricsF metrics(textFont(kLabelPixels));
    const double room = PlotPane::kValueWidth - kValueGap;
    const auto fits = [&](const QString& text) { return metrics.horizontalAdvance(text) <= room; };
    const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    QStringList texts;
    for (const double value : values) {
        texts << format::number(value, digits);
    }
    if (!std::all_of(texts.begin(), texts.end(), fits)) {
        QStringList shorter;
        for (const double value : values) {
            // Use enough significant digits to distinguish the value from its neighbours.
            const double steps = std::round(value / step);
            const int significant = 2 + static_cast<int>(std::log10(std::max(1.0, std::abs(steps))) + 1e-9);
            shorter << format::exponential(steps == 0 ? 0 : value, significant);
        }
        if (std::all_of(shorter.begin(), shorter.end(), fits)) {
            texts = shorter;
        }
    }
    for (QString& text : texts) {
        text = metrics.elidedText(text, Qt::ElideLeft, room);
    }
    if (!texts.isEmpty() && !unit.isEmpty()) {
        const QString whole = texts.back() + QLatin1Char(' ') + unit;
        if (fits(whole)) {
            texts.back() = whole;
        } else {
            texts << metrics.elidedText(unit, Qt::ElideRight, room);
        }
    }
    return texts;
}

QPen styled(QPen pen, const CurveStyle& style) {
    if (style.color.isValid()) {
        pen.setColor(style.color);
    }
    switch (style.line) {
        case CurveStyle::Line::Automatic:
            break;
        case CurveStyle::Line::Solid:
            pen.setStyle(Qt::SolidLine);
            break;
        case CurveStyle::Line::Dashed:
            pen.setDashPattern({6, 3});
            break;
        case CurveStyle::Line::Dotted:
            pen.setDashPattern({2, 3});
            break;
    }
    return pen;
}

}  // namespace

PlotPane::PlotPane(QGraphicsScene& scene, const SignalStore& store, std::vector<int> shown)
    : store_(store)
    , shown_(std::move(shown))
    , chart_(std::make_unique<QChart>())
    , grid_(new GridLines(chart_.get()))
    , times_(new AxisLabels(Qt::AlignHCenter | Qt::AlignTop, chart_.get()))
    , styles_(shown_.size())
    , axes_{{{AxisRange(finestStep(store, shown_)),
              new AxisLabels(Qt::AlignRight | Qt::AlignVCenter, chart_.get()),
              new CurveRaster(curves_, chart_.get())},
             {AxisRange(finestStep(store, shown_)),
              new AxisLabels(Qt::AlignLeft | Qt::AlignVCenter, chart_.get()),
              new CurveRaster(curves_, chart_.get(), true)}}}
    , emphasis_(shown_.empty() ? -1 : shown_.back()) {
    chart_->setObjectName(QStringLiteral("plots.pane"));
    chart_->setBackgroundVisible(false);
    chart_->setMargins({});
    chart_->layout()->setContentsMargins(0, 0, 0, 0);
    chart_->setAcceptedMouseButtons(Qt::NoButton);
    chart_->setAcceptHoverEvents(false);
    for (const int signal : shown_) {
        auto* series = new QLineSeries(chart_.get());
        series->setName(curveLabel(store_, shown_, signal));
        chart_->addSeries(series);
        legend_.push_back(series);
        curves_.push_back(std::make_unique<Curve>(
            signal, store_.isDerived(signal) ? Curve::Missing::Undefined : Curve::Missing::Bridged));
    }
    for (const ValueAxis& axis : axes_) {
        axis.sheet->setZValue(10);
    }
    chart_->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    chart_->legend()->detachFromChart();
    chart_->legend()->setBackgroundVisible(false);
    // The legend extends into the plot and must not receive clicks, so legendAt() finds the entry of a click.
    chart_->legend()->setAcceptedMouseButtons(Qt::NoButton);
    scene.addItem(chart_.get());
    applyTheme();
    updateValueAxis();
}

PlotPane::~PlotPane() = default;

void PlotPane::applyTheme() {
    const Theme& theme = Theme::current();
    for (const ValueAxis& axis : axes_) {
        axis.labels->setLook(textFont(kLabelPixels), theme.secondary);
    }
    times_->setLook(textFont(kLegendPixels), theme.secondary);
    // Use a grid colour halfway between surface and border, so that the lines are not prominent.
    grid_->setColor(QColor((theme.panel.red() + theme.border.red()) / 2,
                           (theme.panel.green() + theme.border.green()) / 2,
                           (theme.panel.blue() + theme.border.blue()) / 2));
    chart_->legend()->setFont(textFont(kLegendPixels));
    chart_->legend()->setLabelColor(theme.secondary);
    const auto markers = chart_->legend()->markers();
    const std::vector<QPen> pens = curvePens(store_, shown_, theme);
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        QPen pen = styled(pens[i], styles_[i]);
        const QString label = curveLabel(store_, shown_, shown_[i]);
        legend_[i]->setName(styles_[i].right ? tr("%1 (right)").arg(label) : label);
        const bool hidden = !curves_[i]->isVisible();
        legend_[i]->setPen(hidden ? QPen(theme.border, pen.widthF()) : pen);
        // Set the font of each entry, because the legend passes its font to the entries only when the font
        // changes.
        if (const auto at = static_cast<qsizetype>(i); at < markers.size()) {
            QFont font = textFont(kLegendPixels);
            font.setStrikeOut(hidden);
            if (markers[at]->font() != font) {
                markers[at]->setFont(font);
            }
            markers[at]->setLabelBrush(hidden ? theme.disabledText : theme.secondary);
        }
        if (shown_[i] == emphasis_) {
            pen.setWidthF(2.2);
        }
        curves_[i]->setPen(pen);
    }
    for (const ValueAxis& axis : axes_) {
        axis.sheet->forget();
    }
    placeLegend();
}

void PlotPane::setEmphasis(int signal) {
    emphasis_ = signal;
    applyTheme();
}

std::size_t PlotPane::indexOf(int signal) const {
    return static_cast<std::size_t>(std::find(shown_.begin(), shown_.end(), signal) - shown_.begin());
}

void PlotPane::setHidden(int signal, bool hidden) {
    if (const std::size_t i = indexOf(signal); i < curves_.size() && curves_[i]->isVisible() == hidden) {
        curves_[i]->setVisible(!hidden);
        applyTheme();
    }
}

bool PlotPane::isHidden(int signal) const {
    const std::size_t i = indexOf(signal);
    return i < curves_.size() && !curves_[i]->isVisible();
}

void PlotPane::setStyle(int signal, const CurveStyle& style) {
    if (const std::size_t i = indexOf(signal); i < curves_.size() && styles_[i] != style) {
        styles_[i] = style;
        curves_[i]->setRight(style.right);
        applyTheme();
        updateValueAxis();
    }
}

CurveStyle PlotPane::style(int signal) const {
    const std::size_t i = indexOf(signal);
    return i < styles_.size() ? styles_[i] : CurveStyle();
}

bool PlotPane::hasRight() const {
    return std::any_of(styles_.begin(), styles_.end(), [](const CurveStyle& style) { return style.right; });
}

PlotPane::Side PlotPane::sideOf(int signal) const {
    return style(signal).right ? Side::Right : Side::Left;
}

void PlotPane::setOffset(int signal, double offset) {
    if (const std::size_t i = indexOf(signal); i < curves_.size()) {
        curves_[i]->setOffset(offset);
    }
}

double PlotPane::offset(int signal) const {
    const std::size_t i = indexOf(signal);
    return i < curves_.size() ? curves_[i]->offset() : 0;
}

// QChart does not expose the positions of its legend entries. An entry is an item with a text child. Sorted
// by position, the entries have the order of the signals.
std::vector<QGraphicsItem*> PlotPane::legendEntries() const {
    std::vector<QGraphicsItem*> entries;
    std::vector<QGraphicsItem*> open{chart_->legend()};
    while (!open.empty()) {
        QGraphicsItem* item = open.back();
        open.pop_back();
        const QList<QGraphicsItem*> children = item->childItems();
        const bool isEntry = std::any_of(children.begin(), children.end(), [](const QGraphicsItem* child) {
            return qgraphicsitem_cast<const QGraphicsTextItem*>(child) != nullptr;
        });
        if (isEntry) {
            entries.push_back(item);
        } else {
            open.insert(open.end(), children.begin(), children.end());
        }
    }
    std::sort(entries.begin(), entries.end(), [](const QGraphicsItem* a, const QGraphicsItem* b) {
        const QPointF at = a->scenePos();
        const QPointF to = b->scenePos();
        return std::abs(at.y() - to.y()) > 2 ? at.y() < to.y() : at.x() < to.x();
    });
    return entries.size() == shown_.size() ? entries : std::vector<QGraphicsItem*>();
}

std::optional<int> PlotPane::legendAt(const QPointF& place) const {
    // The margins of the chart place the legend at the upper edge of the plot area. Skip the search for other
    // positions.
    if (std::abs(place.y() - area_.top()) > kLegendHeight) {
        return std::nullopt;
    }
    const std::vector<QGraphicsItem*> entries = legendEntries();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i]->sceneBoundingRect().contains(place)) {
            return shown_[i];
        }
    }
    return std::nullopt;
}

std::optional<int> PlotPane::curveAt(const QPointF& place) const {
    constexpr double kReach = 6;  // [px]
    if (!area_.contains(place)) {
        return std::nullopt;
    }
    std::optional<int> nearest;
    double least = kReach;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        const std::vector<Curve::Column>& columns = curves_[i]->columns();
        if (!curves_[i]->isVisible() || columns.empty()) {
            continue;
        }
        const double share = (place.x() - area_.left()) / area_.width();
        const auto at = static_cast<std::size_t>(share * static_cast<double>(columns.size() - 1));
        const Curve::Column& column = columns[std::min(at, columns.size() - 1)];
        if (column.isEmpty()) {
            continue;
        }
        const Side side = sideOf(shown_[i]);
        const double top = yAt(column.high - curves_[i]->offset(), side);
        const double bottom = yAt(column.low - curves_[i]->offset(), side);
        const double distance = std::max({top - place.y(), place.y() - bottom, 0.0});
        if (distance < least) {
            least = distance;
            nearest = shown_[i];
        }
    }
    return nearest;
}

QRectF PlotPane::legendEntry(int signal) const {
    const std::vector<QGraphicsItem*> entries = legendEntries();
    const std::size_t i = indexOf(signal);
    return i < entries.size() ? entries[i]->sceneBoundingRect() : QRectF();
}

double PlotPane::valueAt(double y, Side side) const {
    const AxisRange& shown = range(side);
    const double share = std::clamp((area_.bottom() - y) / std::max(1.0, area_.height()), 0.0, 1.0);
    return shown.min() + share * (shown.max() - shown.min());
}

double PlotPane::yAt(double value, Side side) const {
    const AxisRange& shown = range(side);
    return area_.bottom() - (value - shown.min()) / (shown.max() - shown.min()) * area_.height();
}

void PlotPane::zoomValues(Side side, double factor, double y) {
    scale(side).zoom(factor, valueAt(y, side));
    updateValueAxis();
}

void PlotPane::holdValues(double low, double high) {
    scale(Side::Left).hold(low, high);
    updateValueAxis();
}

void PlotPane::holdBetween(double bottom, double top) {
    for (const Side side : {Side::Left, Side::Right}) {
        const double low = valueAt(bottom, side);
        scale(side).hold(low, valueAt(top, side));
    }
    updateValueAxis();
}

void PlotPane::setLimits(Side side, const std::optional<ValueLimits>& limits) {
    axes_[index(side)].limits = limits;
    releaseValues();
}

void PlotPane::releaseValues() {
    for (ValueAxis& axis : axes_) {
        if (axis.limits) {
            axis.range.hold(axis.limits->low, axis.limits->high);
        } else {
            axis.range.release();
        }
    }
    updateValueAxis();
}

QString PlotPane::unit() const {
    const QString left = unitOf(Side::Left);
    return !hasRight() || unitOf(Side::Right) == left ? left : QString();
}

QString PlotPane::unitOf(Side side) const {
    QStringList units;
    for (const int signal : shown_) {
        if (sideOf(signal) == side && !units.contains(store_.info(signal).unit)) {
            units << store_.info(signal).unit;
        }
    }
    return units.size() == 1 ? units.front() : QString();
}

void PlotPane::showLike(const PlotPane& other) {
    for (std::size_t i = 0; i < std::min(curves_.size(), other.curves_.size()); ++i) {
        curves_[i]->setVisible(other.curves_[i]->isVisible());
        curves_[i]->setOffset(other.curves_[i]->offset());
    }
    for (const Side side : {Side::Left, Side::Right}) {
        if (other.range(side).isHeld()) {
            scale(side) = other.range(side);
        }
    }
    updateValueAxis();
    applyTheme();
}

void PlotPane::setArea(const QRectF& area) {
    if (area == area_) {
        return;
    }
    area_ = area;
    // The chart covers the space around the plot area, because the labels are drawn there.
    chart_->setGeometry(QRectF(QPointF(0, 0), QSizeF(area.right() + 12 + kValueWidth, area.bottom() + 40)));
    for (ValueAxis& axis : axes_) {
        axis.range.setMostLines(std::clamp(static_cast<int>(area.height() / kPixelsPerLine), 3, 4));
    }
    placeLegend();
    updateValueAxis();
}

void PlotPane::placeLegend() {
    const double width = std::max(0.0, area_.width());
    chart_->legend()->setGeometry(
        QRectF(area_.left() - 12, area_.top() - kLegendHeight, width, kLegendHeight));
}

void PlotPane::setTimeTicks(double from, double to, const std::vector<AxisTick>& ticks) {
    std::vector<AxisLabels::Label> labels;
    for (const AxisTick& tick : ticks) {
        const double x = area_.left() + (tick.value - from) / (to - from) * area_.width();
        labels.push_back(
            {{x - kLabelWidth / 2, area_.bottom() + kTimeGap, kLabelWidth, kLabelHeight}, tick.label});
    }
    times_->setLabels(std::move(labels));
}

void PlotPane::updateValueAxis() {
    const bool onlyRight = hasRight() && std::all_of(styles_.begin(), styles_.end(),
                                                     [](const CurveStyle& style) { return style.right; });
    std::vector<double> left;
    if (onlyRight) {
        axes_[index(Side::Left)].labels->setLabels({});
    } else {
        left = placeLabels(Side::Left);
    }
    std::vector<double> right;
    if (hasRight()) {
        right = placeLabels(Side::Right);
    } else {
        axes_[index(Side::Right)].labels->setLabels({});
    }
    grid_->setLines(area_, onlyRight ? std::move(right) : std::move(left));
}

std::vector<double> PlotPane::placeLabels(Side side) {
    AxisLabels& axisLabels = *axes_[index(side)].labels;
    const AxisRange& shown = range(side);
    std::vector<AxisLabels::Label> labels;
    std::vector<double> lines;
    const double step = shown.step();
    const auto first = std::llround(std::ceil(shown.min() / step));
    const auto last = std::llround(std::floor(shown.max() / step));
    // If the height is too small for all labels, omit some. The uppermost label is always shown.
    const double pitch = step / (shown.max() - shown.min()) * area_.height();
    const auto every = std::max(1LL, static_cast<long long>(std::ceil(kMinPitch / std::max(pitch, 0.1))));
    std::vector<double> values;
    for (auto i = first; i <= last; ++i) {
        lines.push_back(yAt(static_cast<double>(i) * step, side));
        if ((last - i) % every == 0) {
            values.push_back(static_cast<double>(i) * step);
        }
    }
    const double x = side == Side::Left ? area_.left() - kValueGap - kLabelWidth : area_.right() + kValueGap;
    const QStringList texts = valueTexts(values, step, unitOf(side));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double y = yAt(values[i], side);
        labels.push_back(
            {{x, y - kLabelHeight / 2, kLabelWidth, kLabelHeight}, texts[static_cast<qsizetype>(i)]});
    }
    if (!labels.empty() && texts.size() > static_cast<qsizetype>(values.size())) {
        labels.push_back({labels.back().box.translated(0, -kMinPitch), texts.back()});
    }
    axisLabels.setLabels(std::move(labels));
    return lines;
}

void PlotPane::show(const GridOf& grids, double t0, double t1, double seconds) {
    std::array<MinMax, 2> all;
    for (const auto& curve : curves_) {
        // Also sample hidden signals, because all curves must have the same raster.
        if (const SeriesBuffer* history = store_.buffer(curve->signal())) {
            curve->sample(*history, store_.column(curve->signal()), grids(*history));
        }
        if (curve->isVisible() && !curve->range().isEmpty()) {
            all[curve->isRight() ? 1 : 0].add(
                MinMax{curve->range().min - curve->offset(), curve->range().max - curve->offset()});
        }
    }
    bool changed = false;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const MinMax& extent = all[i];
        AxisRange& shown = axes_[i].range;
        changed = (seconds < 0 ? shown.reset(extent.min, extent.max)
                               : shown.fit(extent.min, extent.max, seconds)) ||
                  changed;
    }
    if (changed) {
        updateValueAxis();
    }
    for (const ValueAxis& axis : axes_) {
        axis.sheet->setView(area_, t0, t1, axis.range.min(), axis.range.max());
    }
}

}  // namespace tiller
