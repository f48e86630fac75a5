// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Perspective camera of the 3D view that rotates around a target point. It can be positioned so that all
// relevant objects are visible.

#include <Eigen/Core>
#include <QMarginsF>
#include <QPointF>
#include <QSizeF>
#include <span>

namespace tiller {

/// Viewing direction. Axes of the base frame in the image: Front has X to the right and Z up, Side has Y to
/// the right and Z up, Top has X to the right and Y up. Home is the initial view, between Front and Side and
/// 13 deg above the horizontal.
enum class StandardView { Home, Front, Side, Top };

class Camera {
public:
    /// A sphere that must be visible, in the base frame [m].
    struct Ball {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        double radius = 0;
    };

    Camera() { turnTo(0, 0.3); }

    /// Sets the initial view for an arm with this height [m] when upright.
    void reset(double height);
    void setViewport(const QSizeF& size);
    QSizeF viewport() const { return viewport_; }

    /// Changes the viewing direction. The target is unchanged.
    void look(StandardView from);
    /// Moves as close as the spheres allow, and targets their centre.
    /// margins  borders of the viewport that remain free [px]
    void fit(std::span<const Ball> balls, const QMarginsF& margins);
    /// Moves the minimum distance that makes all spheres visible.
    /// Returns  true if the camera moved
    bool contain(std::span<const Ball> balls, const QMarginsF& margins);
    /// Copies target and distance of another camera. The viewing direction is unchanged.
    void standLike(const Camera& other);

    /// Rotates around the target by these angles [rad]. The eye remains above the ground and does not move
    /// past the pole.
    void orbit(double azimuth, double elevation);
    /// Moves the image by this distance on the screen [px].
    void pan(const QPointF& pixels);
    /// Moves closer to the target (factor < 1) or away from it.
    void zoom(double factor);

    double azimuth() const { return azimuth_; }
    double elevation() const { return elevation_; }
    double distance() const { return distance_; }

    /// Returns R_base_view. Its columns are the axes of the view in the base frame: X to the right of the
    /// screen, Y up, Z towards the eye.
    const Eigen::Matrix3d& viewRotation() const { return R_base_view_; }

    /// Parameters for projecting many points.
    struct Eye {
        Eigen::Matrix3d R_base_view = Eigen::Matrix3d::Identity();
        Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< target in the base frame [m]
        double distance = 1;                               ///< distance of the eye from the target [m]
        double focal = 1;                                  ///< [px]
        QPointF middle;                                    ///< centre of the image [px]
        friend bool operator==(const Eye&, const Eye&) = default;
    };
    Eye eye() const;

    /// A point in the base frame, projected to the screen.
    struct Projected {
        QPointF point;              ///< [px]
        double depth = 0;           ///< distance along the line of sight [m]; <= 0: behind the eye
        double pixelsPerMetre = 0;  ///< scale at this depth
        bool visible() const { return depth > 0; }
    };
    Projected project(const Eigen::Vector3d& p) const;

private:
    struct Room;
    Room roomFor(std::span<const Ball> balls, const QMarginsF& margins) const;
    double focalLength() const;
    /// Sets the viewing direction [rad]. Also stores the rotation matrix, because each frame projects many
    /// points.
    void turnTo(double azimuth, double elevation);

    Eigen::Vector3d target_{0, 0, 0.35};
    double azimuth_ = 0;
    double elevation_ = 0;
    Eigen::Matrix3d R_base_view_;
    double distance_ = 2.5;
    double height_ = 1.08;
    QSizeF viewport_{640, 480};
};

}  // namespace tiller
