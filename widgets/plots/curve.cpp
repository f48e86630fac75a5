// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tiller {

void Curve::Column::setLeft(double value) {
    left = value;
    low = std::min(low, value);
    high = std::max(high, value);
}

void Curve::Column::setRight(double value) {
    right = value;
    low = std::min(low, value);
    high = std::max(high, value);
}

namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
/// Prefetch distance in columns.
constexpr std::size_t kAhead = 12;
constexpr std::int64_t kCoarse = 3;
constexpr Curve::Column kEmptyColumn = {kNowhere, kNowhere, kNowhere, kNowhere};

/// Returns the smallest distance between two indices with values; the maximum if there are fewer than two.
template <typename HasValue>
std::int64_t closestValues(std::int64_t begin, std::int64_t end, const HasValue& hasValue) {
    std::int64_t closest = std::numeric_limits<std::int64_t>::max();
    std::int64_t last = -1;
    for (std::int64_t i = begin; i < end && closest > 1; ++i) {
        if (hasValue(i)) {
            closest = last >= 0 ? std::min(closest, i - last) : closest;
            last = i;
        }
    }
    return closest;
}

}  // namespace

void Curve::sample(const SeriesBuffer& history, int column, const ColumnGrid& grid) {
    before_.swap(columns_);
    rasterBefore_ = raster_;
    widthBefore_ = width_;
    width_ = grid.width;
    raster_ = std::llround(grid.start / grid.width);
    range_ = {};
    columns_.assign(static_cast<std::size_t>(grid.columns()), kEmptyColumn);
    if (grid.edges.empty()) {
        return;
    }
    // Include one sample beyond each edge, so that the line continues to the edge.
    const std::int64_t begin = std::max(grid.edges.front() - 1, history.first());
    const std::int64_t end = std::min(grid.edges.back() + 1, history.end());
    if (end - begin <= grid.columns()) {
        samplePoints(history, column, begin, end);
    } else {
        sampleEnvelope(history, column, grid);
    }
}

std::int64_t Curve::longestLine(std::int64_t closest) const {
    constexpr std::int64_t kInterruption = 3;
    constexpr std::int64_t kLongest = std::numeric_limits<std::int64_t>::max();
    return missing_ == Missing::Bridged || closest == kLongest ? kLongest : kInterruption * closest;
}

void Curve::sampleEnvelope(const SeriesBuffer& history, int column, const ColumnGrid& grid) {
    fetchEnvelope(history, column, grid);
    const std::size_t none = envelope_.size();
    const std::int64_t longest =
        longestLine(closestValues(0, static_cast<std::int64_t>(none), [this](std::int64_t i) {
            return !envelope_[static_cast<std::size_t>(i)].isEmpty();
        }));
    std::size_t last = none;  // previous column with values
    bool gap = false;
    for (std::size_t i = 0; i < envelope_.size(); ++i) {
        gap = gap || grid.gapBefore[i] != 0;
        if (envelope_[i].isEmpty()) {
            continue;
        }
        gap = gap || (last != none && static_cast<std::int64_t>(i - last) > longest);
        addToRange(envelope_[i].min);
        addToRange(envelope_[i].max);
        const double middle = (envelope_[i].min + envelope_[i].max) / 2;
        columns_[i] = {middle, middle, envelope_[i].min, envelope_[i].max};
        if (last != none && !gap) {
            const double before = (envelope_[last].min + envelope_[last].max) / 2;
            if (last + 1 == i) {
                // If the ranges of both columns overlap, use a value within both. Otherwise, use the middle
                // between them.
                const double bottom = std::max(envelope_[last].min, envelope_[i].min);
                const double top = std::min(envelope_[last].max, envelope_[i].max);
                const double edge =
                    bottom <= top ? std::clamp((before + middle) / 2, bottom, top) : (bottom + top) / 2;
                columns_[last].setRight(edge);
                columns_[i].setLeft(edge);
            } else {
                addLine(static_cast<double>(last) + 0.5, before, static_cast<double>(i) + 0.5, middle);
            }
        }
        last = i;
        gap = false;
    }
}

