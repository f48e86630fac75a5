// SPDX-License-Identifier: MIT
#pragma once

// A whole move, looked at before it is made: which way it takes, how long and how far the joints turn, and the first
// thing that stands in its way.

#include <optional>
#include <span>
#include <vector>

#include "robot/collision/collision_check.h"

namespace tiller::collision {

/// What is asked for. Joints in step, or the TCP along a straight line.
struct Move {
    JointPositions from;
    JointPositions
        to;  ///< of a line: the TCP goes to where these bring it, in whatever posture it gets there
    bool linear = false;
    double speed = 1.05;        ///< [rad/s] of the joint that turns most, or [m/s] when linear
    double acceleration = 1.4;  ///< [rad/s2], or [m/s2]
};

/// The first thing that stands in the way.
struct MoveLimit {
    enum class Kind {
        OutOfReach,       ///< the line leaves the reach of the arm
        JointRange,       ///< a joint would leave its range
        Singularity,      ///< the line cannot be followed: a joint would have to turn at once
        NearSingularity,  ///< it can, but joints get fast: the arm slows down
        Collision,
    };
    enum class Singular { None, Wrist, Elbow, Shoulder };
    Kind kind = Kind::Collision;
    Singular singular = Singular::None;  ///< which
    Contact contact;            ///< for Collision, which is a contact or less than the safety distance
    double safetyDistance = 0;  ///< for Collision: the one that is kept [m]
    bool isInside = false;      ///< for Collision: the move begins nearer than that to the same thing
    int joint = 0;              ///< for JointRange, 0 ... 5
    double share = 0;           ///< of the way, 0 ... 1
    Pose tcp;                   ///< there, base frame

    /// The move ends there; what is only near a singularity is slowed down.
    bool ends() const { return kind != Kind::NearSingularity; }
};

struct MoveReport {
    std::vector<JointPositions> way;      ///< as far as it can be followed; joints turn evenly in between
    std::vector<Eigen::Vector3d> places;  ///< of the TCP along it, base frame [m]
    int largestTurnJoint = 0;             ///< 0 ... 5
    double largestTurn = 0;               ///< from start to end, with sign [rad]
    double duration = 0;                  ///< of all of it [s]
    std::optional<MoveLimit> limit;
};

/// The first thing that a path comes too near to; joints turn evenly between its positions. Nothing: it is free.
/// Threads  any. Blocks: never. Real-time: no (a millisecond)
std::optional<MoveLimit> collisionOn(const RobotModel& model, const CollisionCheck& check,
                                     const Pose& tcpOffset, std::span<const JointPositions> way);

/// check          of the arm, its tool and what is around it, with the safety distance that is kept
/// A move that leads out of the safety distance has no collision: see CollisionCheck::obstruction().
/// tcpOffset      flange to TCP [m, rad]
/// speedFraction  speed slider, 0 < fraction <= 1
/// Threads  any. Blocks: never. Real-time: no (a millisecond; a line ten)
MoveReport examineMove(const RobotModel& model, const CollisionCheck& check, const Pose& tcpOffset,
                       const Move& move, double speedFraction);

}  // namespace tiller::collision
