// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curve_raster.h"

#include <QPaintEngine>
#include <QPainter>
#ifdef __SSE2__
#include <emmintrin.h>
#endif
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace tiller {

namespace {

constexpr int kOpaque = 255;
/// A column is drawn as a bar if its extent exceeds this multiple of its slope.
constexpr double kBand = 2;
/// If more than 1/kDenseShare of the columns of a curve have a larger change, the curve is dense. Its columns
/// are drawn as bars without slanted ends.
constexpr double kSteep = 6;  // [px]
constexpr std::size_t kDenseShare = 4;
/// Excess over the adjacent dashes above which a curve is also drawn between the dashes.
constexpr double kSpike = 3;  // [px]
/// Number of columns painted together.
constexpr std::size_t kBlock = 16;

/// Returns the colour multiplied by coverages 0 ... 255, premultiplied.
std::array<QRgb, kOpaque + 1> shadesOf(const QColor& color) {
    std::array<QRgb, kOpaque + 1> out{};
    for (int i = 0; i <= kOpaque; ++i) {
        out[static_cast<std::size_t>(i)] =
            qPremultiply(qRgba(color.red(), color.green(), color.blue(), i * color.alpha() / kOpaque));
    }
    return out;
}

/// Composites `above` over `below`. Both are premultiplied.
QRgb over(QRgb above, QRgb below) {
    // Process two channels at a time, with 16 bits each.
    constexpr QRgb kTwo = 0x00FF00FF;
    constexpr QRgb kHalf = 0x00800080;
    const auto rest = static_cast<QRgb>(kOpaque - qAlpha(above));
    const auto parts = [rest](QRgb two) {
        const QRgb product = two * rest + kHalf;
        return (product + (product >> 8 & kTwo)) >> 8 & kTwo;  // divided by 255, rounded
    };
    return above + parts(below & kTwo) + (parts(below >> 8 & kTwo) << 8);
}

void fill(QRgb* pixel, int count, QRgb color) {
#ifdef __SSE2__
    const __m128i four = _mm_set1_epi32(static_cast<int>(color));
    for (; count >= 4; count -= 4, pixel += 4) {
        _mm_storeu_si128(reinterpret_cast<__m128i*>(pixel), four);
    }
#endif
    std::fill_n(pixel, count, color);
}

/// Transposes four columns of four pixels into four rows. columnPitch and rowPitch are the strides.
void transposeFour(const QRgb* columns, std::ptrdiff_t columnPitch, QRgb* rows, std::ptrdiff_t rowPitch) {
#ifdef __SSE2__
    const auto load = [&](int i) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(columns + i * columnPitch));
    };
    const auto store = [&](int i, __m128i four) {
        _mm_storeu_si128(reinterpret_cast<__m128i*>(rows + i * rowPitch), four);
    };
    const __m128i low01 = _mm_unpacklo_epi32(load(0), load(1));
    const __m128i low23 = _mm_unpacklo_epi32(load(2), load(3));
    const __m128i high01 = _mm_unpackhi_epi32(load(0), load(1));
    const __m128i high23 = _mm_unpackhi_epi32(load(2), load(3));
    store(0, _mm_unpacklo_epi64(low01, low23));
    store(1, _mm_unpackhi_epi64(low01, low23));
    store(2, _mm_unpacklo_epi64(high01, high23));
    store(3, _mm_unpackhi_epi64(high01, high23));
#else
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            rows[y * rowPitch + x] = columns[x * columnPitch + y];
        }
    }
#endif
}

}  // namespace

CurveRaster::CurveRaster(const std::vector<std::unique_ptr<Curve>>& curves, QGraphicsItem* parent, bool right)
    : QGraphicsItem(parent), curves_(curves), right_(right) {
    setAcceptedMouseButtons(Qt::NoButton);
}

std::size_t CurveRaster::place(std::int64_t column) const {
    const std::int64_t width = ring_.width();
    return static_cast<std::size_t>((column % width + width) % width);
}

