// SPDX-License-Identifier: MIT
#pragma once

// How thick an arm is and where its tubes run beside the joint axes. The picture of the arm and the collision check
// are both made from this, so that what is seen is what is checked.

#include <Eigen/Core>
#include <vector>

#include "robot/core/robot_model.h"

namespace tiller::collision {

/// Radii and offsets of an arm's housings [m]. A joint's housing is as thick as its torque needs; the tubes are
/// thinner than the housings at their ends.
struct ArmProportions {
    double shoulderOffset = 0;  ///< from axis 1 to the upper arm's tube, along axis 2
    double elbowOffset = 0;     ///< from axis 1 to the forearm's tube, along axis 2
    double baseHeight = 0;      ///< of what does not turn
    double baseRadius = 0;
    double shoulderRadius = 0;  ///< joints 1 and 2
    double upperRadius = 0;     ///< tube of the upper arm
    double elbowRadius = 0;     ///< joint 3
    double foreRadius = 0;      ///< tube of the forearm
    double wristRadius = 0;     ///< joints 4 to 6
    double flangeRadius = 0;
};

/// Source: estimates, not compared with the vendor's public description files yet. Offsets are meant to be theirs (UR3 to
/// UR30 without the UR8 Long, UR15 and UR18), else by the centres of mass in robot_model.cpp; radii are assumed to
/// grow with the cubic root of the joint's torque.
ArmProportions armProportions(const RobotModel& model);

/// From the ground to the flange's axis, with the arm straight up [m].
double uprightHeight(const RobotModel& model);

/// A rod with round ends; a ball when both ends are the same.
struct Capsule {
    Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< [m]
    Eigen::Vector3d to = Eigen::Vector3d::Zero();    ///< [m]
    double radius = 0;                               ///< [m]
};

/// A part of the arm, in the frame of the link that carries it.
struct LinkCapsule {
    int link = 0;  ///< 0 the base, that stands still, ... 6 what turns with the flange
    Capsule shape;
    /// So many links before its own it cannot meet: it turns on them, or goes round them at one distance.
    int neighbours = 1;
    bool atFoot = false;  ///< stands or turns on the spot: only the arm itself can meet it
};

/// What the arm is checked as. Every part that is drawn lies inside it.
std::vector<LinkCapsule> armCapsules(const RobotModel& model);

/// The same, where the arm stands: in the base frame.
std::vector<LinkCapsule> placedCapsules(const std::vector<LinkCapsule>& capsules, const DhParameters& dh,
                                        const JointPositions& q);

}  // namespace tiller::collision
