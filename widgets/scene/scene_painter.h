// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The strokes the scene is made of: ground, arm, axes, paths, arrows and names, seen through a camera.

#include <Eigen/Geometry>
#include <QColor>
#include <QString>
#include <span>

#include "widgets/common/theme.h"
#include "widgets/scene/arm_shape.h"
#include "widgets/scene/camera.h"
#include "widgets/scene/label_placer.h"

class QPainter;

namespace tiller {

/// What an arm is painted with.
struct ArmColors {
    QColor housing;
    QColor link;
    QColor joint;

    static ArmColors live(const Theme& theme);
    static ArmColors stale(const Theme& theme);
    static ArmColors ghost(const Theme& theme);
};

class ScenePainter {
public:
    ScenePainter(QPainter& painter, const Camera& camera, const Theme& theme);

    /// A grid around the base, wide enough for an arm of this reach [m].
    void ground(double reach);
    void arm(std::span<const ArmPart> parts, const ArmColors& colors);
    /// A line through points in the base frame.
    void path(std::span<const Eigen::Vector3d> points, const QColor& color, double width, bool dashed);
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

private:
    void capsule(const ArmPart& part, const QColor& color, bool outlined);
    QRectF label(const QRectF& box, int flags, const QString& text, const QColor& color);

    QPainter& painter_;
    const Camera& camera_;
    const Theme& theme_;
};

}  // namespace tiller
