// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/shapes.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <numbers>

#include "widgets/common/theme.h"

namespace tiller {

namespace {

QPolygonF octagon(const QRectF& box) {
    QPolygonF points;
    for (int i = 0; i < 8; ++i) {
        const double angle = std::numbers::pi / 8 * (2 * i + 1);
        points << QPointF(box.center().x() + box.width() / 2 * std::cos(angle) * 1.04,
                          box.center().y() + box.height() / 2 * std::sin(angle) * 1.04);
    }
    return points;
}

void drawExclamation(QPainter& painter, const QRectF& box, const QColor& colour, double top) {
    const double x = box.center().x();
    painter.setPen(QPen(colour, 1.7, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(x, box.top() + box.height() * top),
                     QPointF(x, box.top() + box.height() * (top + 0.26)));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(QPointF(x, box.top() + box.height() * (top + 0.46)), 1.1, 1.1);
}

void drawHand(QPainter& painter, const QRectF& box, const QColor& ink) {
    // A hand: four fingers, a thumb and a palm.
    const double w = box.width();
    const double h = box.height();
    QPainterPath hand;
    hand.setFillRule(Qt::WindingFill);
    constexpr double kTops[] = {0.20, 0.04, 0.04, 0.16};
    for (int i = 0; i < 4; ++i) {
        hand.addRoundedRect(QRectF(box.left() + w * (0.26 + 0.185 * i), box.top() + h * kTops[i], w * 0.14,
                                   h * (0.66 - kTops[i])),
                            w * 0.07, w * 0.07);
    }
    hand.addRoundedRect(QRectF(box.left() + w * 0.26, box.top() + h * 0.48, w * 0.695, h * 0.5), w * 0.18,
                        w * 0.2);
    QPainterPath thumb;
    thumb.addRoundedRect(QRectF(-w * 0.075, -h * 0.2, w * 0.15, h * 0.42), w * 0.07, w * 0.07);
    QTransform turn;
    turn.translate(box.left() + w * 0.2, box.top() + h * 0.68);
    turn.rotate(-35);
    hand.addPath(turn.map(thumb));
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawPath(hand.simplified());
}

}  // namespace

void drawShape(QPainter& painter, StateChip::Shape shape, const QRectF& box, const QColor& ink,
               const QColor& ground, const QString& mark) {
    using Shape = StateChip::Shape;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QPen line(ink, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    switch (shape) {
        case Shape::None:
            break;
        case Shape::Circle:
            painter.setPen(QPen(ink, 1.4));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(box.adjusted(1.7, 1.7, -1.7, -1.7));
            break;
        case Shape::Dot:
            painter.drawEllipse(box.adjusted(2, 2, -2, -2));
            break;
        case Shape::Bolt:
            painter.drawPolygon(
                QPolygonF({box.topLeft() + QPointF(8.5, 0.5), box.topLeft() + QPointF(2.5, 8),
                           box.topLeft() + QPointF(6.5, 8), box.topLeft() + QPointF(5.5, 13.5),
                           box.topLeft() + QPointF(11.5, 5.8), box.topLeft() + QPointF(7.5, 5.8)}));
            break;
        case Shape::DownArrow:
            painter.setPen(line);
            painter.drawLine(QPointF(box.center().x(), box.top() + 2),
                             QPointF(box.center().x(), box.bottom() - 2));
            painter.setBrush(Qt::NoBrush);
            painter.drawPolyline(QPolygonF({QPointF(box.center().x() - 4, box.bottom() - 6),
                                            QPointF(box.center().x(), box.bottom() - 2),
                                            QPointF(box.center().x() + 4, box.bottom() - 6)}));
            break;
        case Shape::DoubleArrow:
            painter.setPen(line);
            painter.setBrush(Qt::NoBrush);
            painter.drawLine(QPointF(box.left() + 1, box.center().y()),
                             QPointF(box.right() - 1, box.center().y()));
            for (const double side : {1.0, -1.0}) {
                const double tip = box.center().x() + side * (box.width() / 2 - 1);
                painter.drawPolyline(QPolygonF({QPointF(tip - side * 3.5, box.center().y() - 3.5),
                                                QPointF(tip, box.center().y()),
                                                QPointF(tip - side * 3.5, box.center().y() + 3.5)}));
            }
            break;
        case Shape::Triangle:
            painter.drawPolygon(
                QPolygonF({box.topLeft() + QPointF(1.5, 1), box.bottomLeft() + QPointF(1.5, -1),
                           QPointF(box.right() - 0.5, box.center().y())}));
            break;
        case Shape::WarningTriangle: {
            painter.setPen(QPen(ink, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter.drawPolygon(
                QPolygonF({QPointF(box.center().x(), box.top() + 1), box.bottomLeft() + QPointF(0.8, -1.2),
                           box.bottomRight() + QPointF(-0.8, -1.2)}));
            drawExclamation(painter, box, ground, 0.36);
            break;
        }
        case Shape::Octagon:
            painter.drawPolygon(octagon(box));
            if (mark.isEmpty()) {
                drawExclamation(painter, box, ground, 0.25);
            } else {
                painter.setFont(textFont(mark.size() > 1 ? 8 : 10, QFont::Bold));
                painter.setPen(ground);
                painter.drawText(box.adjusted(-2, -1, 2, 1), Qt::AlignCenter, mark);
            }
            break;
        case Shape::Hand:
            drawHand(painter, box, ink);
            break;
        case Shape::Square:
            painter.drawRect(box.adjusted(1.5, 1.5, -1.5, -1.5));
            break;
        case Shape::Power:
            painter.setPen(line);
            painter.setBrush(Qt::NoBrush);
            painter.drawArc(box.adjusted(1.5, 2, -1.5, -1), 125 * 16, 290 * 16);
            painter.drawLine(QPointF(box.center().x(), box.top() + 1),
                             QPointF(box.center().x(), box.center().y() - 1));
            break;
        case Shape::Bars:
            for (int i = 0; i < 3; ++i) {
                const double height = box.height() * (0.35 + 0.28 * i);
                painter.drawRect(QRectF(box.left() + 1 + i * 4.6, box.bottom() - 1 - height, 3, height));
            }
            break;
        case Shape::Cross:
            painter.setPen(QPen(ink, 2, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(box.topLeft() + QPointF(2.5, 2.5), box.bottomRight() - QPointF(2.5, 2.5));
            painter.drawLine(box.bottomLeft() + QPointF(2.5, -2.5), box.topRight() + QPointF(-2.5, 2.5));
            break;
        case Shape::Pause:
            painter.drawRect(QRectF(box.left() + 2.5, box.top() + 1.5, 3.2, box.height() - 3));
            painter.drawRect(QRectF(box.right() - 5.7, box.top() + 1.5, 3.2, box.height() - 3));
            break;
    }
    if (!mark.isEmpty() && shape != Shape::Octagon) {
        painter.setFont(textFont(10, QFont::Bold));
        painter.setPen(ink);
        painter.drawText(QRectF(box.right() + 1, box.top() - 1, 12, box.height() + 2), Qt::AlignCenter, mark);
    }
    painter.restore();
}

}  // namespace tiller
