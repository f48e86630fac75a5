// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The strokes the scene is made of: ground, axes, paths, arrows and names, seen through a camera.

#include <Eigen/Geometry>
#include <QColor>
#include <QString>
#include <functional>
#include <span>

#include "widgets/common/theme.h"
#include "widgets/scene/camera.h"
#include "widgets/scene/label_placer.h"

class QPainter;

namespace tiller {

class ScenePainter {
public:
    /// Whether a body lies in front of a place.
    using Hides = std::function<bool(const Camera::Projected&)>;

    ScenePainter(QPainter& painter, const Camera& camera, const Theme& theme);

    /// A grid around the base, wide enough for an arm of this reach.
    /// reach, height  [m]
    /// solid  the floor of a cell: a plane that the arm stays above; else only lines
    void ground(double reach, double height, bool solid);
    /// How a line in space is drawn.
    struct Stroke {
        QColor color;
        double width = 1;
        bool dashed = false;
    };
    /// A line through points in the base frame; where something hides it, it is faint.
    void path(std::span<const Eigen::Vector3d> points, const Stroke& stroke, const Hides& hides);
    /// Where a way meets a limit: a sign that cannot be taken for a waypoint.
    void limit(const QPointF& at);
    /// Three axes with their letters.
    void axes(const Eigen::Isometry3d& T_base_frame, double length, bool greyed);
    /// A point.
    void marker(const QPointF& at, bool selected);
    void name(const PlacedLabel& name);
    /// A word that cannot be overlooked, in the middle of the box.
    void headline(const QRectF& box, const QString& text);
    /// A line of small words; nothing when there are none.
    void note(const QRectF& box, const QString& text);
    /// The size of a name, shortened to what is drawn of it.
    static QSizeF nameSize(QString& text);
    /// An arrow beside the tool; end on, a ring with a dot (towards the eye) or a cross (away).
    /// Returns  where its name is
    QRectF arrow(const Eigen::Vector3d& tcp, const Eigen::Vector3d& direction, double reach,
                 const QColor& color, const QString& name);
    /// An arrow around an axis, the way a turn about it goes (right hand).
    /// radius   of the turn [m]
    /// Returns  where its name is
    QRectF turn(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double radius,
                const QColor& color, const QString& name);

private:
    QRectF label(const QRectF& box, int flags, const QString& text, const QColor& color);

    QPainter& painter_;
    const Camera& camera_;
    const Theme& theme_;
};

}  // namespace tiller
