// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/scene_painter.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tiller {

namespace {

constexpr int kNamePixels = 14;

QColor mix(const QColor& a, const QColor& b, double share) {
    const auto channel = [share](int x, int y) { return static_cast<int>(std::lround(x + (y - x) * share)); };
    return {channel(a.red(), b.red()), channel(a.green(), b.green()), channel(a.blue(), b.blue())};
}

}  // namespace

ScenePainter::ScenePainter(QPainter& painter, const Camera& camera, const Theme& theme)
    : painter_(painter), camera_(camera), theme_(theme) {
    painter_.setRenderHint(QPainter::Antialiasing);
}

void ScenePainter::ground(double reach, double height, bool solid) {
    const int cells = 3;
    const double cell = reach * 0.24;
    if (solid) {
        const double edge = cells * cell;
        QPolygonF plane;
        for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
            if (const auto at = camera_.project({x * edge, y * edge, height}); at.visible()) {
                plane << at.point;
            }
        }
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(mix(theme_.panel, theme_.border, 0.3));
        painter_.drawPolygon(plane);
        painter_.setBrush(Qt::NoBrush);
    }
    QPen pen(mix(theme_.panel, theme_.border, 0.62), 1);
    painter_.setPen(pen);
    for (int i = -cells; i <= cells; ++i) {
        const double at = i * cell;
        const double end = cells * cell;
        for (const auto& [from, to] :
             {std::pair(Eigen::Vector3d(at, -end, height), Eigen::Vector3d(at, end, height)),
              std::pair(Eigen::Vector3d(-end, at, height), Eigen::Vector3d(end, at, height))}) {
            const auto a = camera_.project(from);
            const auto b = camera_.project(to);
            if (a.visible() && b.visible()) {
                painter_.drawLine(a.point, b.point);
            }
        }
    }
}

QRectF ScenePainter::label(const QRectF& box, int flags, const QString& text, const QColor& color) {
    // A thin outline in the background colour makes the text legible over the arm.
    painter_.setPen(theme_.panel);
    for (const QPointF& by : {QPointF(-1.5, 0), QPointF(1.5, 0), QPointF(0, -1.5), QPointF(0, 1.5)}) {
        painter_.drawText(box.translated(by), flags, text);
    }
    painter_.setPen(color);
    QRectF drawn;
    painter_.drawText(box, flags, text, &drawn);
    return drawn;
}

void ScenePainter::path(std::span<const Eigen::Vector3d> points, const Stroke& stroke, const Hides& hides) {
    constexpr double kPiece = 6;     // step along a line between two visibility checks [px]
    constexpr int kMaxPieces = 400;  // maximum number of steps per line
    constexpr double kFaint = 0.28;
    const auto draw = [&](const QPolygonF& line, bool hidden) {
        if (line.size() < 2) {
            return;
        }
        QColor color = stroke.color;
        color.setAlphaF(static_cast<float>(hidden ? kFaint : 1.0) * color.alphaF());
        QPen pen(color, stroke.width);
        pen.setJoinStyle(Qt::RoundJoin);
        pen.setCapStyle(Qt::FlatCap);
        if (stroke.dashed) {
            pen.setDashPattern({3, 2.2});
        }
        painter_.setPen(pen);
        painter_.drawPolyline(line);
    };
    painter_.setBrush(Qt::NoBrush);
    QPolygonF line;
    bool hidden = false;
    const auto visit = [&](const Camera::Projected& at) {
        if (!at.visible()) {
            draw(line, hidden);
            line.clear();
            return;
        }
        const bool now = hides(at);
        line.append(at.point);
        if (now != hidden) {
            draw(line, hidden);
            line = QPolygonF{at.point};
            hidden = now;
        }
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) {
            const auto a = camera_.project(points[i - 1]);
            const auto b = camera_.project(points[i]);
            const QPointF way = b.point - a.point;
            const int pieces =
                a.visible() && b.visible()
                    ? std::min(kMaxPieces, static_cast<int>(std::hypot(way.x(), way.y()) / kPiece))
                    : 0;
            for (int k = 1; k < pieces; ++k) {
                visit(camera_.project(points[i - 1] + (points[i] - points[i - 1]) * k / pieces));
            }
        }
        visit(camera_.project(points[i]));
    }
    draw(line, hidden);
}