void Curve::fetchEnvelope(const SeriesBuffer& history, int column, const ColumnGrid& grid) {
    // Columns are on a fixed time raster. While the curve moves, most columns contain the same samples as
    // before, so reuse their values.
    const double shift = (grid.start - cachedStart_) / grid.width;
    const bool sameRaster = grid.width == cachedWidth_ && std::abs(shift - std::round(shift)) < 1e-3 &&
                            std::abs(shift) < static_cast<double>(cachedEdges_.size()) &&
                            history.revision() == cachedRevision_;
    const auto by = sameRaster ? std::llround(shift) : 0;
    const auto known = sameRaster ? static_cast<std::int64_t>(envelope_.size()) : 0;
    fresh_.resize(static_cast<std::size_t>(grid.columns()));
    edges_ = grid.edges;
    // Align the edges of wide columns to summaries, to avoid reading finer summaries and samples, which are
    // scattered in memory. Each sample is still in exactly one column. The edges move by at most 1/kCoarse of
    // the column width.
    std::int64_t summary = 1;
    for (const std::int64_t rows : {SeriesColumn::kSummary, SeriesColumn::kCoarseSummary}) {
        const bool isFar = grid.edges.back() - grid.edges.front() > kCoarse * rows * grid.columns();
        summary = isFar ? rows : summary;
    }
    for (std::size_t i = 1; summary > 1 && i + 1 < edges_.size(); ++i) {
        edges_[i] = std::max(edges_[i] - edges_[i] % summary, edges_[i - 1]);
    }
    for (std::size_t i = 0; i < fresh_.size(); ++i) {
        const std::int64_t j = static_cast<std::int64_t>(i) + by;
        const auto old = static_cast<std::size_t>(j);
        if (j >= 0 && j < known && cachedEdges_[old] == edges_[i] && cachedEdges_[old + 1] == edges_[i + 1]) {
            fresh_[i] = envelope_[old];
        } else {
            history.fetchAhead(column, edges_[std::min(i + kAhead, fresh_.size())]);
            fresh_[i] = history.minMax(column, edges_[i], edges_[i + 1]);
        }
    }
    envelope_.swap(fresh_);
    cachedEdges_.swap(edges_);
    cachedStart_ = grid.start;
    cachedWidth_ = grid.width;
    cachedRevision_ = history.revision();
}

void Curve::samplePoints(const SeriesBuffer& history, int column, std::int64_t begin, std::int64_t end) {
    // Use positions relative to the integer time raster, so that the position of a sample in its column
    // remains exactly equal while the view moves.
    const auto origin = static_cast<double>(raster_);
    const std::int64_t longest = longestLine(
        closestValues(begin, end, [&](std::int64_t i) { return !std::isnan(history.value(column, i)); }));
    std::int64_t last = -1;  // previous sample with a value
    bool gap = false;
    double x0 = 0;
    double y0 = 0;
    for (std::int64_t i = begin; i < end; ++i) {
        gap = gap || history.gapBefore(i);
        const double y = history.value(column, i);
        if (std::isnan(y)) {
            continue;
        }
        gap = gap || (last >= 0 && i - last > longest);
        addToRange(y);
        const double x = history.time(i) / width_ - origin;
        if (last >= 0 && !gap) {
            addLine(x0, y0, x, y);
        } else {
            addLine(x, y, x, y);
        }
        last = i;
        gap = false;
        x0 = x;
        y0 = y;
    }
}

void Curve::addToRange(double value) {
    if (std::isfinite(value)) {
        range_.add(value);
    }
}

