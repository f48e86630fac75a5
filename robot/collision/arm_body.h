// SPDX-License-Identifier: MIT
#pragma once

// Dimensions of the arm's housings and tubes. Both the 3D view and the collision check use these dimensions,
// so the displayed bodies are the checked bodies.

#include <Eigen/Core>
#include <vector>

#include "robot/core/robot_model.h"

namespace tiller::collision {

/// Radii and offsets of the housings [m]. The size of a joint housing depends on its torque; tubes are thinner than
/// the housings at their ends.
struct ArmProportions {
    double shoulderOffset = 0;  ///< distance from axis 1 to the upper arm tube, along axis 2
    double elbowOffset = 0;     ///< distance from axis 1 to the forearm tube, along axis 2
    double baseHeight = 0;      ///< height of the fixed part
    double baseRadius = 0;
    double shoulderRadius = 0;  ///< joints 1 and 2
    double upperRadius = 0;     ///< tube of the upper arm
    double elbowRadius = 0;     ///< joint 3
    double foreRadius = 0;      ///< tube of the forearm
    double wristRadius = 0;     ///< joints 4 to 6
    double flangeRadius = 0;
};

/// Source: the offsets are based on the vendor's public description files (UR3 to UR30 except UR8 Long, UR15
/// and UR18), or on the centres of mass in robot_model.cpp for the other models. The radii are estimates that
/// grow with the cube root of the joint torque. They have not been compared with the description files yet.
ArmProportions armProportions(const RobotModel& model);

/// Height of the flange axis above the base with the arm pointing straight up [m].
double uprightHeight(const RobotModel& model);

/// A cylinder with hemispherical ends; a sphere if both ends are equal.
struct Capsule {
    Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< [m]
    Eigen::Vector3d to = Eigen::Vector3d::Zero();    ///< [m]
    double radius = 0;                               ///< [m]
};

/// A part of the arm, in the frame of the link that carries it.
struct LinkCapsule {
    int link = 0;  ///< 0: the fixed base, ... 6: rotates with the flange
    Capsule shape;
    /// Number of preceding links that cannot collide with the body, because it rotates on them or at a
    /// constant distance from them.
    int neighbours = 1;
    bool atFoot = false;  ///< fixed or rotating in place; only the arm itself can collide with this body
};

/// Bodies of the arm used for collision checks. They contain all displayed parts.
std::vector<LinkCapsule> armCapsules(const RobotModel& model);

/// The bodies at the joint positions `q`, in the base frame.
std::vector<LinkCapsule> placedCapsules(const std::vector<LinkCapsule>& capsules, const DhParameters& dh,
                                        const JointPositions& q);

}  // namespace tiller::collision
