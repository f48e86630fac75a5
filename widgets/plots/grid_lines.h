// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The horizontal grid lines of a plot. The axes of a chart place their grid lines in a later layout, and only
// while the chart is shown, so that the lines would not match the labels after a change of size or scale.

#include <QColor>
#include <QGraphicsItem>
#include <QRectF>
#include <vector>

namespace tiller {

class GridLines : public QGraphicsItem {
public:
    explicit GridLines(QGraphicsItem* parent);

    void setColor(const QColor& color);
    /// area     area of the curves in chart coordinates; each line crosses its full width
    /// heights  vertical positions of the lines
    void setLines(const QRectF& area, std::vector<double> heights);

    QRectF boundingRect() const override { return area_; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QColor color_;
    QRectF area_;
    std::vector<double> heights_;
};

}  // namespace tiller
