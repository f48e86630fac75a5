// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The eye of the 3D view: it circles around a point and looks at it, in perspective.

#include <Eigen/Core>
#include <QPointF>
#include <QSizeF>

namespace tiller {

class Camera {
public:
    /// The view the program starts with, for an arm that is so high when upright [m].
    void reset(double height);
    void setViewport(const QSizeF& size);
    QSizeF viewport() const { return viewport_; }

    /// Circles by these angles [rad]; the eye stays above the ground's edge and never turns over the pole.
    void orbit(double azimuth, double elevation);
    /// factor < 1 comes nearer.
    void zoom(double factor);

    double azimuth() const { return azimuth_; }
    double elevation() const { return elevation_; }
    double distance() const { return distance_; }

    /// R_base_view: its columns are the view's axes in base coordinates: X to the right of the screen, Y up,
    /// Z towards the eye.
    Eigen::Matrix3d viewRotation() const;

    /// A point in the base frame, on the screen.
    struct Projected {
        QPointF point;              ///< [px]
        double depth = 0;           ///< distance along the line of sight [m]; not above 0: behind the eye
        double pixelsPerMetre = 0;  ///< at this depth
        bool visible() const { return depth > 0; }
    };
    Projected project(const Eigen::Vector3d& p) const;

private:
    Eigen::Vector3d target_{0, 0, 0.35};
    double azimuth_ = 0;
    double elevation_ = 0.3;
    double distance_ = 2.5;
    double height_ = 1.08;
    QSizeF viewport_{640, 480};
};

}  // namespace tiller
