// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curve_item.h"

#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

namespace tiller {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr CurveItem::Column kEmpty = {kNone, kNone, kNone, kNone};

bool isEmpty(const CurveItem::Column& column) {
    return std::isnan(column.left);
}

/// Colour times coverage, premultiplied, for 0 ... 255.
std::array<QRgb, 256> shades(const QColor& color) {
    std::array<QRgb, 256> out{};
    for (int i = 0; i < 256; ++i) {
        out[static_cast<std::size_t>(i)] =
            qPremultiply(qRgba(color.red(), color.green(), color.blue(), i * color.alpha() / 255));
    }
    return out;
}

}  // namespace

CurveItem::CurveItem(int signal, QGraphicsItem* parent) : QGraphicsItem(parent), signal_(signal) {
    setAcceptedMouseButtons(Qt::NoButton);
}

void CurveItem::setPen(const QPen& pen) {
    pen_ = pen;
    update();
}

void CurveItem::sample(const SeriesBuffer& history, const ColumnGrid& grid) {
    gridStart_ = grid.start;
    gridWidth_ = grid.width;
    range_ = {};
    columns_.assign(static_cast<std::size_t>(grid.columns()), kEmpty);
    if (!grid.edges.empty()) {
        // One sample beyond each edge, so that the line goes on to it.
        const std::int64_t begin = std::max(grid.edges.front() - 1, history.first());
        const std::int64_t end = std::min(grid.edges.back() + 1, history.end());
        if (end - begin <= grid.columns()) {
            samplePoints(history, grid, begin, end);
        } else {
            sampleEnvelope(history, grid);
        }
    }
    update();
}

void CurveItem::sampleEnvelope(const SeriesBuffer& history, const ColumnGrid& grid) {
    fetchEnvelope(history, grid);
    const std::size_t none = envelope_.size();
    std::size_t last = none;  // the column before that has values
    bool gap = false;
    for (std::size_t i = 0; i < envelope_.size(); ++i) {
        gap = gap || grid.gapBefore[i] != 0;
        if (envelope_[i].isEmpty()) {
            continue;
        }
        range_.add(envelope_[i]);
        const float middle = (envelope_[i].min + envelope_[i].max) / 2;
        columns_[i] = {middle, middle, envelope_[i].min, envelope_[i].max};
        if (last != none && !gap) {
            const float before = (envelope_[last].min + envelope_[last].max) / 2;
            if (last + 1 == i) {
                columns_[last].right = columns_[i].left = (before + middle) / 2;
            } else {
                addLine(static_cast<double>(last) + 0.5, before, static_cast<double>(i) + 0.5, middle);
            }
        }
        last = i;
        gap = false;
    }
}

void CurveItem::fetchEnvelope(const SeriesBuffer& history, const ColumnGrid& grid) {
    // Columns lie on a raster of time: while the curve moves, most of them hold the samples they held before.
    const double shift = (grid.start - cachedStart_) / grid.width;
    const bool sameRaster = grid.width == cachedWidth_ && std::abs(shift - std::round(shift)) < 1e-3 &&
                            std::abs(shift) < static_cast<double>(cachedEdges_.size());
    const auto by = sameRaster ? std::llround(shift) : 0;
    const auto known = sameRaster ? static_cast<std::int64_t>(envelope_.size()) : 0;
    fresh_.resize(static_cast<std::size_t>(grid.columns()));
    for (std::size_t i = 0; i < fresh_.size(); ++i) {
        const std::int64_t j = static_cast<std::int64_t>(i) + by;
        const auto old = static_cast<std::size_t>(j);
        if (j >= 0 && j < known && cachedEdges_[old] == grid.edges[i] &&
            cachedEdges_[old + 1] == grid.edges[i + 1]) {
            fresh_[i] = envelope_[old];
        } else {
            fresh_[i] = history.minMax(signal_, grid.edges[i], grid.edges[i + 1]);
        }
    }
    envelope_.swap(fresh_);
    cachedEdges_ = grid.edges;
    cachedStart_ = grid.start;
    cachedWidth_ = grid.width;
}

