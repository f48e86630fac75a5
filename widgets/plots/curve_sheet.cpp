// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curve_sheet.h"

#include <QPaintEngine>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tiller {

namespace {

constexpr int kOpaque = 255;
/// A column that covers so many times what it slants is drawn as a bar.
constexpr double kBand = 2;
/// Where a curve rises or falls by more than this in many of its columns, it goes up and down within a few of them: it is
/// drawn as bars without slanting ends.
constexpr double kSteep = 6;  // [px]
constexpr std::size_t kDenseShare = 4;

/// Colour times coverage, premultiplied, for 0 ... 255.
std::array<QRgb, kOpaque + 1> shadesOf(const QColor& color) {
    std::array<QRgb, kOpaque + 1> out{};
    for (int i = 0; i <= kOpaque; ++i) {
        out[static_cast<std::size_t>(i)] =
            qPremultiply(qRgba(color.red(), color.green(), color.blue(), i * color.alpha() / kOpaque));
    }
    return out;
}

/// Premultiplied `above` over `below`.
QRgb over(QRgb above, QRgb below) {
    const auto rest = static_cast<QRgb>(kOpaque - qAlpha(above));
    const auto part = [rest](QRgb value) { return (value * rest + kOpaque / 2) / kOpaque; };
    return above + (part(below >> 24) << 24 | part(below >> 16 & 0xFF) << 16 | part(below >> 8 & 0xFF) << 8 |
                    part(below & 0xFF));
}

}  // namespace

CurveSheet::CurveSheet(const std::vector<std::unique_ptr<Curve>>& curves, QGraphicsItem* parent)
    : QGraphicsItem(parent), curves_(curves) {
    setAcceptedMouseButtons(Qt::NoButton);
}

std::size_t CurveSheet::place(std::int64_t column) const {
    const std::int64_t width = ring_.width();
    return static_cast<std::size_t>((column % width + width) % width);
}

void CurveSheet::setView(const QRectF& area, double t0, double t1, double y0, double y1) {
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
    // In columns of the grid from here on: they are device pixels, and rows are made as high as they are wide.
    const double width = (*found)->columnWidth();
    const double pitch = width * area_.width() / (t1_ - t0_);
    Painted now{width,
                y0,
                y1,
                QSize(static_cast<int>(columns), static_cast<int>(std::ceil(area_.height() / pitch))),
                {}};
    for (const auto& curve : curves_) {
        now.offsets.push_back(curve->isVisible() ? curve->offset() : std::numeric_limits<double>::infinity());
    }
    const std::int64_t raster = (*found)->raster();
    const bool keeps = painted_ == now && std::abs(raster - raster_) < static_cast<std::int64_t>(columns);
    // Lines of an odd number of cache lines: a column's pixels then do not push each other out of the cache.
    constexpr int kCacheLine = 16;  // pixels
    const int lines = (now.size.width() + kCacheLine - 1) / kCacheLine;
    if (const QSize wide((lines | 1) * kCacheLine, now.size.height()); ring_.size() != wide) {
        ring_ = QImage(wide, QImage::Format_ARGB32_Premultiplied);
    }
    if (!keeps) {
        ring_.fill(0);
    }
    std::vector<std::uint8_t> wanted(columns, keeps ? 0 : 1);
    if (keeps) {
        const std::int64_t moved = raster - raster_;
        for (std::size_t i = 0; i < columns; ++i) {
            const std::int64_t then = static_cast<std::int64_t>(i) + moved;
            wanted[i] = then < 0 || then >= static_cast<std::int64_t>(columns) ? 1 : 0;
        }
        for (const auto& curve : curves_) {
            const bool counts = curve->isVisible() && curve->columns().size() == columns;
            for (std::size_t i = 0; counts && i < columns; ++i) {
                wanted[i] = wanted[i] != 0 || curve->hasChanged(i) ? 1 : 0;
            }
        }
    }
    raster_ = raster;
    painted_ = std::move(now);
    columnsPainted_ = static_cast<int>(std::count(wanted.begin(), wanted.end(), 1));
    if (keeps && columnsPainted_ > 0) {
        for (std::size_t i = 0; i < columns; ++i) {
            if (wanted[i] != 0) {
                const std::size_t x = place(raster_ + static_cast<std::int64_t>(i));
                for (int y = 0; y < ring_.height(); ++y) {
                    reinterpret_cast<QRgb*>(ring_.scanLine(y))[x] = 0;
                }
            }
        }
    }
    paintColumns(wanted, pitch);
    update();
}

