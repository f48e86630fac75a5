// SPDX-License-Identifier: MIT
#pragma once

// Examines a complete move before it is executed: path, duration, joint rotations and the first limit.

#include <optional>
#include <span>
#include <vector>

#include "robot/collision/collision_check.h"

namespace tiller::collision {

/// The requested move: joint-interpolated, or a straight line of the TCP.
struct Move {
    JointPositions from;
    JointPositions to;  ///< for a line: the TCP moves to the pose of these positions, in any configuration
    bool linear = false;
    double speed = 1.05;        ///< [rad/s] of the joint with the largest rotation, or [m/s] for a line
    double acceleration = 1.4;  ///< [rad/s2], or [m/s2]
};

/// The first limit of the move.
struct MoveLimit {
    enum class Kind {
        OutOfReach,       ///< the line leaves the workspace
        JointRange,       ///< a joint would exceed its range
        Singularity,      ///< the line passes through a singularity and cannot be followed
        NearSingularity,  ///< the line can be followed, but the arm slows down to limit joint speeds
        Collision,
    };
    enum class Singular { None, Wrist, Elbow, Shoulder };
    Kind kind = Kind::Collision;
    Singular singular = Singular::None;  ///< type of singularity
    Contact contact;            ///< for Collision: a contact, or a distance below the safety distance
    double safetyDistance = 0;  ///< for Collision: the configured safety distance [m]
    bool isInside = false;      ///< for Collision: the move starts within this distance of the same object
    int joint = 0;              ///< for JointRange, 0 ... 5
    double share = 0;           ///< position along the path, 0 ... 1
    Pose tcp;                   ///< pose at this position, base frame

    /// True if the move ends at this limit. Near a singularity, the move only slows down.
    bool ends() const { return kind != Kind::NearSingularity; }
};

struct MoveReport {
    std::vector<JointPositions> way;      ///< path to the reachable end; joints move uniformly in between
    std::vector<Eigen::Vector3d> places;  ///< positions of the TCP, base frame [m]
    int largestTurnJoint = 0;             ///< 0 ... 5
    double largestTurn = 0;               ///< signed, from start to end [rad]
    double duration = 0;                  ///< total duration [s]
    std::optional<MoveLimit> limit;
};

/// The first collision on a path. All joints move uniformly between its positions. Empty if the path is free.
/// Threads  any. Blocks: never. Real-time: no (a millisecond)
std::optional<MoveLimit> collisionOn(const RobotModel& model, const CollisionCheck& check,
                                     const Pose& tcpOffset, std::span<const JointPositions> way);

/// check          checks the arm, its tool and the surroundings, with the safety distance. A move that starts
///                within the safety distance and leaves it is not a collision, see
///                CollisionCheck::obstruction().
/// tcpOffset      flange to TCP [m, rad]
/// speedFraction  speed slider, 0 < fraction <= 1
/// Threads        any. Blocks: never. Real-time: no (a millisecond; ten for a line)
MoveReport examineMove(const RobotModel& model, const CollisionCheck& check, const Pose& tcpOffset,
                       const Move& move, double speedFraction);

}  // namespace tiller::collision