void CurveItem::samplePoints(const SeriesBuffer& history, const ColumnGrid& grid, std::int64_t begin,
                             std::int64_t end) {
    bool any = false;
    bool gap = false;
    double x0 = 0;
    float y0 = 0;
    for (std::int64_t i = begin; i < end; ++i) {
        gap = gap || history.gapBefore(i);
        const float y = history.value(signal_, i);
        if (std::isnan(y)) {
            continue;
        }
        range_.add(y);
        const double x = (history.time(i) - grid.start) / grid.width;
        if (any && !gap) {
            addLine(x0, y0, x, y);
        } else {
            addLine(x, y, x, y);
        }
        any = true;
        gap = false;
        x0 = x;
        y0 = y;
    }
}

void CurveItem::addLine(double x0, float y0, double x1, float y1) {
    const auto last = static_cast<double>(columns_.size());
    const double slope = x1 > x0 ? static_cast<double>(y1 - y0) / (x1 - x0) : 0;
    for (double x = std::floor(std::max(x0, 0.0)); x <= x1 && x < last; x += 1) {
        const auto at = [&](double place) {
            return static_cast<float>(static_cast<double>(y0) + (place - x0) * slope);
        };
        const float in = at(std::max(x, x0));
        const float out = at(std::min(x + 1, x1));
        Column& column = columns_[static_cast<std::size_t>(x)];
        if (isEmpty(column)) {
            column = {in, out, in, in};
        }
        column.right = out;
        column.low = std::min({column.low, in, out});
        column.high = std::max({column.high, in, out});
    }
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

bool CurveItem::dashed(std::size_t column) const {
    const QList<qreal> pattern = pen_.dashPattern();
    double length = 0;
    for (const qreal piece : pattern) {
        length += piece * pen_.widthF();
    }
    // Counted from the origin of time, so that the dashes stay on the curve while it moves.
    double place = std::fmod(std::round(gridStart_ / gridWidth_) + static_cast<double>(column), length);
    place = place < 0 ? place + length : place;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        place -= pattern[i] * pen_.widthF();
        if (place < 0) {
            return i % 2 == 0;
        }
    }
    return true;
}

/// For files that keep lines: there is time for Qt's stroker.
void CurveItem::paintLines(QPainter* painter) const {
    const double perSecond = area_.width() / (t1_ - t0_);
    const double perUnit = area_.height() / (y1_ - y0_);
    const auto at = [&](double column, float value) {
        return QPointF(area_.left() + (gridStart_ + column * gridWidth_ - t0_) * perSecond,
                       area_.bottom() - (static_cast<double>(value) - y0_) * perUnit);
    };
    QPainterPath path;
    bool drawing = false;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const Column& column = columns_[i];
        if (isEmpty(column)) {
            drawing = false;
            continue;
        }
        const auto x = static_cast<double>(i);
        if (drawing) {
            path.lineTo(at(x, column.left));
        } else {
            path.moveTo(at(x, column.left));
        }
        if (column.high > std::max(column.left, column.right)) {
            path.lineTo(at(x + 0.5, column.high));
        }
        if (column.low < std::min(column.left, column.right)) {
            path.lineTo(at(x + 0.5, column.low));
        }
        path.lineTo(at(x + 1, column.right));
        drawing = true;
    }
    painter->setClipRect(area_);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(pen_);
    painter->drawPath(path);
}

void CurveItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (columns_.empty() || range_.isEmpty() || !(t1_ > t0_) || !(y1_ > y0_)) {
        return;
    }
    const QPaintEngine::Type device = painter->paintEngine()->type();
    if (device == QPaintEngine::SVG || device == QPaintEngine::Pdf) {
        paintLines(painter);
        return;
    }
    // In columns of the grid from here on: they are device pixels, and rows are made as high as they are
    // wide.
    const double pitch = gridWidth_ * area_.width() / (t1_ - t0_);
    const double perUnit = area_.height() / pitch / (y1_ - y0_);
    const double bottom = area_.height() / pitch;
    const double half = pen_.widthF() / 2;
    const auto rowOf = [&](float value) { return bottom - (static_cast<double>(value) - y0_) * perUnit; };
    const int rows = static_cast<int>(std::ceil(bottom));
    const int first = std::clamp(static_cast<int>(std::floor(rowOf(range_.max) - half - 4)), 0, rows);
    const int end = std::clamp(static_cast<int>(std::ceil(rowOf(range_.min) + half + 4)), first, rows);
    const auto width = static_cast<int>(columns_.size());
    if (end == first) {
        return;
    }
    if (image_.width() != width || image_.height() < end - first) {
        image_ = QImage(width, rows, QImage::Format_ARGB32_Premultiplied);
    }
    std::fill_n(reinterpret_cast<QRgb*>(image_.bits()),
                static_cast<std::size_t>(width) * static_cast<std::size_t>(end - first), 0U);
    auto* const pixels = reinterpret_cast<QRgb*>(image_.bits());
    const std::array<QRgb, 256> shade = shades(pen_.color());
    const bool dashes = pen_.style() == Qt::CustomDashLine;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const Column& column = columns_[i];
        if (isEmpty(column) || (dashes && !dashed(i))) {
            continue;
        }
        // A slanted stroke through the column, as thick as the pen and as what the curve does besides
        // slanting; how much of a pixel it covers follows from where its two edges cross the column.
        const double left = rowOf(column.left);
        const double right = rowOf(column.right);
        const double slant = std::abs(right - left);
        const double thickness = half * std::sqrt(1 + slant * slant) +
                                 std::max(0.0, rowOf(column.low) - rowOf(column.high) - slant) / 2;
        // The stroke's middle is that of its extent, unless it only slants.
        const double middle = (rowOf(column.low) + rowOf(column.high)) / 2;
        const double ramp = std::max(slant, 1.0);
        const auto cover = [&](int y) {
            const double above = (y + 0.5 - middle + thickness) / ramp + 0.5;
            const double below = (y + 0.5 - middle - thickness) / ramp + 0.5;
            return static_cast<std::size_t>(
                (std::clamp(above, 0.0, 1.0) - std::clamp(below, 0.0, 1.0)) * 255 + 0.5);
        };
        const auto row = [&](double y) { return std::clamp(static_cast<int>(y), first, end); };
        const int from = row(std::floor(middle - ramp / 2 - thickness));
        const int to = row(std::ceil(middle + ramp / 2 + thickness) + 1);
        // Rows wholly covered need no arithmetic: most of them where the signal is noisy.
        const int fullFrom = std::max(from, row(std::ceil(middle + ramp / 2 - thickness)));
        const int fullTo = std::max(fullFrom, std::min(to, row(std::floor(middle - ramp / 2 + thickness))));
        QRgb* pixel =
            pixels + static_cast<std::ptrdiff_t>(from - first) * width + static_cast<std::ptrdiff_t>(i);
        int y = from;
        for (; y < fullFrom; ++y, pixel += width) {
            *pixel = shade[cover(y)];
        }
        for (; y < fullTo; ++y, pixel += width) {
            *pixel = shade[255];
        }
        for (; y < to; ++y, pixel += width) {
            *pixel = shade[cover(y)];
        }
    }
    // Whole pixels only: resampling would blur the curve and make it shimmer while it moves.
    const double x = std::round((gridStart_ - t0_) / gridWidth_) * pitch + area_.left();
    painter->setClipRect(area_);
    painter->drawImage(QRectF(x, area_.top() + first * pitch, width * pitch, (end - first) * pitch), image_,
                       QRectF(0, 0, width, end - first));
}

}  // namespace tiller
