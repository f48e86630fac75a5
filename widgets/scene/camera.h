// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The eye of the 3D view: it circles around a point and looks at it, in perspective. It can be placed so that
// everything that matters is in the picture.

#include <Eigen/Core>
#include <QMarginsF>
#include <QPointF>
#include <QSizeF>
#include <span>

namespace tiller {

/// Where the eye looks from. Base axes in the picture: Front X right and Z up, Side Y right and Z up, Top X right
/// and Y up; Home is the first view, from between front and side and a little above.
enum class StandardView { Home, Front, Side, Top };

class Camera {
public:
    /// Something round that must be in the picture, in the base frame [m].
    struct Ball {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        double radius = 0;
    };

    /// The view the program starts with, for an arm that is so high when upright [m].
    void reset(double height);
    void setViewport(const QSizeF& size);
    QSizeF viewport() const { return viewport_; }

    /// Turns to this side; what is looked at stays.
    void look(StandardView from);
    /// Goes as near as the balls allow and looks at their middle.
    /// margins  of the viewport that they leave free [px]
    void fit(std::span<const Ball> balls, const QMarginsF& margins);
    /// Moves no more than is needed to have the balls in the picture.
    /// Returns  true when it moved
    bool contain(std::span<const Ball> balls, const QMarginsF& margins);
    /// Takes place and distance of another eye, not its direction.
    void standLike(const Camera& other);

    /// Circles by these angles [rad]; the eye stays above the ground's edge and never turns over the pole.
    void orbit(double azimuth, double elevation);
    /// Moves what is seen by this much on the screen [px].
    void pan(const QPointF& pixels);
    /// factor < 1 comes nearer.
    void zoom(double factor);

    double azimuth() const { return azimuth_; }
    double elevation() const { return elevation_; }
    double distance() const { return distance_; }

    /// R_base_view: its columns are the view's axes in base coordinates: X to the right of the screen, Y up,
    /// Z towards the eye.
    Eigen::Matrix3d viewRotation() const;

    /// What it takes to project many points at once.
    struct Eye {
        Eigen::Matrix3d R_base_view = Eigen::Matrix3d::Identity();
        Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< looked at, base frame [m]
        double distance = 1;                               ///< of the eye from it [m]
        double focal = 1;                                  ///< [px]
        QPointF middle;                                    ///< of the picture [px]
        friend bool operator==(const Eye&, const Eye&) = default;
    };
    Eye eye() const;

    /// A point in the base frame, on the screen.
    struct Projected {
        QPointF point;              ///< [px]
        double depth = 0;           ///< distance along the line of sight [m]; not above 0: behind the eye
        double pixelsPerMetre = 0;  ///< at this depth
        bool visible() const { return depth > 0; }
    };
    Projected project(const Eigen::Vector3d& p) const;

private:
    struct Room;
    Room roomFor(std::span<const Ball> balls, const QMarginsF& margins) const;
    double focalLength() const;

    Eigen::Vector3d target_{0, 0, 0.35};
    double azimuth_ = 0;
    double elevation_ = 0.3;
    double distance_ = 2.5;
    double height_ = 1.08;
    QSizeF viewport_{640, 480};
};

}  // namespace tiller