void ScenePainter::limit(const QPointF& at) {
    constexpr double kHalf = 7;
    painter_.setPen(QPen(theme_.panel, 2));
    painter_.setBrush(theme_.warning);
    const QPointF corners[] = {at + QPointF(0, -kHalf - 1), at + QPointF(kHalf + 1, kHalf - 1),
                               at + QPointF(-kHalf - 1, kHalf - 1)};
    painter_.drawPolygon(corners, 3);
    painter_.setPen(QPen(theme_.panel, 1.6));
    painter_.drawLine(at + QPointF(0, -2.5), at + QPointF(0, 1.5));
    painter_.drawPoint(at + QPointF(0, 4));
}

void ScenePainter::axes(const Eigen::Isometry3d& T_base_frame, double length, bool greyed) {
    static const std::array<QString, 3> kLetters = {QStringLiteral("X"), QStringLiteral("Y"),
                                                    QStringLiteral("Z")};
    const auto origin = camera_.project(T_base_frame.translation());
    if (!origin.visible()) {
        return;
    }
    // Draw the axes from back to front.
    std::array<int, 3> order = {0, 1, 2};
    std::array<Camera::Projected, 3> tips;
    for (int i = 0; i < 3; ++i) {
        tips[static_cast<std::size_t>(i)] =
            camera_.project(T_base_frame.translation() + T_base_frame.linear().col(i) * length);
    }
    const auto tip = [&tips](int i) -> const Camera::Projected& { return tips[static_cast<std::size_t>(i)]; };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return tip(a).depth > tip(b).depth; });
    painter_.setFont(textFont(12, QFont::Bold));
    for (const int i : order) {
        if (!tip(i).visible()) {
            continue;
        }
        const QColor color = greyed ? theme_.secondary : theme_.axis(i);
        painter_.setPen(QPen(color, 4, Qt::SolidLine, Qt::RoundCap));
        painter_.drawLine(origin.point, tip(i).point);
        QPointF out = tip(i).point - origin.point;
        const double n = std::hypot(out.x(), out.y());
        out = n > 4 ? out / n : QPointF(0.7, -0.7);
        const QPointF at = tip(i).point + out * 11;
        painter_.setPen(color);
        painter_.drawText(QRectF(at.x() - 10, at.y() - 10, 20, 20), Qt::AlignCenter,
                          kLetters[static_cast<std::size_t>(i)]);
    }
}

void ScenePainter::marker(const QPointF& at, bool selected) {
    painter_.setPen(QPen(selected ? theme_.moving : theme_.secondary, selected ? 2 : 1.4));
    painter_.setBrush(theme_.panel);
    painter_.drawEllipse(at, selected ? 4.5 : 3.5, selected ? 4.5 : 3.5);
}

QSizeF ScenePainter::nameSize(QString& text) {
    constexpr double kLongest = 200;
    const QFontMetricsF metrics(textFont(kNamePixels));
    text = metrics.elidedText(text, Qt::ElideRight, kLongest);
    return {metrics.horizontalAdvance(text) + 2, metrics.height()};
}

void ScenePainter::name(const PlacedLabel& name) {
    const double away = std::max(name.box.top() - name.mark.y(), name.mark.y() - name.box.bottom());
    if (away > name.box.height()) {
        const double end = name.box.top() > name.mark.y() ? name.box.top() : name.box.bottom();
        painter_.setPen(QPen(theme_.border, 1));
        painter_.drawLine(name.mark, QPointF(name.mark.x(), end));
    }
    painter_.setFont(textFont(kNamePixels));
    label(name.box, Qt::AlignCenter | Qt::TextDontClip, name.text,
          name.selected ? theme_.text : theme_.secondary);
}

