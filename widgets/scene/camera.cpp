// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "robot/core/angles.h"

namespace tiller {

namespace {

// Base X and base -Y both point to the right, so an arm in its default configuration extends to the right.
constexpr double kStartAzimuth = toRadians(-138);
constexpr double kStartElevation = toRadians(13);
constexpr double kLowest = toRadians(2);
constexpr double kHighest = toRadians(88);
constexpr double kFocalLength = 2.2;  // as a multiple of the image height
constexpr double kNear = 0.05;        // [m]
// Minimum distance of the eye from the target, as a multiple of the arm height.
constexpr double kNearest = 0.5;
constexpr double kFarthest = 10;
// Maximum distance of the target from the base, as a multiple of the arm height.
constexpr double kFarthestPan = 4;

}  // namespace

void Camera::reset(double height) {
    height_ = height;
    look(StandardView::Home);
    distance_ = 2.5 * height;
    target_ = Eigen::Vector3d(0, 0, 0.435 * height);
}

void Camera::setViewport(const QSizeF& size) {
    viewport_ = size;
}

void Camera::look(StandardView from) {
    switch (from) {
        case StandardView::Home:
            turnTo(kStartAzimuth, kStartElevation);
            break;
        case StandardView::Front:
            turnTo(toRadians(-90), 0);
            break;
        case StandardView::Side:
            turnTo(0, 0);
            break;
        case StandardView::Top:
            turnTo(toRadians(-90), toRadians(90));
            break;
    }
}

/// Permitted positions of the eye, in the axes of the view, for which all spheres are inside the margins.
/// With the eye at (x, y, d): right - kRight d <= x <= kLeft d - left, and correspondingly for the vertical
/// axis; d >= least.
struct Camera::Room {
    double right = 0, left = 0, top = 0, bottom = 0;
    double kRight = 0, kLeft = 0, kTop = 0, kBottom = 0;
    double least = 0;
    /// Minimum and maximum position of the spheres along the line of sight. Values increase towards the eye.
    double nearest = 0, farthest = 0;

    double lowX(double d) const { return right - kRight * d; }
    double highX(double d) const { return kLeft * d - left; }
    double lowY(double d) const { return top - kTop * d; }
    double highY(double d) const { return kBottom * d - bottom; }
};

double Camera::focalLength() const {
    // The height determines the scale, except in a narrow image, which would otherwise cut off the arm at the
    // sides.
    return kFocalLength * std::min(viewport_.height(), 0.9 * viewport_.width());
}

Camera::Room Camera::roomFor(std::span<const Ball> balls, const QMarginsF& margins) const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    constexpr double kSmallestShare = 0.05;  // minimum fraction of the image that is inside the margins
    const double focal = std::max(1.0, focalLength());
    const auto slope = [focal](double size, double margin) {
        return std::max(size / 2 - margin, kSmallestShare * size) / focal;
    };
    Room room;
    room.kRight = slope(viewport_.width(), margins.right());
    room.kLeft = slope(viewport_.width(), margins.left());
    room.kTop = slope(viewport_.height(), margins.top());
    room.kBottom = slope(viewport_.height(), margins.bottom());
    room.right = room.left = room.top = room.bottom = room.nearest = -kNone;
    room.farthest = kNone;
    const Eigen::Matrix3d R_view_base = viewRotation().transpose();
    for (const Ball& ball : balls) {
        const Eigen::Vector3d v = R_view_base * ball.centre;
        room.right = std::max(room.right, v.x() + ball.radius + room.kRight * v.z());
        room.left = std::max(room.left, -v.x() + ball.radius + room.kLeft * v.z());
        room.top = std::max(room.top, v.y() + ball.radius + room.kTop * v.z());
        room.bottom = std::max(room.bottom, -v.y() + ball.radius + room.kBottom * v.z());
        room.nearest = std::max(room.nearest, v.z() + ball.radius);
        room.farthest = std::min(room.farthest, v.z() - ball.radius);
    }
    room.least = std::max({(room.right + room.left) / (room.kRight + room.kLeft),
                           (room.top + room.bottom) / (room.kTop + room.kBottom), room.nearest + 2 * kNear});
    return room;
}

