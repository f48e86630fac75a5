// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One curve, as what it covers in every pixel column: the stretch from its minimum to its maximum, joined to the
// neighbours, however long the history. CurveSheet turns the columns into pixels.

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
    /// What the curve covers in one pixel column, in its own unit. NaN in `left`: nothing.
    struct Column {
        double left, right;  ///< where it enters and leaves the column
        double low, high;    ///< how far it goes in between

        bool isEmpty() const { return std::isnan(left); }
        friend bool operator==(const Column& a, const Column& b) {
            return (a.isEmpty() && b.isEmpty()) ||
                   (a.left == b.left && a.right == b.right && a.low == b.low && a.high == b.high);
        }
    };

    explicit Curve(int signal) : signal_(signal) {}

    int signal() const { return signal_; }
    /// Colour, width and dash pattern; dashes run along the time axis and move with the curve.
    void setPen(const QPen& pen);
    const QPen& pen() const { return pen_; }
    void setVisible(bool visible) { visible_ = visible; }
    bool isVisible() const { return visible_; }
    /// What is taken off before it is drawn.
    void setOffset(double offset) { offset_ = offset; }
    double offset() const { return offset_; }

    /// Fetches what the columns of this grid show. Always from the same column of the same history.
    void sample(const SeriesBuffer& history, int column, const ColumnGrid& grid);
    /// Smallest and largest value fetched.
    const MinMax& range() const { return range_; }
    const std::vector<Column>& columns() const { return columns_; }
    /// Number of the first column on the raster of time: columns of the same width and number are the same
    /// stretch.
    std::int64_t raster() const { return raster_; }
    double columnWidth() const { return width_; }
    /// This column shows something else than it did before the last sample(), or was not there.
    bool hasChanged(std::size_t column) const;
    /// Of each column, whether it is drawn: where the pen's dashes draw, and where the curve goes beyond the dashes
    /// beside it, so that no spike falls between two of them.
    /// drawn   one for each column; 0: it is not
    /// beyond  by so much, in the curve's own unit
    void findDrawn(std::span<std::uint8_t> drawn, double beyond) const;

    /// As lines, for files that keep lines.
    QPainterPath path(const QRectF& area, double t0, double t1, double y0, double y1) const;

private:
    void fetchEnvelope(const SeriesBuffer& history, int column, const ColumnGrid& grid);
    void sampleEnvelope(const SeriesBuffer& history, int column, const ColumnGrid& grid);
    void samplePoints(const SeriesBuffer& history, int column, std::int64_t begin, std::int64_t end);
    void addLine(double x0, double y0, double x1, double y1);

    int signal_;
    QPen pen_;
    std::vector<double> dashes_;  // of the pen, in columns: drawn and left out in turn
    double dashLength_ = 0;       // all of them
    bool visible_ = true;
    double offset_ = 0;
    std::vector<MinMax> envelope_;  // of the columns with cachedEdges_
    std::vector<MinMax> fresh_;
    std::vector<std::int64_t> edges_;
    std::vector<std::int64_t> cachedEdges_;
    double cachedStart_ = 0;
    double cachedWidth_ = 0;
    std::uint64_t cachedRevision_ = 0;  // of the history
    std::vector<Column> columns_;
    std::int64_t raster_ = 0;
    double width_ = 0;
    std::vector<Column> before_;  // columns_ of the sample() before
    std::int64_t rasterBefore_ = 0;
    double widthBefore_ = 0;
    MinMax range_;
};

}  // namespace tiller
