// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/analysis_canvas.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "robot/station/text/format.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr double kRoomLeft = 64;  // space for the labels of the vertical axis [px]
constexpr double kRoomBelow = 36;
constexpr double kRoomAround = 10;
constexpr qsizetype kSmooth = 4000;  // curves with more points are drawn without antialiasing

/// Returns 1, 2 or 5 times a power of ten, so that at most `most` steps fit in the span.
double roundStep(double span, double most) {
    const double rough = span / std::max(most, 1.0);
    const double power = std::pow(10, std::floor(std::log10(rough)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * power >= rough) {
            return step * power;
        }
    }
    return 10 * power;
}

void scaleTo(AnalysisCanvas::Axis& axis, double low, double high) {
    constexpr double kMargin = 0.04;
    const double span = high > low ? high - low : std::max(std::abs(high), 1.0) * 0.1;
    axis.low = low - kMargin * span;
    axis.high = high + kMargin * span;
}

}  // namespace

AnalysisCanvas::AnalysisCanvas(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("plots.analysis.canvas"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void AnalysisCanvas::show(const QVector<QPointF>& points, const QString& xTitle, const QString& yTitle,
                          const QString& message) {
    points_ = points;
    message_ = message;
    x_.title = xTitle;
    y_.title = yTitle;
    if (!points_.isEmpty()) {
        const auto [left, right] =
            std::minmax_element(points_.cbegin(), points_.cend(),
                                [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
        const auto [bottom, top] =
            std::minmax_element(points_.cbegin(), points_.cend(),
                                [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
        scaleTo(x_, left->x(), right->x());
        scaleTo(y_, bottom->y(), top->y());
    }
    setAccessibleDescription(message);
    update();
}

QRectF AnalysisCanvas::area() const {
    return QRectF(rect()).adjusted(kRoomLeft, kRoomAround, -kRoomAround, -kRoomBelow);
}

void AnalysisCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme& theme = Theme::current();
    const QRectF area = this->area();
    painter.setFont(textFont(12));
    painter.setPen(theme.secondary);
    if (points_.isEmpty() || area.width() < 20 || area.height() < 20) {
        painter.drawText(rect().adjusted(12, 0, -12, 0), Qt::AlignCenter | Qt::TextWordWrap, message_);
        return;
    }
    constexpr double kPixelsPerLabel = 90;
    constexpr double kPixelsPerLine = 34;
    const auto digitsOf = [](double step) {
        return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    };
    const double xStep = roundStep(x_.high - x_.low, area.width() / kPixelsPerLabel);
    const double yStep = roundStep(y_.high - y_.low, area.height() / kPixelsPerLine);
    const auto xAt = [&](double value) {
        return area.left() + (value - x_.low) / (x_.high - x_.low) * area.width();
    };
    const auto yAt = [&](double value) {
        return area.bottom() - (value - y_.low) / (y_.high - y_.low) * area.height();
    };
    for (double value = std::ceil(x_.low / xStep) * xStep; value <= x_.high; value += xStep) {
        painter.setPen(theme.border);
        painter.drawLine(QPointF(xAt(value), area.top()), QPointF(xAt(value), area.bottom()));
        painter.setPen(theme.secondary);
        painter.drawText(QRectF(xAt(value) - 40, area.bottom() + 2, 80, 16), Qt::AlignHCenter | Qt::AlignTop,
                         format::number(value, digitsOf(xStep)));
    }
    for (double value = std::ceil(y_.low / yStep) * yStep; value <= y_.high; value += yStep) {
        painter.setPen(theme.border);
        painter.drawLine(QPointF(area.left(), yAt(value)), QPointF(area.right(), yAt(value)));
        painter.setPen(theme.secondary);
        painter.drawText(QRectF(0, yAt(value) - 8, area.left() - 6, 16), Qt::AlignRight | Qt::AlignVCenter,
                         format::number(value, digitsOf(yStep)));
    }
    painter.drawText(QRectF(area.left(), area.bottom() + 17, area.width(), 17), Qt::AlignRight | Qt::AlignTop,
                     x_.title);
    painter.drawText(QRectF(area.left() + 6, area.top(), area.width() - 6, 17), Qt::AlignLeft | Qt::AlignTop,
                     y_.title);
    QPolygonF line;
    line.reserve(points_.size());
    for (const QPointF& point : points_) {
        line << QPointF(xAt(point.x()), yAt(point.y()));
    }
    painter.setClipRect(area);
    painter.setRenderHint(QPainter::Antialiasing, points_.size() < kSmooth);
    painter.setPen(QPen(theme.curves[0], points_.size() < kSmooth ? 1.6 : 1));
    painter.drawPolyline(line);
}

}  // namespace tiller

#include "moc_analysis_canvas.cpp"