void CurveRaster::setView(const QRectF& area, double t0, double t1, double y0, double y1) {
    columnsPainted_ = 0;
    if (area != area_) {
        prepareGeometryChange();
        area_ = area;
    }
    t0_ = t0;
    t1_ = t1;
    y0_ = y0;
    y1_ = y1;
    const auto found = std::find_if(curves_.begin(), curves_.end(),
                                    [](const auto& curve) { return !curve->columns().empty(); });
    const std::size_t columns = found == curves_.end() ? 0 : (*found)->columns().size();
    if (columns == 0 || !(t1 > t0) || !(y1 > y0)) {
        painted_ = {};
        ring_ = {};
        update();
        return;
    }
    // In the following code, the unit is one column of the grid, which is one device pixel wide. Rows have
    // the same size.
    const double width = (*found)->columnWidth();
    const double pitch = width * area_.width() / (t1_ - t0_);
    Painted now{width,
                y0,
                y1,
                QSize(static_cast<int>(columns), static_cast<int>(std::ceil(area_.height() / pitch))),
                {}};
    for (const auto& curve : curves_) {
        now.offsets.push_back(includes(*curve) ? curve->offset() : std::numeric_limits<double>::infinity());
    }
    const std::int64_t raster = (*found)->raster();
    const bool keeps = !std::exchange(isOutdated_, false) && painted_ == now &&
                       std::abs(raster - raster_) < static_cast<std::int64_t>(columns);
    // Use an odd number of cache lines as the stride, so that the rows of a column do not all map to the same
    // cache set.
    constexpr int kCacheLine = 16;  // pixels
    const int lines = (now.size.width() + kCacheLine - 1) / kCacheLine;
    if (const QSize wide((lines | 1) * kCacheLine, now.size.height()); ring_.size() != wide) {
        ring_ = QImage(wide, QImage::Format_ARGB32_Premultiplied);
    }
    std::vector<std::uint8_t> wanted(columns, keeps ? 0 : 1);
    if (keeps) {
        const std::int64_t moved = raster - raster_;
        for (std::size_t i = 0; i < columns; ++i) {
            const std::int64_t then = static_cast<std::int64_t>(i) + moved;
            wanted[i] = then < 0 || then >= static_cast<std::int64_t>(columns) ? 1 : 0;
        }
        for (const auto& curve : curves_) {
            const bool counts = includes(*curve) && curve->columns().size() == columns;
            for (std::size_t i = 0; counts && i < columns; ++i) {
                wanted[i] = wanted[i] != 0 || curve->hasChanged(i) ? 1 : 0;
            }
        }
    }
    raster_ = raster;
    painted_ = std::move(now);
    columnsPainted_ = static_cast<int>(std::count(wanted.begin(), wanted.end(), 1));
    paintColumns(wanted, pitch);
    update();
}

void CurveRaster::paintColumns(const std::vector<std::uint8_t>& wanted, double pitch) {
    const double perUnit = area_.height() / pitch / (y1_ - y0_);
    const double bottom = area_.height() / pitch;
    std::vector<std::array<QRgb, kOpaque + 1>> shades;
    std::vector<const Curve*> drawn;
    std::vector<std::uint8_t> dense;
    for (const auto& curve : curves_) {
        if (!includes(*curve) || curve->range().isEmpty() || curve->columns().size() != wanted.size()) {
            continue;
        }
        drawn.push_back(curve.get());
        shades.push_back(shadesOf(curve->pen().color()));
        const auto steep =
            std::count_if(curve->columns().begin(), curve->columns().end(), [&](const Curve::Column& column) {
                return std::abs(column.right - column.left) * perUnit > kSteep;
            });
        dense.push_back(static_cast<std::size_t>(steep) > wanted.size() / kDenseShare ? 1 : 0);
    }
    std::vector<std::uint8_t> dashes(drawn.size() * wanted.size());
    for (std::size_t c = 0; c < drawn.size(); ++c) {
        drawn[c]->findDrawn(std::span(dashes).subspan(c * wanted.size(), wanted.size()), kSpike / perUnit);
    }
    // For cache locality, paint all curves in a block of columns before the next block, each column from top
    // to bottom. Then transpose the block into the rows of the image.
    for (std::size_t begin = 0; begin < wanted.size(); begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, wanted.size());
        if (std::none_of(&wanted[begin], &wanted[begin] + (end - begin),
                         [](std::uint8_t each) { return each != 0; })) {
            continue;
        }
        block_.assign(kBlock * static_cast<std::size_t>(blockPitch()), 0);
        for (std::size_t c = 0; c < drawn.size(); ++c) {
            for (std::size_t i = begin; i < end; ++i) {
                if (wanted[i] != 0 && !drawn[c]->columns()[i].isEmpty() &&
                    dashes[c * wanted.size() + i] != 0) {
                    paintColumn(*drawn[c], i, perUnit, bottom, dense[c] != 0, shades[c].data(),
                                &block_[(i - begin) * static_cast<std::size_t>(blockPitch())]);
                }
            }
        }
        keepBlock(std::span(wanted).subspan(begin, end - begin), begin);
    }
}

