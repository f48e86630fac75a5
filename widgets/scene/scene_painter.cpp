// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/scene_painter.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace tiller {

namespace {

constexpr int kNamePixels = 14;

QColor mix(const QColor& a, const QColor& b, double share) {
    const auto channel = [share](int x, int y) { return static_cast<int>(std::lround(x + (y - x) * share)); };
    return {channel(a.red(), b.red()), channel(a.green(), b.green()), channel(a.blue(), b.blue())};
}

/// The outline of two discs and what lies between them.
QPolygonF hull(const QPointF& a, double ra, const QPointF& b, double rb) {
    const QPointF ab = b - a;
    const double length = std::hypot(ab.x(), ab.y());
    const double heading = std::atan2(ab.y(), ab.x());
    // Where the common tangents touch, as an angle from the line between the centres.
    const double touch = length > std::abs(ra - rb) ? std::acos((ra - rb) / length) : 0;
    QPolygonF outline;
    const auto arc = [&outline](const QPointF& centre, double radius, double from, double to) {
        const int steps = std::max(4, static_cast<int>(std::abs(to - from) * std::sqrt(radius) * 1.6));
        for (int i = 0; i <= steps; ++i) {
            const double angle = from + (to - from) * i / steps;
            outline.append(centre + QPointF(std::cos(angle), std::sin(angle)) * radius);
        }
    };
    if (length <= std::abs(ra - rb)) {
        // Seen end on: one disc hides the other.
        arc(ra > rb ? a : b, std::max(ra, rb), 0, 2 * std::numbers::pi);
        return outline;
    }
    arc(b, rb, heading - touch, heading + touch);
    arc(a, ra, heading + touch, heading + 2 * std::numbers::pi - touch);
    return outline;
}

}  // namespace

ArmColors ArmColors::live(const Theme& theme) {
    return theme.isDark()
               ? ArmColors{QColor(0x5F, 0x68, 0x70), QColor(0x8F, 0x97, 0x9F), QColor(0x4C, 0x86, 0xB5)}
               : ArmColors{QColor(0x6F, 0x79, 0x83), QColor(0xB7, 0xBD, 0xC4), QColor(0x3D, 0x6E, 0x94)};
}

ArmColors ArmColors::stale(const Theme& theme) {
    return {mix(theme.panel, theme.secondary, 0.38), mix(theme.panel, theme.secondary, 0.22),
            mix(theme.panel, theme.secondary, 0.5)};
}

ArmColors ArmColors::ghost(const Theme& theme) {
    const QColor color = mix(theme.panel, theme.moving, 0.35);
    return {color, color, color};
}

ScenePainter::ScenePainter(QPainter& painter, const Camera& camera, const Theme& theme)
    : painter_(painter), camera_(camera), theme_(theme) {
    painter_.setRenderHint(QPainter::Antialiasing);
}

void ScenePainter::ground(double reach) {
    const int cells = 3;
    const double cell = reach * 0.24;
    QPen pen(mix(theme_.panel, theme_.border, 0.62), 1);
    painter_.setPen(pen);
    for (int i = -cells; i <= cells; ++i) {
        const double at = i * cell;
        const double end = cells * cell;
        for (const auto& [from, to] :
             {std::pair(Eigen::Vector3d(at, -end, 0), Eigen::Vector3d(at, end, 0)),
              std::pair(Eigen::Vector3d(-end, at, 0), Eigen::Vector3d(end, at, 0))}) {
            const auto a = camera_.project(from);
            const auto b = camera_.project(to);
            if (a.visible() && b.visible()) {
                painter_.drawLine(a.point, b.point);
            }
        }
    }
}

void ScenePainter::capsule(const ArmPart& part, const QColor& color, bool outlined) {
    const auto a = camera_.project(part.from);
    const auto b = camera_.project(part.to);
    if (!a.visible() || !b.visible()) {
        return;
    }
    painter_.setPen(QPen(outlined ? color.darker(112) : color, 1));
    painter_.setBrush(color);
    painter_.drawPolygon(
        hull(a.point, part.radius * a.pixelsPerMetre, b.point, part.radius * b.pixelsPerMetre));
}

void ScenePainter::arm(std::span<const ArmPart> parts, const ArmColors& colors) {
    // Far parts first; so few that their middles are order enough.
    std::array<std::pair<double, std::size_t>, kArmPartCount> order{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < parts.size() && i < order.size(); ++i) {
        if (parts[i].meets == 0) {
            order[count++] = {camera_.project((parts[i].from + parts[i].to) / 2).depth, i};
        }
    }
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), std::greater<>());
    const bool outlined = colors.link != colors.joint;
    const auto draw = [&](const ArmPart& part) {
        capsule(part,
                part.kind == ArmPartKind::Joint  ? colors.joint
                : part.kind == ArmPartKind::Link ? colors.link
                                                 : colors.housing,
                outlined);
    };
    const Eigen::Vector3d towardsEye = camera_.viewRotation().col(2);
    unsigned drawn = 0;
    for (std::size_t n = 0; n < count; ++n) {
        const unsigned bit = 1U << order[n].second;
        for (const ArmPart& cap : parts) {
            // The first of the parts that meet here is about to be drawn: what lies under them all goes
            // first.
            if ((cap.meets & bit) != 0 && (cap.meets & drawn) == 0 && cap.outward.dot(towardsEye) < 0) {
                draw(cap);
            }
        }
        draw(parts[order[n].second]);
        drawn |= bit;
        for (const ArmPart& cap : parts) {
            if ((cap.meets & bit) != 0 && (cap.meets & ~drawn) == 0 && cap.outward.dot(towardsEye) >= 0) {
                draw(cap);
            }
        }
    }
}

QRectF ScenePainter::label(const QRectF& box, int flags, const QString& text, const QColor& color) {
    // Readable also over the arm: a thin rim in the colour of the surface.
    painter_.setPen(theme_.panel);
    for (const QPointF& by : {QPointF(-1.5, 0), QPointF(1.5, 0), QPointF(0, -1.5), QPointF(0, 1.5)}) {
        painter_.drawText(box.translated(by), flags, text);
    }
    painter_.setPen(color);
    QRectF drawn;
    painter_.drawText(box, flags, text, &drawn);
    return drawn;
}

void ScenePainter::path(std::span<const Eigen::Vector3d> points, const QColor& color, double width,
                        bool dashed) {
    QPolygonF line;
    for (const Eigen::Vector3d& p : points) {
        const auto at = camera_.project(p);
        if (at.visible()) {
            line.append(at.point);
        }
    }
    QPen pen(color, width);
    pen.setJoinStyle(Qt::RoundJoin);
    if (dashed) {
        pen.setDashPattern({3, 2.2});
    }
    painter_.setPen(pen);
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPolyline(line);
}

void ScenePainter::axes(const Eigen::Isometry3d& T_base_frame, double length, bool greyed) {
    static const std::array<QString, 3> kLetters = {QStringLiteral("X"), QStringLiteral("Y"),
                                                    QStringLiteral("Z")};
    const auto origin = camera_.project(T_base_frame.translation());
    if (!origin.visible()) {
        return;
    }
    // The axis that points away is drawn first.
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
        label(box, Qt::AlignLeft | Qt::AlignVCenter, text, theme_.secondary);
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
    // Above a level arrow, beside a steep one.
    const bool steep = std::abs(along.y()) > 0.6;
    const QRectF box = steep ? QRectF(middle.x() + 18, middle.y() - 12, 200, 24)
                             : QRectF(middle.x() - 100, middle.y() - 34, 200, 24);
    return label(box, (steep ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter, name, theme_.text);
}

}  // namespace tiller
