// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Renders all curves of a plot into a ring of pixel columns that is reused in every frame. While the view
// moves in time, only new or changed columns are painted. Qt's stroker is not used, because it takes twenty
// times as long for a noisy polyline with two points per column, and even longer for a dashed polyline. The
// distance of any painted pixel from the minimum and maximum of the curve in its column is at most the pen
// width (rounded to whole pixels), even for steep curves.

#include <QGraphicsItem>
#include <QImage>
#include <memory>
#include <span>
#include <vector>

#include "widgets/plots/curve.h"

namespace tiller {

class CurveRaster : public QGraphicsItem {
public:
    /// curves  drawn in this order; must all be sampled with the same grid before each setView(), and must
    /// outlive the object
    /// parent  the chart that defines the coordinates
    /// right   draws only the curves of the value axis at the right; otherwise, only those of the left one
    CurveRaster(const std::vector<std::unique_ptr<Curve>>& curves, QGraphicsItem* parent, bool right = false);

    /// Paints the changes since the last call.
    /// area  rectangle of t0 ... t1 and y0 ... y1 in chart coordinates
    void setView(const QRectF& area, double t0, double t1, double y0, double y1);
    /// Repaints everything at the next setView(). Until then, the painted columns remain. Call this after a
    /// change of a pen or of the visibility.
    void forget() { isOutdated_ = true; }
    /// Number of columns painted by the last setView(); for tests and benchmarks.
    int columnsPainted() const { return columnsPainted_; }

    QRectF boundingRect() const override { return area_; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    /// The parameters that the painted columns depend on.
    struct Painted {
        double columnWidth = 0;
        double y0 = 0, y1 = 0;
        QSize size;
        std::vector<double> offsets;
        friend bool operator==(const Painted&, const Painted&) = default;
    };
    bool includes(const Curve& curve) const { return curve.isVisible() && curve.isRight() == right_; }
    std::size_t place(std::int64_t column) const;
    void paintColumns(const std::vector<std::uint8_t>& wanted, double pitch);
    /// pixels  pixels of this column from top to bottom
    void paintColumn(const Curve& curve, std::size_t column, double perUnit, double bottom, bool isDense,
                     const QRgb* shades, QRgb* pixels) const;
    /// Stride between the columns of a block.
    std::ptrdiff_t blockPitch() const;
    /// Copies the required columns of a block to the ring.
    /// first  number of the first column of the block
    void keepBlock(std::span<const std::uint8_t> wanted, std::size_t first);

    const std::vector<std::unique_ptr<Curve>>& curves_;
    bool right_;
    QRectF area_;
    double t0_ = 0, t1_ = 1, y0_ = 0, y1_ = 1;
    Painted painted_;
    bool isOutdated_ = false;  // see forget()
    std::int64_t raster_ = 0;  // number of the first column in the ring
    QImage ring_;
    std::vector<QRgb> block_;  // a block of consecutive columns
    int columnsPainted_ = 0;
};

}  // namespace tiller
