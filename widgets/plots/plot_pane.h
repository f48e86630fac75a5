// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One of the stacked plots: a chart that draws axes, legend and frame, and our own curves inside it.

#include <QRectF>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "robot/station/history/series_buffer.h"
#include "widgets/plots/axis_range.h"

class QGraphicsItem;
class QGraphicsScene;

QT_BEGIN_NAMESPACE
class QChart;
class QLineSeries;
class QValueAxis;
QT_END_NAMESPACE

namespace tiller {

class AxisLabels;
class Curve;
class CurveSheet;
class SignalStore;

/// A tick of an axis.
struct AxisTick {
    double value;
    QString label;
};

/// How the samples of one history fall into the pixel columns of the view.
using GridOf = std::function<const ColumnGrid&(const SeriesBuffer&)>;

class PlotPane {
public:
    /// shown  none at all for a plot that waits for its first signal
    PlotPane(QGraphicsScene& scene, const SignalStore& store, std::vector<int> shown);
    ~PlotPane();
    PlotPane(const PlotPane&) = delete;
    PlotPane& operator=(const PlotPane&) = delete;

    /// area  where the curves are, in scene coordinates; labels are drawn around it
    void setArea(const QRectF& area);
    const QRectF& area() const { return area_; }
    void applyTheme();

    // Where it stands in the view.
    int column() const { return column_; }
    void setColumn(int column) { column_ = column; }
    double share() const { return share_; }  ///< of the height of its column, beside the others'
    void setShare(double share) { share_ = share; }

    /// Labels under the plot; empty for the upper ones of a stack.
    void setTimeTicks(double from, double to, const std::vector<AxisTick>& ticks);
    /// Shows t0 ... t1, cut into columns by the grids.
    /// seconds  since the last call, for the calm of the scale; negative: take the best scale at once
    void show(const GridOf& grids, double t0, double t1, double seconds);

    const AxisRange& range() const { return range_; }
    const std::vector<std::unique_ptr<Curve>>& curves() const { return curves_; }
    const CurveSheet& sheet() const { return *sheet_; }
    const std::vector<int>& shown() const { return shown_; }
    bool shows(int signal) const { return indexOf(signal) < shown_.size(); }
    /// What the values are counted in, where all of them agree.
    QString unit() const;
    /// The signal whose values the cursors read is drawn stronger.
    void setEmphasis(int signal);

    /// A hidden curve has a struck-out name and no part in the scale.
    void setHidden(int signal, bool hidden);
    bool isHidden(int signal) const;
    /// The entry of the legend at this place of the scene.
    std::optional<int> legendAt(const QPointF& place) const;
    /// Where an entry is, in the scene; empty before the chart is laid out.
    QRectF legendEntry(int signal) const;

    /// What is taken off a signal before it is drawn; 0 at first.
    void setOffset(int signal, double offset);
    double offset(int signal) const;

    /// Comes nearer (factor < 1) to the value at this height of the scene, until the scale is released.
    void zoomValues(double factor, double y);
    /// Shows these values and no others, until the scale is released.
    void holdValues(double low, double high);
    double valueAt(double y) const;
    double yAt(double value) const;
    /// The curves decide about the scale again, with the next show().
    void releaseValues() { range_.release(); }
    bool isZoomed() const { return range_.isHeld(); }

    /// Hides, takes off and zooms as another pane of the same signals does.
    void showLike(const PlotPane& other);

    static constexpr int kLegendHeight = 20;  ///< above the area [px]

private:
    std::size_t indexOf(int signal) const;
    std::vector<QGraphicsItem*> legendEntries() const;
    void updateValueAxis();
    void placeLegend();

    const SignalStore& store_;
    std::vector<int> shown_;
    int column_ = 0;
    double share_ = 1;
    std::unique_ptr<QChart> chart_;
    QValueAxis* grid_;  // the lines
    AxisLabels* values_;
    AxisLabels* times_;
    std::vector<QLineSeries*> legend_;  // without points: the chart's legend wants a series for each entry
    std::vector<std::unique_ptr<Curve>> curves_;
    CurveSheet* sheet_;
    AxisRange range_;
    QRectF area_;
    int emphasis_;
};

}  // namespace tiller
