// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The horizontal grid lines of a plot. QChart places the grid lines of its axes in a later layout pass, and
// only while the chart is shown. After a change of size or scale, such lines would not match the labels.

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
