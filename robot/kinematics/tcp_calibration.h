// SPDX-License-Identifier: MIT
#pragma once

// Where the tip of a tool is, from poses of the flange in which the tip stands on one and the same point; and how
// the tool is turned, from one pose in which it stands along known axes, or from three along its own.

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace tiller::kinematics {

inline constexpr int kLeastTipPoses = 4;
/// The least that the flange must turn about its second axis of turning between the poses, as a share of what
/// would be best (0 ... 1): below it a millimetre beside the point costs many at the tip.
inline constexpr double kLeastTipSpread = 0.10;

/// What the poses say of the tip, and how well they agree.
struct TipFit {
    enum class Problem {
        None,
        TooFew,     ///< fewer than kLeastTipPoses
        NotFinite,  ///< a pose is no pose
        TooAlike,   ///< the flange is turned too little, or about one axis only
    };
    Problem problem = Problem::TooFew;
    Eigen::Vector3d tip = Eigen::Vector3d::Zero();    ///< from the flange, in its axes [m]
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< what it stood on, in the base frame [m]
    std::vector<double> residuals;                    ///< tip of each pose to the point [m]
    double rms = 0;                                   ///< of the residuals [m]
    int worst = 0;                                    ///< pose with the largest residual
    double spread = 0;                                ///< see kLeastTipSpread

    bool ok() const { return problem == Problem::None; }  ///< The tip is known.
};

/// The tip with the least sum of squared residuals.
/// T_base_flange  of each pose
/// Threads  any. Real-time: no (allocates)
TipFit fitTip(std::span<const Eigen::Isometry3d> T_base_flange);

/// Rotation of the tool when it stands along known axes.
/// R_base_tool  how it stands
/// Returns      R_flange_tool
Eigen::Matrix3d toolRotation(const Eigen::Matrix3d& R_base_flange, const Eigen::Matrix3d& R_base_tool);

/// The least way of the second and third pose of fitToolRotation(), and of the third beside the first way [m].
inline constexpr double kLeastAxisWay = 0.020;
inline constexpr double kLeastAxisOffset = 0.010;
/// How far the flange may turn between the three [rad].
inline constexpr double kMostAxisTurn = 0.0175;

struct ToolRotationFit {
    enum class Problem {
        None,
        NotFinite,
        Turned,  ///< the flange turned on the way, by more than kMostAxisTurn
        ZTooClose,
        XTooClose,
        InLine,  ///< the third pose lies beside the way to the second by less than kLeastAxisOffset
    };
    Problem problem = Problem::NotFinite;
    Eigen::Matrix3d R_flange_tool = Eigen::Matrix3d::Identity();
    double alongZ = 0;    ///< way from the first to the second [m]
    double towardsX = 0;  ///< way from the first to the third [m]
    double offLine = 0;   ///< the third beside the line through the first two [m]
    double residual =
        0;          ///< largest turn of the flange between the three [rad]: what the result is unsure by
    int worst = 0;  ///< 1, 2: which one was turned most against the first
    bool ok() const { return problem == Problem::None; }  ///< The rotation is known.
};

/// Rotation of the tool from three poses without a turn: the tip somewhere, moved along the tool's +Z, and moved
/// to the side of its +X.
/// T_base_flange  of the three
ToolRotationFit fitToolRotation(const std::array<Eigen::Isometry3d, 3>& T_base_flange);

}  // namespace tiller::kinematics
