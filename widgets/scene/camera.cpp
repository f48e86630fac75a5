// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/core/angles.h"

namespace tiller {

namespace {

// Base X to the right and base -Y to the right as well: an arm in its usual stance reaches to the right.
constexpr double kStartAzimuth = toRadians(-138);
constexpr double kStartElevation = toRadians(13);
constexpr double kLowest = toRadians(2);
constexpr double kHighest = toRadians(88);
constexpr double kFocalLength = 2.2;  // in heights of the picture
constexpr double kNear = 0.05;        // [m]

}  // namespace

void Camera::reset(double height) {
    height_ = height;
    azimuth_ = kStartAzimuth;
    elevation_ = kStartElevation;
    distance_ = 2.5 * height;
    target_ = Eigen::Vector3d(0, 0, 0.435 * height);
}

void Camera::setViewport(const QSizeF& size) {
    viewport_ = size;
}

void Camera::orbit(double azimuth, double elevation) {
    azimuth_ = std::remainder(azimuth_ + azimuth, 2 * std::numbers::pi);
    elevation_ = std::clamp(elevation_ + elevation, kLowest, kHighest);
}

void Camera::zoom(double factor) {
    distance_ = std::clamp(distance_ * factor, 0.5 * height_, 10 * height_);
}

Eigen::Matrix3d Camera::viewRotation() const {
    const Eigen::Vector3d towardsEye(std::cos(elevation_) * std::cos(azimuth_),
                                     std::cos(elevation_) * std::sin(azimuth_), std::sin(elevation_));
    const Eigen::Vector3d right(-std::sin(azimuth_), std::cos(azimuth_), 0);
    Eigen::Matrix3d R_base_view;
    R_base_view << right, towardsEye.cross(right), towardsEye;
    return R_base_view;
}

Camera::Projected Camera::project(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d v = viewRotation().transpose() * (p - target_);
    Projected out;
    out.depth = distance_ - v.z();
    if (out.depth < kNear) {
        out.depth = 0;
        return out;
    }
    // A narrow picture shows less to the sides, not a smaller arm, until it would be cut off.
    const double focal = kFocalLength * std::min(viewport_.height(), 0.9 * viewport_.width());
    out.pixelsPerMetre = focal / out.depth;
    out.point = {viewport_.width() / 2 + v.x() * out.pixelsPerMetre,
                 viewport_.height() / 2 - v.y() * out.pixelsPerMetre};
    return out;
}

}  // namespace tiller
