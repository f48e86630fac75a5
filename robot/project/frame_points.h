// SPDX-License-Identifier: MIT
#pragma once

// A frame from three places of the TCP: where it begins, a point on its +X axis, and a point on the side of
// its +Y axis. Points that lie too close together or in a line make no frame: a millimetre of error in one of
// them would turn the axes by degrees.

#include <optional>

#include "robot/core/spatial.h"

namespace tiller::project {

/// In the base frame [m]; what is not taken yet is empty.
struct FramePoints {
    std::optional<Eigen::Vector3d> origin;
    std::optional<Eigen::Vector3d> onX;
    std::optional<Eigen::Vector3d> towardsY;
};

/// The least distance of either point from the origin, and of the third from the X axis [m]: one millimetre
/// beside the mark then turns an axis by less than 3 and 6 deg.
inline constexpr double kLeastFrameArm = 0.020;
inline constexpr double kLeastFrameOffset = 0.010;

/// What the points there are say so far.
struct FramePointsCheck {
    enum class Problem {
        None,
        Incomplete,  ///< nothing is wrong yet, but points are missing
        NotFinite,
        XTooClose,  ///< the point on +X to the origin
        YTooClose,  ///< the point towards +Y to the origin
        InLine,     ///< the third point lies beside the X axis by less than kLeastFrameOffset
    };
    Problem problem = Problem::Incomplete;
    double alongX = 0;                                    ///< from the origin to the point on +X [m]
    double towardsY = 0;                                  ///< from the origin to the third point [m]
    double offLine = 0;                                   ///< from the X axis to the third point [m]
    bool ok() const { return problem == Problem::None; }  ///< The points make a frame.
};

/// Threads  any. Blocks: never
FramePointsCheck check(const FramePoints& points);

/// T_base_frame: X through the second point, Y in the plane of the three and on the side of the third.
/// Returns  nothing unless check() finds nothing
std::optional<Pose> frameThrough(const FramePoints& points);

}  // namespace tiller::project
