// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The arm as a handful of thick rounded rods, placed by its Denavit-Hartenberg frames and pushed out of line
// at shoulder and elbow as the real one is.

#include <Eigen/Core>
#include <array>

#include "robot/core/robot_model.h"

namespace tiller {

enum class ArmPartKind { Housing, Link, Joint };

/// A rod with round ends; a ball when both ends are the same. Base frame [m].
struct ArmPart {
    ArmPartKind kind = ArmPartKind::Link;
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    double radius = 0;
    /// For the cap of a joint: the parts that meet there, as bits. It is drawn over all of them when its
    /// outer side faces the eye, under all of them when not. 0: not a cap.
    unsigned meets = 0;
    Eigen::Vector3d outward = Eigen::Vector3d::Zero();  ///< zero: seen from everywhere
};

inline constexpr int kArmPartCount = 13;

/// From the ground to the flange's axis, with the arm straight up [m].
double uprightHeight(const RobotModel& model);

/// Threads  any
std::array<ArmPart, kArmPartCount> armParts(const RobotModel& model, const JointPositions& q);

}  // namespace tiller
