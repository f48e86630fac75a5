// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One curve inside a chart: a polyline through the minimum and maximum of every pixel column, at most two
// points a column however long the history; through the samples themselves where there are fewer of them than
// columns.

#include <QGraphicsItem>
#include <QPen>
#include <QPolygonF>
#include <vector>

#include "widgets/plots/series_buffer.h"

namespace tiller {

class CurveItem : public QGraphicsItem {
public:
    /// parent  the chart, in whose coordinates the curve is drawn
    CurveItem(int signal, QGraphicsItem* parent);

    int signal() const { return signal_; }
    void setPen(const QPen& pen);
    const QPen& pen() const { return pen_; }

    /// Fetches what the columns of this grid show.
    void sample(const SeriesBuffer& history, const ColumnGrid& grid);
    /// Smallest and largest value fetched.
    const MinMax& range() const { return range_; }

    /// area  where t0 ... t1 and y0 ... y1 lie, in the chart's coordinates
    void setView(const QRectF& area, double t0, double t1, double y0, double y1);

    /// The curve's pieces as they are drawn; a gap separates two. For tests and pictures.
    std::vector<QPolygonF> polylines() const;

    QRectF boundingRect() const override { return area_; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    struct Point {
        double time;
        float first;
        float second;    // NaN: one point only
        bool gapBefore;  // no line from the point before to this one
    };

    int signal_;
    QPen pen_;
    std::vector<MinMax> columns_;
    std::vector<Point> points_;
    MinMax range_;
    QRectF area_;
    double t0_ = 0, t1_ = 1, y0_ = 0, y1_ = 1;
};

}  // namespace tiller
