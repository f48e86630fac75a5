// SPDX-License-Identifier: MIT
#pragma once

// Defines a frame by three TCP positions: the origin, a point on the +X axis, and a point on the +Y side.
// Points that are too close together or collinear are refused, because an error of 1 mm would rotate the
// axes by degrees.

#include <optional>

#include "robot/core/spatial.h"

namespace tiller::project {

/// The points taught so far, in the base frame [m]. Empty: not taught yet.
struct FramePoints {
    std::optional<Eigen::Vector3d> origin;
    std::optional<Eigen::Vector3d> onX;
    std::optional<Eigen::Vector3d> towardsY;
};

/// Minimum distance of the second and third point from the origin, and of the third point from the X axis
/// [m]. At these distances, an error of 1 mm rotates an axis by less than 3 deg and 6 deg, respectively.
inline constexpr double kMinFrameArm = 0.020;
inline constexpr double kMinFrameOffset = 0.010;

/// Evaluation of the points recorded so far.
struct FramePointsCheck {
    enum class Problem {
        None,
        Incomplete,  ///< no problem so far, but points are missing
        NotFinite,
        XTooClose,  ///< the point on +X is too close to the origin
        YTooClose,  ///< the point on the +Y side is too close to the origin
        InLine,     ///< the third point is closer to the X axis than kMinFrameOffset
    };
    Problem problem = Problem::Incomplete;
    double alongX = 0;                                    ///< distance from the origin to the point on +X [m]
    double towardsY = 0;                                  ///< distance from the origin to the third point [m]
    double offLine = 0;                                   ///< distance from the X axis to the third point [m]
    bool ok() const { return problem == Problem::None; }  ///< True if the points define a frame.
};

/// Threads  any. Blocks: never
FramePointsCheck check(const FramePoints& points);

/// T_base_frame: X through the second point, Y in the plane of the three points towards the third.
/// Returns  empty unless check() is ok
std::optional<Pose> frameThrough(const FramePoints& points);

}  // namespace tiller::project
