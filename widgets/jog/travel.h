// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far the arm can go in each direction of the pad before something ends it, and which way leads out of a
// limit: followed along the straight line, as the jog would go.

#include <QString>
#include <array>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"

namespace tiller {

struct Travel {
    enum class End {
        Open,         ///< further than is looked
        JointLimit,   ///< `joint` comes to the end of its range
        Singularity,  ///< the arm gets too near a singularity, its reach included
        Floor,        ///< the tool or a joint comes down to the plane the base stands on
    };
    double left = 0;  ///< [m] or [rad]
    End end = End::Open;
    int joint = -1;
};

/// Nothing is looked at beyond these.
inline constexpr double kTravelSeen = 1.0;       ///< [m]
inline constexpr double kTurnSeen = 3.14159265;  ///< [rad]

/// Height of the plane the base is bolted to, in the base frame [m]. On a wall or a ceiling it is that one.
inline constexpr double kBasePlane = 0.0;

/// direction  unit twist in the base frame: one component of one half, the other half zero; turns are about
/// the TCP
/// The plane of the base ends it for what is above it now. What is below already does not count: the base then
/// stands on a pedestal, and there is room beside it.
/// Threads    any. Some hundred microseconds
Travel travelLeft(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset,
                  const Eigen::Matrix<double, 6, 1>& direction);

/// For the twelve keys: X-, X+, Y-, Y+, ... Rz-, Rz+.
/// R_base_frame  the axes they move in
std::array<Travel, 12> travelPerKey(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset,
                                    const Eigen::Matrix3d& R_base_frame);

/// Which of the twelve keys takes this joint away from its limit fastest, with room left to go; -1 for none.
int wayOut(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset,
           const Eigen::Matrix3d& R_base_frame, int joint);
/// Which of the twelve keys leads out of a singularity fastest; -1 for none.
enum class Singularity { Wrist, Elbow, Shoulder };
int wayOutOf(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset,
             const Eigen::Matrix3d& R_base_frame, Singularity singularity);
/// "Z\u2212" for the number of a key.
QString travelKeyName(int key);

}  // namespace tiller
