// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One plot of a stack. The chart draws the legend. Grid, labels and curves are drawn separately.

#include <QCoreApplication>
#include <QRectF>
#include <QString>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "robot/station/history/series_buffer.h"
#include "widgets/plots/axis_range.h"
#include "widgets/plots/plot_layout.h"

class QGraphicsItem;
class QGraphicsScene;

QT_BEGIN_NAMESPACE
class QChart;
class QLineSeries;
QT_END_NAMESPACE

namespace tiller {

class AxisLabels;
class Curve;
class CurveRaster;
class GridLines;
class SignalStore;

/// A tick of an axis.
struct AxisTick {
    double value;
    QString label;
};

/// Returns the pixel columns of the view for the samples of a history.
using GridOf = std::function<const ColumnGrid&(const SeriesBuffer&)>;

class PlotPane {
    Q_DECLARE_TR_FUNCTIONS(PlotPane)

public:
    enum class Side { Left, Right };  ///< of a value axis

    /// shown  the signals; may be empty
    PlotPane(QGraphicsScene& scene, const SignalStore& store, std::vector<int> shown);
    ~PlotPane();
    PlotPane(const PlotPane&) = delete;
    PlotPane& operator=(const PlotPane&) = delete;

    /// area  area of the curves in scene coordinates; labels are drawn around this area
    void setArea(const QRectF& area);
    const QRectF& area() const { return area_; }
    void applyTheme();

    // Column index in the view.
    int column() const { return column_; }
    void setColumn(int column) { column_ = column; }
    double share() const { return share_; }  ///< height relative to the other plots of its column
    void setShare(double share) { share_ = share; }

    /// Sets the labels below the plot. Only the lowest plot of a column has labels.
    void setTimeTicks(double from, double to, const std::vector<AxisTick>& ticks);
    /// Shows t0 ... t1. The grids divide this range into columns.
    /// seconds  time since the last call, for adapting the scale; if negative, sets the best scale
    /// immediately
    void show(const GridOf& grids, double t0, double t1, double seconds);

    const AxisRange& range(Side side = Side::Left) const { return axes_[index(side)].range; }
    const std::vector<std::unique_ptr<Curve>>& curves() const { return curves_; }
    const CurveRaster& sheet() const { return *axes_[0].sheet; }
    const std::vector<int>& shown() const { return shown_; }
    bool shows(int signal) const { return indexOf(signal) < shown_.size(); }
    /// The common unit of all signals; empty if the units differ.
    QString unit() const;
    /// Sets the appearance of a curve and its axis.
    void setStyle(int signal, const CurveStyle& style);
    CurveStyle style(int signal) const;
    /// True if a curve uses the value axis at the right.
    bool hasRight() const;
    /// Emphasizes the signal whose value is shown at the cursors.
    void setEmphasis(int signal);

    /// Shows or hides a curve. The name of a hidden curve is struck out, and the curve does not affect the
    /// scale.
    void setHidden(int signal, bool hidden);
    bool isHidden(int signal) const;
    /// The signal whose legend entry is at this position in the scene.
    std::optional<int> legendAt(const QPointF& place) const;
    /// The visible signal whose curve is within 6 px of this position in the scene.
    std::optional<int> curveAt(const QPointF& place) const;
    /// Rectangle of a legend entry in the scene; empty before the first layout.
    QRectF legendEntry(int signal) const;

    /// Sets the offset that is subtracted from a signal before drawing. Initially 0.
    void setOffset(int signal, double offset);
    double offset(int signal) const;

    /// Zooms in (factor < 1) around the value at the vertical scene position `y`. The scale is fixed until
    /// releaseValues().
    void zoomValues(Side side, double factor, double y);
    /// Shows this range of values of the left axis until releaseValues().
    void holdValues(double low, double high);
    /// Shows the values of both axes between two vertical scene positions until releaseValues().
    void holdBetween(double bottom, double top);
    double valueAt(double y, Side side = Side::Left) const;
    double yAt(double value, Side side = Side::Left) const;
    /// The axis of a signal.
    Side sideOf(int signal) const;
    /// Sets or removes the limits of an axis. The scale has these limits until it is zoomed, and again after
    /// releaseValues().
    void setLimits(Side side, const std::optional<ValueLimits>& limits);
    const std::optional<ValueLimits>& limits(Side side) const { return axes_[index(side)].limits; }
    /// Restores the limits, or lets the scales follow the curves again from the next show().
    void releaseValues();
    bool isZoomed() const { return range().isHeld() || (hasRight() && range(Side::Right).isHeld()); }

    /// Copies hidden signals, offsets and zoom from a pane with the same signals.
    void showLike(const PlotPane& other);

    static constexpr int kLegendHeight = 20;  ///< height above the area [px]
    static constexpr int kValueWidth = 56;    ///< width of the labels of a value axis [px]

private:
    struct ValueAxis {
        AxisRange range;
        AxisLabels* labels;
        CurveRaster* sheet;
        std::optional<ValueLimits> limits{};
    };
    static std::size_t index(Side side) { return side == Side::Left ? 0 : 1; }
    AxisRange& scale(Side side) { return axes_[index(side)].range; }
    QString unitOf(Side side) const;
    /// Places the labels of an axis and returns the heights of its grid lines.
    std::vector<double> placeLabels(Side side);
    std::size_t indexOf(int signal) const;
    std::vector<QGraphicsItem*> legendEntries() const;
    void updateValueAxis();
    void placeLegend();

    const SignalStore& store_;
    std::vector<int> shown_;
    int column_ = 0;
    double share_ = 1;
    std::unique_ptr<QChart> chart_;
    GridLines* grid_;
    AxisLabels* times_;
    std::vector<QLineSeries*> legend_;  // empty series, one per legend entry
    std::vector<std::unique_ptr<Curve>> curves_;
    std::vector<CurveStyle> styles_;  // by curve
    std::array<ValueAxis, 2> axes_;   // left and right
    QRectF area_;
    int emphasis_;
};

}  // namespace tiller
