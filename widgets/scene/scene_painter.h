// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Draws the lines of the scene through a camera: ground, axes, paths, arrows and names.

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
    /// Returns true if a body is in front of a position.
    using Hides = std::function<bool(const Camera::Projected&)>;

    ScenePainter(QPainter& painter, const Camera& camera, const Theme& theme);

    /// Draws a grid around the base.
    /// reach, height  reach and height of the arm [m]
    /// solid  true: floor of the cell, drawn as a plane that the arm must stay above; false: only lines
    void ground(double reach, double height, bool solid);
    /// Style of a line in space.
    struct Stroke {
        QColor color;
        double width = 1;
        bool dashed = false;
    };
    /// Draws a line through points in the base frame. Hidden parts are drawn faintly.
    void path(std::span<const Eigen::Vector3d> points, const Stroke& stroke, const Hides& hides);
    /// Draws the symbol for a limit on a path, which differs from the mark of a waypoint.
    void limit(const QPointF& at);
    /// Draws three axes with their letters.
    void axes(const Eigen::Isometry3d& T_base_frame, double length, bool greyed);
    void marker(const QPointF& at, bool selected);
    void name(const PlacedLabel& name);
    /// Draws a prominent text in the centre of the box.
    void headline(const QRectF& box, const QString& text);
    /// Draws a line of small text; nothing if the text is empty.
    void note(const QRectF& box, const QString& text);
    /// Returns the size of a label, and elides `text` to the text that is drawn.
    static QSizeF nameSize(QString& text);
    /// Draws an arrow next to the tool. An arrow seen end-on is drawn as a ring with a dot (towards the eye)
    /// or a cross (away from the eye).
    /// Returns  the rectangle of its label
    QRectF arrow(const Eigen::Vector3d& tcp, const Eigen::Vector3d& direction, double reach,
                 const QColor& color, const QString& name);
    /// Draws an arrow around an axis in the direction of a rotation (right-hand rule).
    /// radius   radius of the arrow [m]
    /// Returns  the rectangle of its label
    QRectF turn(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double radius,
                const QColor& color, const QString& name);

private:
    QRectF label(const QRectF& box, int flags, const QString& text, const QColor& color);

    QPainter& painter_;
    const Camera& camera_;
    const Theme& theme_;
};

}  // namespace tiller
