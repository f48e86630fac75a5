// SPDX-License-Identifier: MIT
#pragma once

// Obstacles in the base frame, and the tool, for the collision check.

#include <QString>
#include <vector>

#include "robot/core/spatial.h"

namespace tiller::collision {

/// A solid box.
struct Obstacle {
    QString name;
    Pose pose;  ///< pose of the centre; the edges are parallel to its axes [m, rad]
    Eigen::Vector3d size = Eigen::Vector3d::Constant(0.1);  ///< edges along X, Y, Z [m]
};

/// A plane that the arm must not cross: the XY plane of its pose. The arm stays on the +Z side.
struct Border {
    QString name;  ///< empty: the floor
    Pose pose;     ///< [m, rad]
};

struct Surroundings {
    std::vector<Obstacle> obstacles;
    std::vector<Border> borders;
};

/// Default safety distance from all objects [m].
inline constexpr double kSafetyDistance = 0.010;

/// A cylinder from the flange to the TCP.
struct ToolBody {
    Pose tcpOffset;     ///< flange to TCP [m, rad]
    double radius = 0;  ///< [m]; 0: no tool body
};

/// An object whose position is unknown, because the project does not contain its reference frame.
struct UnplacedObject {
    QString name;
    QString frame;  ///< ID of the missing frame
    friend bool operator==(const UnplacedObject&, const UnplacedObject&) = default;
};

/// Surroundings of an arm, including objects that cannot be placed.
struct CellSurroundings {
    Surroundings around;
    std::vector<UnplacedObject> unplaced;     ///< not checkable; moves are refused unless empty
    double toolRadius = 0;                    ///< see ToolBody::radius [m]
    double safetyDistance = kSafetyDistance;  ///< safety distance for moves and jogs [m]
};

}  // namespace tiller::collision
