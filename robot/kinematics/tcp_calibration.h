// SPDX-License-Identifier: MIT
#pragma once

// Determines the tip of a tool from several flange poses with the tip at the same point, and the tool
// orientation from one pose with known tool axes or from three poses along the tool axes.

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace tiller::kinematics {

inline constexpr int kMinTipPoses = 4;
/// Minimum rotation of the flange about its second rotation axis between the poses, as a fraction of the optimum (0
/// ... 1). Below this value, an error of 1 mm at the point causes an error of many millimetres at the tip.
inline constexpr double kMinTipSpread = 0.10;

/// The estimated tip, and the consistency of the poses.
struct TipFit {
    enum class Problem {
        None,
        TooFew,     ///< fewer than kMinTipPoses
        NotFinite,  ///< a pose is not finite
        TooAlike,   ///< the flange was rotated too little, or about one axis only
    };
    Problem problem = Problem::TooFew;
    Eigen::Vector3d tip = Eigen::Vector3d::Zero();    ///< tip in the flange frame [m]
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< the touched point in the base frame [m]
    std::vector<double> residuals;  ///< distance of the tip from the point for each pose [m]
    double rms = 0;                 ///< rms of the residuals [m]
    int worst = 0;                  ///< index of the pose with the largest residual
    double spread = 0;              ///< see kMinTipSpread

    bool ok() const { return problem == Problem::None; }  ///< True if the tip was determined.
};

/// Least-squares estimate of the tip.
/// T_base_flange  the flange poses
/// Threads        any. Real-time: no (allocates)
TipFit fitTip(std::span<const Eigen::Isometry3d> T_base_flange);

/// Tool orientation from a pose with known tool axes.
/// R_base_tool  orientation of the tool in this pose
/// Returns      R_flange_tool
Eigen::Matrix3d toolRotation(const Eigen::Matrix3d& R_base_flange, const Eigen::Matrix3d& R_base_tool);

/// Minimum distance of the second and third pose of fitToolRotation() from the first, and of the third from the
/// line through the first two [m].
inline constexpr double kMinAxisTravel = 0.020;
inline constexpr double kMinAxisOffset = 0.010;
/// Maximum rotation of the flange between the three poses [rad].
inline constexpr double kMaxAxisTurn = 0.0175;

struct ToolRotationFit {
    enum class Problem {
        None,
        NotFinite,
        Turned,  ///< the flange rotated by more than kMaxAxisTurn
        ZTooClose,
        XTooClose,
        InLine,  ///< the third pose is closer than kMinAxisOffset to the line through the first two
    };
    Problem problem = Problem::NotFinite;
    Eigen::Matrix3d R_flange_tool = Eigen::Matrix3d::Identity();
    double alongZ = 0;    ///< distance from the first to the second pose [m]
    double towardsX = 0;  ///< distance from the first to the third pose [m]
    double offLine = 0;   ///< distance of the third pose from the line through the first two [m]
    double residual =
        0;          ///< largest rotation of the flange between the poses [rad]: the uncertainty of the result
    int worst = 0;  ///< 1 or 2: the pose with the largest rotation relative to the first
    bool ok() const { return problem == Problem::None; }  ///< True if the orientation was determined.
};

/// Tool orientation relative to the flange, from three poses with equal orientation: a start pose, a pose moved along
/// the tool's +Z, and a pose moved towards its +X.
/// T_base_flange  the three flange poses
ToolRotationFit fitToolRotation(const std::array<Eigen::Isometry3d, 3>& T_base_flange);

}  // namespace tiller::kinematics
