// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/axis_labels.h"

#include <QFontMetricsF>
#include <QPainter>

namespace tiller {

AxisLabels::AxisLabels(Qt::Alignment alignment, QGraphicsItem* parent)
    : QGraphicsItem(parent), alignment_(alignment) {
    setAcceptedMouseButtons(Qt::NoButton);
}

void AxisLabels::setLook(const QFont& font, const QColor& color) {
    font_ = font;
    color_ = color;
    update();
}

void AxisLabels::setLabels(std::vector<Label> labels) {
    if (labels == labels_) {
        return;
    }
    prepareGeometryChange();
    labels_ = std::move(labels);
    bounds_ = {};
    for (const Label& label : labels_) {
        bounds_ |= label.box;
    }
    update();
}

void AxisLabels::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setPen(color_);
    for (const Label& label : labels_) {
        QFont font = font_;
        constexpr int kSmallest = 8;
        while (alignment_.testFlag(Qt::AlignRight) && font.pixelSize() > kSmallest &&
               QFontMetricsF(font).horizontalAdvance(label.text) > label.box.width()) {
            font.setPixelSize(font.pixelSize() - 1);
        }
        painter->setFont(font);
        painter->drawText(label.box, static_cast<int>(alignment_) | Qt::TextDontClip | Qt::TextSingleLine,
                          label.text);
    }
}

}  // namespace tiller