std::ptrdiff_t CurveRaster::blockPitch() const {
    // Use whole groups of four rows. An odd number of groups prevents the columns from evicting each other
    // from the cache.
    return ((ring_.height() + 3) / 4 | 1) * std::ptrdiff_t{4};
}

void CurveRaster::keepBlock(std::span<const std::uint8_t> wanted, std::size_t first) {
    const std::ptrdiff_t stride = ring_.bytesPerLine() / static_cast<std::ptrdiff_t>(sizeof(QRgb));
    auto* const ring = reinterpret_cast<QRgb*>(ring_.bits());
    const std::ptrdiff_t pitch = blockPitch();
    const int rows = ring_.height();
    for (std::size_t i = 0; i < wanted.size();) {
        const std::size_t x = place(raster_ + static_cast<std::int64_t>(first + i));
        const QRgb* const column = &block_[i * static_cast<std::size_t>(pitch)];
        const bool four = i + 4 <= wanted.size() && x + 4 <= static_cast<std::size_t>(ring_.width()) &&
                          wanted[i] != 0 && wanted[i + 1] != 0 && wanted[i + 2] != 0 && wanted[i + 3] != 0;
        int y = 0;
        for (; four && y + 4 <= rows; y += 4) {
            transposeFour(column + y, pitch, ring + y * stride + static_cast<std::ptrdiff_t>(x), stride);
        }
        const std::size_t count = four ? 4 : 1;
        for (; wanted[i] != 0 && y < rows; ++y) {
            for (std::size_t k = 0; k < count; ++k) {
                ring[y * stride + static_cast<std::ptrdiff_t>(x + k)] =
                    column[static_cast<std::ptrdiff_t>(k) * pitch + y];
            }
        }
        i += count;
    }
}

