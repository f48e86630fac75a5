// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curve_item.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace tiller {

CurveItem::CurveItem(int signal, QGraphicsItem* parent) : QGraphicsItem(parent), signal_(signal) {
    setAcceptedMouseButtons(Qt::NoButton);
}

void CurveItem::setPen(const QPen& pen) {
    pen_ = pen;
    update();
}

void CurveItem::sample(const SeriesBuffer& history, const ColumnGrid& grid) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    points_.clear();
    range_ = {};
    if (!grid.empty()) {
        // One sample beyond each edge, so that the line goes on to it.
        const std::int64_t begin = std::max(grid.edges.front() - 1, history.first());
        const std::int64_t end = std::min(grid.edges.back() + 1, history.end());
        if (end - begin <= grid.columns()) {
            for (std::int64_t i = begin; i < end; ++i) {
                const float value = history.value(signal_, i);
                if (!std::isnan(value)) {
                    points_.push_back({history.time(i), value, kNone, history.gapBefore(i)});
                    range_.add(value);
                }
            }
        } else {
            history.envelope(signal_, grid, columns_);
            float last = kNone;
            bool gap = false;
            for (std::size_t i = 0; i < columns_.size(); ++i) {
                gap = gap || grid.gapBefore[i] != 0;
                MinMax column = columns_[i];
                if (column.isEmpty()) {
                    continue;
                }
                range_.add(column);
                // The end nearer to where the line comes from is first: it never crosses the column twice.
                const bool falls = std::abs(column.max - last) < std::abs(column.min - last);
                const float first = falls ? column.max : column.min;
                const float second = falls ? column.min : column.max;
                points_.push_back({grid.start + (static_cast<double>(i) + 0.5) * grid.width, first,
                                   second == first ? kNone : second, gap});
                last = second;
                gap = false;
            }
        }
    }
    update();
}

void CurveItem::setView(const QRectF& area, double t0, double t1, double y0, double y1) {
    if (area != area_) {
        prepareGeometryChange();
        area_ = area;
    }
    t0_ = t0;
    t1_ = t1;
    y0_ = y0;
    y1_ = y1;
    update();
}

std::vector<QPolygonF> CurveItem::polylines() const {
    std::vector<QPolygonF> out;
    if (points_.empty() || !(t1_ > t0_) || !(y1_ > y0_)) {
        return out;
    }
    const double perSecond = area_.width() / (t1_ - t0_);
    const double perUnit = area_.height() / (y1_ - y0_);
    out.emplace_back();
    out.back().reserve(static_cast<qsizetype>(points_.size()) * 2);
    for (const Point& point : points_) {
        if (point.gapBefore && !out.back().isEmpty()) {
            out.emplace_back();
        }
        const double x = area_.left() + (point.time - t0_) * perSecond;
        out.back().append({x, area_.bottom() - (static_cast<double>(point.first) - y0_) * perUnit});
        if (!std::isnan(point.second)) {
            out.back().append({x, area_.bottom() - (static_cast<double>(point.second) - y0_) * perUnit});
        }
    }
    return out;
}

void CurveItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setClipRect(area_);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(pen_);
    for (const QPolygonF& line : polylines()) {
        if (line.size() == 1) {
            painter->drawPoint(line.front());
        } else {
            painter->drawPolyline(line);
        }
    }
}

}  // namespace tiller