void ScenePainter::headline(const QRectF& box, const QString& text) {
    painter_.setFont(textFont(26, QFont::Bold));
    label(box, Qt::AlignCenter, text, theme_.secondary);
}

void ScenePainter::note(const QRectF& box, const QString& text) {
    if (!text.isEmpty()) {
        painter_.setFont(textFont(13));
        label(box, Qt::AlignLeft | Qt::AlignVCenter,
              painter_.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(box.width())),
              theme_.secondary);
    }
}

QRectF ScenePainter::arrow(const Eigen::Vector3d& tcp, const Eigen::Vector3d& direction, double reach,
                           const QColor& color, const QString& name) {
    if (direction.norm() < 1e-9) {
        return {};
    }
    const Eigen::Vector3d d = direction.normalized();
    const auto from = camera_.project(tcp + d * (0.19 * reach));
    const auto to = camera_.project(tcp + d * (0.45 * reach));
    if (!from.visible() || !to.visible()) {
        return {};
    }
    const QPointF line = to.point - from.point;
    const double length = std::hypot(line.x(), line.y());
    painter_.setFont(textFont(16));
    painter_.setBrush(Qt::NoBrush);
    if (length < 22) {
        const QPointF at = camera_.project(tcp).point + QPointF(0, 44);
        painter_.setPen(QPen(color, 3));
        painter_.drawEllipse(at, 12, 12);
        if (to.depth < from.depth) {
            painter_.setBrush(color);
            painter_.drawEllipse(at, 3, 3);
        } else {
            painter_.drawLine(at + QPointF(-7, -7), at + QPointF(7, 7));
            painter_.drawLine(at + QPointF(-7, 7), at + QPointF(7, -7));
        }
        return label(QRectF(at.x() + 20, at.y() - 12, 200, 24), Qt::AlignLeft | Qt::AlignVCenter, name,
                     theme_.text);
    }
    const QPointF along = line / length;
    const QPointF across(-along.y(), along.x());
    painter_.setPen(QPen(color, 5, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter_.drawLine(from.point, to.point);
    const QPointF wings[] = {to.point - along * 18 + across * 10, to.point + along * 2,
                             to.point - along * 18 - across * 10};
    painter_.drawPolyline(wings, 3);
    const QPointF middle = (from.point + to.point) / 2;
    // Place the label above a horizontal arrow, or next to a steep arrow.
    const bool steep = std::abs(along.y()) > 0.6;
    const QRectF box = steep ? QRectF(middle.x() + 18, middle.y() - 12, 200, 24)
                             : QRectF(middle.x() - 100, middle.y() - 34, 200, 24);
    return label(box, (steep ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter, name, theme_.text);
}

QRectF ScenePainter::turn(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double radius,
                          const QColor& color, const QString& name) {
    if (axis.norm() < 1e-9) {
        return {};
    }
    constexpr int kPieces = 36;
    constexpr double kArc = 4.9;  // [rad]; less than a full circle, so that start and end are visible
    const Eigen::Vector3d u = axis.normalized().unitOrthogonal();
    const Eigen::Vector3d v = axis.normalized().cross(u);
    QPolygonF line;
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = kArc * i / kPieces;
        const auto at = camera_.project(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
        if (!at.visible()) {
            return {};
        }
        line.append(at.point);
    }
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(color, 4, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter_.drawPolyline(line);
    const QPointF tip = line.last();
    const QPointF way = tip - line[line.size() - 4];
    const double length = std::max(1e-6, std::hypot(way.x(), way.y()));
    const QPointF along = way / length;
    const QPointF across(-along.y(), along.x());
    painter_.setPen(QPen(color, 4, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    const QPointF wings[] = {tip - along * 13 + across * 9, tip + along * 3, tip - along * 13 - across * 9};
    painter_.drawPolyline(wings, 3);
    painter_.setFont(textFont(16));
    const QRectF round = line.boundingRect();
    return label(QRectF(round.right() + 10, round.center().y() - 12, 200, 24),
                 Qt::AlignLeft | Qt::AlignVCenter, name, theme_.text);
}

}  // namespace tiller
