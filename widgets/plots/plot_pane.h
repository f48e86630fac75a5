// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One of the stacked plots: a chart that draws axes, legend and frame, and our own curves inside it.

#include <QRectF>
#include <QString>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "widgets/plots/axis_range.h"
#include "widgets/plots/plot_signals.h"
#include "widgets/plots/series_buffer.h"

class QGraphicsItem;
class QGraphicsScene;

QT_BEGIN_NAMESPACE
class QCategoryAxis;
class QChart;
class QLineSeries;
class QValueAxis;
QT_END_NAMESPACE

namespace tiller {

class CurveItem;

/// A tick of an axis.
struct AxisTick {
    double value;
    QString label;
};

class PlotPane {
public:
    /// smallestStep  finest grid of the vertical axis, in the signals' unit
    PlotPane(QGraphicsScene& scene, const QString& name, std::span<const PlotSignal> shown,
             double smallestStep);
    ~PlotPane();

    /// area  where the curves are, in scene coordinates; labels are drawn around it
    void setArea(const QRectF& area);
    const QRectF& area() const { return area_; }
    void applyTheme();

    /// Labels under the plot; empty for the upper ones of a stack.
    void setTimeTicks(double from, double to, const std::vector<AxisTick>& ticks);
    /// Shows t0 ... t1, cut into columns by the grid.
    /// seconds  since the last call, for the calm of the scale; negative: take the best scale at once
    void show(const SeriesBuffer& history, const ColumnGrid& grid, double t0, double t1, double seconds);

    const AxisRange& range() const { return range_; }
    const std::vector<CurveItem*>& curves() const { return curves_; }
    std::span<const PlotSignal> shown() const { return shown_; }
    /// The signal whose values the cursors read is drawn stronger.
    void setEmphasis(PlotSignal signal);

    /// A hidden curve has a struck-out name and no part in the scale.
    void setHidden(PlotSignal signal, bool hidden);
    bool isHidden(PlotSignal signal) const;
    /// The entry of the legend at this place of the scene.
    std::optional<PlotSignal> legendAt(const QPointF& place) const;
    /// Where an entry is, in the scene; empty before the chart is laid out.
    QRectF legendEntry(PlotSignal signal) const;

    /// What is taken off a signal before it is drawn; 0 at first.
    void setOffset(PlotSignal signal, double offset);
    double offset(PlotSignal signal) const;

    /// Comes nearer (factor < 1) to the value at this height of the scene, until the scale is released.
    void zoomValues(double factor, double y);
    /// The curves decide about the scale again, with the next show().
    void releaseValues() { range_.release(); }
    bool isZoomed() const { return range_.isHeld(); }

    /// Hides, takes off and zooms as another pane of the same signals does.
    void showLike(const PlotPane& other);

    static constexpr int kLegendHeight = 20;  ///< above the area [px]

private:
    struct Look {
        bool hidden = false;
        double offset = 0;
    };
    std::size_t indexOf(PlotSignal signal) const;
    std::vector<QGraphicsItem*> legendEntries() const;
    void updateValueAxis();
    void placeLegend();

    std::span<const PlotSignal> shown_;
    std::unique_ptr<QChart> chart_;
    QValueAxis* grid_;       // the lines
    QCategoryAxis* values_;  // their labels: only this axis takes texts, but it draws lines at its ends too
    QCategoryAxis* times_;
    std::vector<QLineSeries*> legend_;  // without points: the chart's legend wants a series for each entry
    std::vector<CurveItem*> curves_;
    std::vector<Look> looks_;  // of the curves
    AxisRange range_;
    QRectF area_;
    PlotSignal emphasis_;
};

}  // namespace tiller
