// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One curve inside a chart: in every pixel column the stretch from its minimum to its maximum, joined to the
// neighbours, however long the history. The columns are turned into pixels here: Qt's stroker takes twenty
// times as long for a noisy polyline of two points a column, and longer still for a dashed one.

#include <QGraphicsItem>
#include <QImage>
#include <QPen>
#include <vector>

#include "widgets/plots/series_buffer.h"

namespace tiller {

class CurveItem : public QGraphicsItem {
public:
    /// What the curve covers in one pixel column, in its own unit. NaN in `left`: nothing.
    struct Column {
        float left, right;  ///< where it enters and leaves the column
        float low, high;    ///< how far it goes in between
    };

    /// parent  the chart, in whose coordinates the curve is drawn
    CurveItem(int signal, QGraphicsItem* parent);

    int signal() const { return signal_; }
    /// Colour, width and dash pattern; dashes run along the time axis and move with the curve.
    void setPen(const QPen& pen);
    const QPen& pen() const { return pen_; }

    /// Fetches what the columns of this grid show. Always from the same history.
    void sample(const SeriesBuffer& history, const ColumnGrid& grid);
    /// Smallest and largest value fetched.
    const MinMax& range() const { return range_; }
    const std::vector<Column>& columns() const { return columns_; }

    /// area  where t0 ... t1 and y0 ... y1 lie, in the chart's coordinates
    void setView(const QRectF& area, double t0, double t1, double y0, double y1);

    QRectF boundingRect() const override { return area_; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    void fetchEnvelope(const SeriesBuffer& history, const ColumnGrid& grid);
    void sampleEnvelope(const SeriesBuffer& history, const ColumnGrid& grid);
    void samplePoints(const SeriesBuffer& history, const ColumnGrid& grid, std::int64_t begin,
                      std::int64_t end);
    void addLine(double x0, float y0, double x1, float y1);
    bool dashed(std::size_t column) const;
    void paintLines(QPainter* painter) const;

    int signal_;
    QPen pen_;
    std::vector<MinMax> envelope_;  // of the columns with cachedEdges_
    std::vector<MinMax> fresh_;
    std::vector<std::int64_t> cachedEdges_;
    double cachedStart_ = 0;
    double cachedWidth_ = 0;
    std::vector<Column> columns_;
    double gridStart_ = 0;
    double gridWidth_ = 1;
    MinMax range_;
    QRectF area_;
    double t0_ = 0, t1_ = 1, y0_ = 0, y1_ = 1;
    QImage image_;  // kept between frames
};

}  // namespace tiller