void Curve::addLine(double x0, double y0, double x1, double y1) {
    const auto last = static_cast<double>(columns_.size());
    const double slope = x1 > x0 ? (y1 - y0) / (x1 - x0) : 0;
    for (double x = std::floor(std::max(x0, 0.0)); x <= x1 && x < last; x += 1) {
        const auto at = [&](double place) { return y0 + (place - x0) * slope; };
        const double in = at(std::max(x, x0));
        const double out = at(std::min(x + 1, x1));
        Column& column = columns_[static_cast<std::size_t>(x)];
        if (column.isEmpty()) {
            column = {in, out, in, in};
        }
        column.low = std::min(column.low, in);
        column.high = std::max(column.high, in);
        column.setRight(out);
    }
}

bool Curve::hasChanged(std::size_t column) const {
    if (width_ != widthBefore_) {
        return true;
    }
    const std::int64_t then = static_cast<std::int64_t>(column) + raster_ - rasterBefore_;
    return then < 0 || then >= static_cast<std::int64_t>(before_.size()) ||
           !(columns_[column] == before_[static_cast<std::size_t>(then)]);
}

void Curve::setPen(const QPen& pen) {
    pen_ = pen;
    dashes_.clear();
    dashLength_ = 0;
    if (pen_.style() == Qt::CustomDashLine) {
        const QList<qreal> pattern = pen_.dashPattern();
        for (const qreal piece : pattern) {
            dashes_.push_back(piece * pen_.widthF());
            dashLength_ += dashes_.back();
        }
    }
}

void Curve::findDrawn(std::span<std::uint8_t> drawn, double beyond) const {
    if (dashes_.empty()) {
        std::fill(drawn.begin(), drawn.end(), std::uint8_t{1});
        return;
    }
    // The dashes start at the origin of the time axis, so that they move with the curve.
    double place = std::fmod(static_cast<double>(raster_), dashLength_);
    place = place < 0 ? place + dashLength_ : place;
    constexpr double kRounding = 1e-6;  // rounding error of the accumulated value
    for (std::uint8_t& each : drawn) {
        double rest = place + kRounding;
        std::size_t piece = 0;
        while (piece + 1 < dashes_.size() && rest >= dashes_[piece]) {
            rest -= dashes_[piece++];
        }
        each = piece % 2 == 0 ? 1 : 0;
        place += 1;
        place = place + kRounding >= dashLength_ ? std::max(0.0, place - dashLength_) : place;
    }
    // The eye interpolates between two dashes. Draw values in the gap that are outside the range of the
    // adjacent dash ends.
    const std::size_t count = std::min(drawn.size(), columns_.size());
    for (std::size_t i = 0; i < count;) {
        if (drawn[i] != 0) {
            ++i;
            continue;
        }
        const std::size_t begin = i;
        while (i < count && drawn[i] == 0) {
            ++i;
        }
        // Use the smaller dash end, so that a spike at the end of one dash does not hide a spike in the gap.
        MinMax ends;
        double half = std::numeric_limits<double>::infinity();
        for (const std::size_t end : {begin - 1, i}) {  // if begin is 0, begin - 1 wraps to an invalid index
            if (end < count && !columns_[end].isEmpty()) {
                ends.add((columns_[end].low + columns_[end].high) / 2);
                half = std::min(half, (columns_[end].high - columns_[end].low) / 2);
            }
        }
        for (std::size_t gap = begin; gap < i && !ends.isEmpty(); ++gap) {
            const Column& column = columns_[gap];
            if (column.low < ends.min - half - beyond || column.high > ends.max + half + beyond) {
                drawn[gap] = 1;
            }
        }
    }
}

QPainterPath Curve::path(const QRectF& area, double t0, double t1, double y0, double y1) const {
    const double perSecond = area.width() / (t1 - t0);
    const double perUnit = area.height() / (y1 - y0);
    const double start = static_cast<double>(raster_) * width_;
    const auto at = [&](double column, double value) {
        return QPointF(area.left() + (start + column * width_ - t0) * perSecond,
                       area.bottom() - (value - offset_ - y0) * perUnit);
    };
    QPainterPath path;
    bool drawing = false;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const Column& column = columns_[i];
        if (column.isEmpty()) {
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
    return path;
}

}  // namespace tiller
