// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/grid_lines.h"

#include <QPainter>
#include <cmath>

namespace tiller {

GridLines::GridLines(QGraphicsItem* parent) : QGraphicsItem(parent) {
    setAcceptedMouseButtons(Qt::NoButton);
}

void GridLines::setColor(const QColor& color) {
    color_ = color;
    update();
}

void GridLines::setLines(const QRectF& area, std::vector<double> heights) {
    if (area == area_ && heights == heights_) {
        return;
    }
    prepareGeometryChange();
    area_ = area;
    heights_ = std::move(heights);
    update();
}

void GridLines::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    for (const double height : heights_) {
        // Fill a complete pixel row, so that antialiasing does not blur the line.
        painter->fillRect(QRectF(area_.left(), std::floor(height), area_.width(), 1), color_);
    }
}

}  // namespace tiller
