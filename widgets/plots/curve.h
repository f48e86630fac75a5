// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One curve, represented by its extent in every pixel column. The extent ranges from minimum to maximum and
// is connected to the neighbouring columns, so the drawing time does not depend on the length of the history.
// CurveRaster renders the columns.

#include <QPainterPath>
#include <QPen>
#include <QRectF>
#include <cmath>
#include <span>
#include <vector>

#include "robot/station/history/series_buffer.h"

namespace tiller {

class Curve {
public:
    /// Extent of the curve in one pixel column, in the unit of the curve. NaN in `left`: no data.
    struct Column {
        double left, right;  ///< values at the left and right edge of the column
        /// Minimum and maximum of the samples in the column, and of the connecting lines to the adjacent
        /// samples up to the edges of the column. Includes `left` and `right`.
        double low, high;

        bool isEmpty() const { return std::isnan(left); }
        void setLeft(double value);   ///< extends the minimum and maximum if necessary
        void setRight(double value);  ///< extends the minimum and maximum if necessary
        friend bool operator==(const Column& a, const Column& b) {
            return (a.isEmpty() && b.isEmpty()) ||
                   (a.left == b.left && a.right == b.right && a.low == b.low && a.high == b.high);
        }
    };

    /// How to draw samples without a value that lie between samples with values.
    enum class Missing {
        Bridged,   ///< draws a line: a field may be sampled less often than others in the same table
        Undefined  ///< draws no line over an interruption: a computed signal has no result there
    };

    explicit Curve(int signal, Missing missing = Missing::Bridged) : signal_(signal), missing_(missing) {}

    int signal() const { return signal_; }
    /// Sets colour, width and dash pattern. Dashes run along the time axis and move with the curve.
    void setPen(const QPen& pen);
    const QPen& pen() const { return pen_; }
    void setVisible(bool visible) { visible_ = visible; }
    bool isVisible() const { return visible_; }
    /// Sets the offset that is subtracted before drawing.
    void setOffset(double offset) { offset_ = offset; }
    double offset() const { return offset_; }
    /// Assigns the curve to the value axis at the right.
    void setRight(bool right) { right_ = right; }
    bool isRight() const { return right_; }

    /// Reads the data for the columns of this grid. Every call must use the same history and the same
    /// `column`.
    void sample(const SeriesBuffer& history, int column, const ColumnGrid& grid);
    /// Minimum and maximum of the finite values that were read.
    const MinMax& range() const { return range_; }
    const std::vector<Column>& columns() const { return columns_; }
    /// Number of the first column on the time raster. Columns with the same width and the same number cover
    /// the same time.
    std::int64_t raster() const { return raster_; }
    double columnWidth() const { return width_; }
    /// True if this column is new or has changed since the last sample().
    bool hasChanged(std::size_t column) const;
    /// Determines the columns to draw: those in the dashes of the pen, and those in which the curve exceeds
    /// the adjacent dashes, so that a gap does not hide a spike.
    /// drawn   one entry per column; 0: not drawn
    /// beyond  minimum excess, in the unit of the curve
    void findDrawn(std::span<std::uint8_t> drawn, double beyond) const;

    /// Returns the curve as a path, for vector graphics.
    QPainterPath path(const QRectF& area, double t0, double t1, double y0, double y1) const;

private:
    void fetchEnvelope(const SeriesBuffer& history, int column, const ColumnGrid& grid);
    void sampleEnvelope(const SeriesBuffer& history, int column, const ColumnGrid& grid);
    void samplePoints(const SeriesBuffer& history, int column, std::int64_t begin, std::int64_t end);
    void addToRange(double value);
    void addLine(double x0, double y0, double x1, double y1);

    /// Returns the maximum distance between two consecutive values that are connected by a line, in columns
    /// or samples. With Missing::Undefined, it is three times `closest`, because the inputs of a computed
    /// signal may be sampled less often than the table.
    /// closest  smallest distance between two values
    std::int64_t longestLine(std::int64_t closest) const;

    int signal_;
    Missing missing_;
    QPen pen_;
    // Dash pattern of the pen [columns]: lengths of dashes and gaps, alternating.
    std::vector<double> dashes_;
    double dashLength_ = 0;  // total length of the dash pattern [columns]
    bool visible_ = true;
    double offset_ = 0;
    bool right_ = false;
    std::vector<MinMax> envelope_;  // minimum and maximum of each column between cachedEdges_
    std::vector<MinMax> fresh_;
    std::vector<std::int64_t> edges_;
    std::vector<std::int64_t> cachedEdges_;
    double cachedStart_ = 0;
    double cachedWidth_ = 0;
    std::uint64_t cachedRevision_ = 0;  // revision of the history at the last update of the cache
    std::vector<Column> columns_;
    std::int64_t raster_ = 0;
    double width_ = 0;
    std::vector<Column> before_;  // columns_ before the last sample()
    std::int64_t rasterBefore_ = 0;
    double widthBefore_ = 0;
    MinMax range_;
};

}  // namespace tiller
