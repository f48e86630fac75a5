// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All curves of one plot as one picture that is kept from frame to frame: a ring of pixel columns. While the view
// moves through time only the columns that come in, or whose samples have changed, are painted; the rest is what
// was painted before. The columns are turned into pixels here: Qt's stroker takes twenty times as long for a noisy
// polyline of two points a column, and longer still for a dashed one.

#include <QGraphicsItem>
#include <QImage>
#include <memory>
#include <span>
#include <vector>

#include "widgets/plots/curve.h"

namespace tiller {

class CurveSheet : public QGraphicsItem {
public:
    /// curves  drawn in this order; all sampled with the same grid before each setView(). Must outlive the sheet
    /// parent  the chart, in whose coordinates they are drawn
    CurveSheet(const std::vector<std::unique_ptr<Curve>>& curves, QGraphicsItem* parent);

    /// Paints what has changed since the last call.
    /// area  where t0 ... t1 and y0 ... y1 lie, in the chart's coordinates
    void setView(const QRectF& area, double t0, double t1, double y0, double y1);
    /// A pen or what is visible has changed: all is painted again.
    void forget() { painted_ = {}; }
    /// Columns that the last setView() painted; for tests and benchmarks.
    int columnsPainted() const { return columnsPainted_; }

    QRectF boundingRect() const override { return area_; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    /// What has to be the same for painted columns to be of use.
    struct Painted {
        double columnWidth = 0;
        double y0 = 0, y1 = 0;
        QSize size;
        std::vector<double> offsets;
        friend bool operator==(const Painted&, const Painted&) = default;
    };
    std::size_t place(std::int64_t column) const;
    void paintColumns(const std::vector<std::uint8_t>& wanted, double pitch);
    /// pixels  of this column, from the top to the bottom
    void paintColumn(const Curve& curve, std::size_t column, double perUnit, double bottom, bool isDense,
                     const QRgb* shades, QRgb* pixels) const;
    /// Pixels from one column of a block to the next.
    std::ptrdiff_t blockPitch() const;
    /// Puts the columns of a block that are wanted into the ring. first  the number of its first column
    void keepBlock(std::span<const std::uint8_t> wanted, std::size_t first);

    const std::vector<std::unique_ptr<Curve>>& curves_;
    QRectF area_;
    double t0_ = 0, t1_ = 1, y0_ = 0, y1_ = 1;
    Painted painted_;
    std::int64_t raster_ = 0;  // of the first column in the ring
    QImage ring_;
    std::vector<QRgb> block_;  // some columns, one behind the other
    int columnsPainted_ = 0;
};

}  // namespace tiller