void CurveRaster::paintColumn(const Curve& curve, std::size_t at, double perUnit, double bottom, bool isDense,
                              const QRgb* shades, QRgb* pixels) const {
    // Draw a slanted line through the column. Its thickness is the pen width plus the extent of the curve.
    // The coverage of a pixel follows from the intersections of the two edges of the line with the column.
    const Curve::Column& column = curve.columns()[at];
    const double half = curve.pen().widthF() / 2;
    const double zero = bottom + (y0_ + curve.offset()) * perUnit;
    const auto rowOf = [&](double value) { return zero - value * perUnit; };
    const double slant = std::abs(column.right - column.left) * perUnit;
    const double extent = (column.high - column.low) * perUnit;
    const auto rows = static_cast<double>(ring_.height());
    const QRgb full = shades[kOpaque];
    const auto paintFull = [&](int begin, int end) {
        if (qAlpha(full) == kOpaque) {
            fill(pixels + begin, end - begin, full);
        } else {
            std::transform(pixels + begin, pixels + end, pixels + begin,
                           [full](QRgb below) { return over(full, below); });
        }
    };
    // A huge or infinite value would overflow the numbers below, so draw a vertical line.
    constexpr double kMaxRows = 1e9;
    const double top = rowOf(column.high);
    const double base = rowOf(column.low);
    if (!(std::abs(top) + std::abs(base) + slant + extent < kMaxRows)) {
        if (top < rows && base > 0) {
            paintFull(static_cast<int>(std::max(top, 0.0)), static_cast<int>(std::min(base, rows)));
        }
        return;
    }
    // In noisy columns, slanted ends are not visible. Horizontal ends avoid computing each row, and the
    // extent remains the same.
    const bool isBand = isDense || extent > kBand * slant;
    const double thickness =
        isBand ? half + extent / 2 : half * std::sqrt(1 + slant * slant) + std::max(0.0, extent - slant) / 2;
    // Centre the line on the extent of the curve.
    const double middle = (base + top) / 2;
    const double ramp = isBand ? 1.0 : std::max(slant, 1.0);
    // A steep line covers many rows of its column. Limit the painted rows to the extent of the curve plus the
    // pen width.
    constexpr double kRounding = 1e-6;
    const double upper = top - curve.pen().widthF() + kRounding;
    const double lower = base + curve.pen().widthF() - kRounding;
    // For non-negative values, truncation equals floor() and avoids a function call.
    const auto floorRow = [rows](double y) { return static_cast<int>(std::min(std::max(y, 0.0), rows)); };
    const auto ceilRow = [rows](double y) {
        const double inside = std::min(std::max(y, 0.0), rows);
        const auto whole = static_cast<int>(inside);
        return whole + (inside > whole ? 1 : 0);
    };
    const int from = floorRow(std::max(middle - ramp / 2 - thickness, upper));
    const int to = std::max(ceilRow(std::min(middle + ramp / 2 + thickness + 1, lower)), from);
    // Most rows of a noisy signal are fully covered and need no arithmetic.
    const int fullFrom = std::clamp(ceilRow(middle + ramp / 2 - thickness), from, to);
    const int fullTo = std::clamp(floorRow(middle - ramp / 2 + thickness), fullFrom, to);
    // The coverage is a linear function of the row number. Compute it incrementally in units of 1/65536.
    constexpr int kWhole = 1 << 16;
    // This value is larger than any row number, but small enough that the incremental value does not
    // overflow.
    constexpr double kFar = 20000;
    const double perRow = 1 / ramp;
    const auto step = static_cast<int>(kWhole * perRow);
    const auto passed = [&](double edge, int y) {
        return static_cast<int>(std::clamp((y + 0.5 - edge) * perRow + 0.5, -kFar, kFar) * kWhole);
    };
    const auto paintRows = [&](int begin, int end) {
        int above = passed(middle - thickness, begin);
        int below = passed(middle + thickness, begin);
        for (QRgb* pixel = pixels + begin; pixel < pixels + end; ++pixel, above += step, below += step) {
            const int covered = std::clamp(above, 0, kWhole) - std::clamp(below, 0, kWhole);
            *pixel = over(shades[(covered * kOpaque + kWhole / 2) >> 16], *pixel);
        }
    };
    paintRows(from, fullFrom);
    paintFull(fullFrom, fullTo);
    paintRows(fullTo, to);
}

void CurveRaster::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (ring_.isNull()) {
        return;
    }
    painter->setClipRect(area_, Qt::IntersectClip);
    const QPaintEngine::Type device = painter->paintEngine()->type();
    if (device == QPaintEngine::SVG || device == QPaintEngine::Pdf) {
        // Vector formats are not time-critical, so use Qt's stroker.
        painter->setBrush(Qt::NoBrush);
        for (const auto& curve : curves_) {
            if (includes(*curve)) {
                painter->setPen(curve->pen());
                painter->drawPath(curve->path(area_, t0_, t1_, y0_, y1_));
            }
        }
        return;
    }
    // Shift the image by whole pixels only. Resampling would blur the curve and make it flicker during
    // motion.
    double pitch = painted_.columnWidth * area_.width() / (t1_ - t0_);
    constexpr double kRounding = 1e-6;
    if (std::abs(pitch - 1) < kRounding) {
        pitch = 1;  // avoid scaling because of a rounding error
    }
    const double x =
        std::round(static_cast<double>(raster_) - t0_ / painted_.columnWidth) * pitch + area_.left();
    const double height = ring_.height() * pitch;
    const auto first = static_cast<int>(place(raster_));
    const int right = std::min(painted_.size.width(), ring_.width() - first);
    const int rest = painted_.size.width() - right;
    painter->drawImage(QRectF(x, area_.top(), right * pitch, height), ring_,
                       QRectF(first, 0, right, ring_.height()));
    if (rest > 0) {
        painter->drawImage(QRectF(x + right * pitch, area_.top(), rest * pitch, height), ring_,
                           QRectF(0, 0, rest, ring_.height()));
    }
}

}  // namespace tiller