void CurveSheet::paintColumns(const std::vector<std::uint8_t>& wanted, double pitch) {
    const double perUnit = area_.height() / pitch / (y1_ - y0_);
    const double bottom = area_.height() / pitch;
    std::vector<std::array<QRgb, kOpaque + 1>> shades;
    std::vector<const Curve*> drawn;
    std::vector<std::uint8_t> dense;
    for (const auto& curve : curves_) {
        if (!curve->isVisible() || curve->range().isEmpty() || curve->columns().size() != wanted.size()) {
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
    // All curves of some columns before the next ones: what they cover stays in the cache.
    constexpr std::size_t kBlock = 16;
    for (std::size_t begin = 0; begin < wanted.size(); begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, wanted.size());
        for (std::size_t c = 0; c < drawn.size(); ++c) {
            for (std::size_t i = begin; i < end; ++i) {
                if (wanted[i] != 0 && !drawn[c]->columns()[i].isEmpty() && drawn[c]->isDrawn(i)) {
                    paintColumn(*drawn[c], i, perUnit, bottom, dense[c] != 0, shades[c].data());
                }
            }
        }
    }
}

void CurveSheet::paintColumn(const Curve& curve, std::size_t at, double perUnit, double bottom, bool isDense,
                             const QRgb* shades) {
    // A slanted stroke through the column, as thick as the pen and as what the curve does besides
    // slanting; how much of a pixel it covers follows from where its two edges cross the column.
    const Curve::Column& column = curve.columns()[at];
    const double half = curve.pen().widthF() / 2;
    const double origin = y0_ + curve.offset();
    const auto rowOf = [&](double value) { return bottom - (value - origin) * perUnit; };
    const double left = rowOf(column.left);
    const double right = rowOf(column.right);
    const double slant = std::abs(right - left);
    const double extent = rowOf(column.low) - rowOf(column.high);
    // Where a column is mostly noise its ends are level: nobody sees that they slant, and all the rows over which they
    // would have to be worked out one by one. The extent is the same to the last spike.
    const bool isBand = isDense || extent > kBand * slant;
    const double thickness =
        isBand ? half + extent / 2 : half * std::sqrt(1 + slant * slant) + std::max(0.0, extent - slant) / 2;
    // The stroke's middle is that of its extent, unless it only slants.
    const double middle = (rowOf(column.low) + rowOf(column.high)) / 2;
    const double ramp = isBand ? 1.0 : std::max(slant, 1.0);
    const int rows = ring_.height();
    const auto row = [rows](double y) {
        return static_cast<int>(std::clamp(y, 0.0, static_cast<double>(rows)));
    };
    const int from = row(std::floor(middle - ramp / 2 - thickness));
    const int to = row(std::ceil(middle + ramp / 2 + thickness) + 1);
    // Rows wholly covered need no arithmetic: most of them where the signal is noisy.
    const int fullFrom = std::clamp(row(std::ceil(middle + ramp / 2 - thickness)), from, to);
    const int fullTo = std::clamp(row(std::floor(middle - ramp / 2 + thickness)), fullFrom, to);
    const std::ptrdiff_t stride = ring_.bytesPerLine() / static_cast<std::ptrdiff_t>(sizeof(QRgb));
    QRgb* pixel = reinterpret_cast<QRgb*>(ring_.bits()) + from * stride +
                  static_cast<std::ptrdiff_t>(place(raster_ + static_cast<std::int64_t>(at)));
    // How much of a row is covered is linear in its number: it is counted up, in parts of 65536.
    constexpr int kWhole = 1 << 16;
    constexpr double kFar = 20000;  // beyond any row, and counted up from there still a number
    const auto step = static_cast<int>(kWhole / ramp);
    const auto passed = [&](double edge, int y) {
        return static_cast<int>(std::clamp((y + 0.5 - edge) / ramp + 0.5, -kFar, kFar) * kWhole);
    };
    const auto paintRows = [&](int begin, int end) {
        int above = passed(middle - thickness, begin);
        int below = passed(middle + thickness, begin);
        for (int y = begin; y < end; ++y, above += step, below += step, pixel += stride) {
            const int covered = std::clamp(above, 0, kWhole) - std::clamp(below, 0, kWhole);
            const QRgb shade = shades[(covered * kOpaque + kWhole / 2) >> 16];
            *pixel = *pixel == 0 ? shade : over(shade, *pixel);
        }
    };
    paintRows(from, fullFrom);
    const QRgb full = shades[kOpaque];
    const bool opaque = qAlpha(full) == kOpaque;
    for (int y = fullFrom; y < fullTo; ++y, pixel += stride) {
        *pixel = opaque ? full : over(full, *pixel);
    }
    paintRows(fullTo, to);
}

void CurveSheet::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (ring_.isNull()) {
        return;
    }
    painter->setClipRect(area_, Qt::IntersectClip);
    const QPaintEngine::Type device = painter->paintEngine()->type();
    if (device == QPaintEngine::SVG || device == QPaintEngine::Pdf) {
        // There is time for Qt's stroker.
        painter->setBrush(Qt::NoBrush);
        for (const auto& curve : curves_) {
            if (curve->isVisible()) {
                painter->setPen(curve->pen());
                painter->drawPath(curve->path(area_, t0_, t1_, y0_, y1_));
            }
        }
        return;
    }
    // Whole pixels only: resampling would blur the curve and make it shimmer while it moves.
    double pitch = painted_.columnWidth * area_.width() / (t1_ - t0_);
    constexpr double kRounding = 1e-6;
    if (std::abs(pitch - 1) < kRounding) {
        pitch = 1;  // a picture of its own size is copied, any other one is stretched
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
