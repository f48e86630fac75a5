// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_overlay.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/common/theme.h"

namespace tiller {

namespace {

struct LaneColors {
    QColor surface;
    QColor text;
};

LaneColors colorsOf(LaneKind kind, const Theme& theme) {
    switch (kind) {
        case LaneKind::Moving:
            return {theme.moving, theme.movingText};
        case LaneKind::Stopped:
            return {theme.stop, theme.stopText};
        case LaneKind::Idle:
        case LaneKind::Off:
            return {theme.border, theme.text};
        case LaneKind::High:
            return {theme.secondary, theme.panel};
        case LaneKind::Low:
        case LaneKind::Varied:
        case LaneKind::NoData:
            break;
    }
    return {Qt::transparent, theme.secondary};
}

}  // namespace

CursorItem::CursorItem(const QString& letter) : letter_(letter) {
    setZValue(20);
    setAcceptedMouseButtons(Qt::NoButton);
}

void CursorItem::setLine(double x, double top, double bottom) {
    if (bottom - top != height_) {
        prepareGeometryChange();
        height_ = bottom - top;
    }
    setPos(std::floor(x) + 0.5, top);
}

void CursorItem::setActive(bool active) {
    active_ = active;
    update();
}

QRectF CursorItem::boundingRect() const {
    return {-8.0, -kLetterHeight, 16.0, height_ + kLetterHeight};
}

void CursorItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    const Theme& theme = Theme::current();
    painter->setFont(textFont(13, active_ ? QFont::Bold : QFont::Normal));
    painter->setPen(theme.text);
    painter->drawText(QRectF(-8, -kLetterHeight, 16, kLetterHeight - 2), Qt::AlignCenter, letter_);
    QPen pen(theme.text, 1.2);
    pen.setDashPattern({3, 3});
    painter->setPen(pen);
    painter->drawLine(QPointF(0, 0), QPointF(0, height_));
}

LaneItem::LaneItem(const QString& name) : name_(name) {
    setAcceptedMouseButtons(Qt::NoButton);
}

QRectF LaneItem::boundingRect() const {
    return area_.adjusted(name_.isEmpty() ? 0 : -kNameWidth, 0, 0, 0);
}

void LaneItem::setView(const QRectF& area, double t0, double t1) {
    if (area != area_) {
        prepareGeometryChange();
        area_ = area;
    }
    t0_ = t0;
    t1_ = t1;
    update();
}

void LaneItem::setSegments(std::vector<LaneSegment> segments) {
    segments_ = std::move(segments);
    update();
}

void LaneItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    const Theme& theme = Theme::current();
    const double perSecond = area_.width() / (t1_ - t0_);
    painter->setFont(textFont(11));
    if (!name_.isEmpty()) {
        painter->setPen(theme.secondary);
        const QRectF place(area_.left() - kNameWidth, area_.top(), kNameWidth - 4, area_.height());
        painter->drawText(place, Qt::AlignRight | Qt::AlignVCenter,
                          painter->fontMetrics().elidedText(name_, Qt::ElideRight, kNameWidth - 4));
    }
    painter->setClipRect(area_, Qt::IntersectClip);
    for (const LaneSegment& segment : segments_) {
        const LaneColors colors = colorsOf(segment.kind, theme);
        const double left = area_.left() + (segment.start - t0_) * perSecond;
        const QRectF box(left, area_.top(), (segment.end - segment.start) * perSecond, area_.height());
        painter->fillRect(box, colors.surface);
        if (segment.kind == LaneKind::NoData) {
            painter->fillRect(box, QBrush(theme.border, Qt::BDiagPattern));
        } else if (segment.kind == LaneKind::Varied) {
            painter->fillRect(box, QBrush(theme.text, Qt::Dense4Pattern));
        } else if (segment.kind == LaneKind::Low) {
            painter->fillRect(QRectF(box.left(), box.bottom() - 1, box.width(), 1), theme.secondary);
        } else if (!name_.isEmpty()) {
            // A line separates adjacent states of equal colour.
            painter->fillRect(QRectF(box.left(), box.top(), 1, box.height()), theme.text);
        }
        const QRectF text = box.adjusted(8, 0, -4, 0);
        if (text.width() > 22) {
            painter->setPen(colors.text);
            const QString elided = painter->fontMetrics().elidedText(segment.label, Qt::ElideRight,
                                                                     static_cast<int>(text.width()));
            painter->drawText(text, Qt::AlignLeft | Qt::AlignVCenter, elided);
        }
    }
}

}  // namespace tiller