void Camera::fit(std::span<const Ball> balls, const QMarginsF& margins) {
    if (balls.empty()) {
        return;
    }
    const Room room = roomFor(balls, margins);
    const double middle = (room.nearest + room.farthest) / 2;
    distance_ = std::clamp(room.least - middle, kNearest * height_, kFarthest * height_);
    const double d = distance_ + middle;
    target_ = viewRotation() *
              Eigen::Vector3d((room.lowX(d) + room.highX(d)) / 2, (room.lowY(d) + room.highY(d)) / 2, middle);
}

bool Camera::contain(std::span<const Ball> balls, const QMarginsF& margins) {
    if (balls.empty()) {
        return false;
    }
    const Room room = roomFor(balls, margins);
    const Eigen::Matrix3d R_base_view = viewRotation();
    const Eigen::Vector3d at = R_base_view.transpose() * target_;
    const double distance =
        std::clamp(std::max(distance_, room.least - at.z()), kNearest * height_, kFarthest * height_);
    const double d = distance + at.z();
    const Eigen::Vector3d moved(std::min(std::max(at.x(), room.lowX(d)), room.highX(d)),
                                std::min(std::max(at.y(), room.lowY(d)), room.highY(d)), at.z());
    constexpr double kSame = 1e-9;
    if (distance - distance_ < kSame && (moved - at).norm() < kSame) {
        return false;
    }
    distance_ = distance;
    target_ = R_base_view * moved;
    return true;
}

void Camera::standLike(const Camera& other) {
    target_ = other.target_;
    distance_ = other.distance_;
}

void Camera::pan(const QPointF& pixels) {
    const double metresPerPixel = distance_ / std::max(1.0, focalLength());
    const Eigen::Matrix3d R_base_view = viewRotation();
    target_ += (R_base_view.col(1) * pixels.y() - R_base_view.col(0) * pixels.x()) * metresPerPixel;
    if (const double away = target_.norm(); away > kFarthestPan * height_) {
        target_ *= kFarthestPan * height_ / away;
    }
}

void Camera::orbit(double azimuth, double elevation) {
    turnTo(std::remainder(azimuth_ + azimuth, 2 * std::numbers::pi),
           std::clamp(elevation_ + elevation, kLowest, kHighest));
}

void Camera::zoom(double factor) {
    distance_ = std::clamp(distance_ * factor, kNearest * height_, kFarthest * height_);
}

void Camera::turnTo(double azimuth, double elevation) {
    azimuth_ = azimuth;
    elevation_ = elevation;
    const Eigen::Vector3d towardsEye(std::cos(elevation_) * std::cos(azimuth_),
                                     std::cos(elevation_) * std::sin(azimuth_), std::sin(elevation_));
    const Eigen::Vector3d right(-std::sin(azimuth_), std::cos(azimuth_), 0);
    R_base_view_ << right, towardsEye.cross(right), towardsEye;
}

Camera::Eye Camera::eye() const {
    return {
        viewRotation(), target_, distance_, focalLength(), {viewport_.width() / 2, viewport_.height() / 2}};
}

Camera::Projected Camera::project(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d v = viewRotation().transpose() * (p - target_);
    Projected out;
    out.depth = distance_ - v.z();
    if (out.depth < kNear) {
        out.depth = 0;
        return out;
    }
    out.pixelsPerMetre = focalLength() / out.depth;
    out.point = {viewport_.width() / 2 + v.x() * out.pixelsPerMetre,
                 viewport_.height() / 2 - v.y() * out.pixelsPerMetre};
    return out;
}

}  // namespace tiller
