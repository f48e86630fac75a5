// SPDX-License-Identifier: MIT
#pragma once

// What the arm can run into besides itself, in its base frame, and the tool it carries.

#include <QString>
#include <vector>

#include "robot/core/spatial.h"

namespace tiller::collision {

/// A solid box.
struct Obstacle {
    QString name;
    Pose pose;                                              ///< of its centre, edges along its axes [m, rad]
    Eigen::Vector3d size = Eigen::Vector3d::Constant(0.1);  ///< edges along X, Y, Z [m]
};

/// Its XY plane is the border; the arm stays on the side of +Z.
struct Border {
    QString name;  ///< empty: the floor
    Pose pose;     ///< [m, rad]
};

struct Surroundings {
    std::vector<Obstacle> obstacles;
    std::vector<Border> borders;
};

/// Distance that is kept from everything the arm can touch, unless the cell has another one [m].
inline constexpr double kSafetyDistance = 0.010;

/// A round body from the flange to the TCP.
struct ToolBody {
    Pose tcpOffset;     ///< flange to TCP [m, rad]
    double radius = 0;  ///< [m]; 0: there is none
};

/// What is known of the cell that an arm works in.
struct CellSurroundings {
    Surroundings around;
    double toolRadius = 0;                    ///< as ToolBody::radius [m]
    double safetyDistance = kSafetyDistance;  ///< that moves and jogs keep [m]
};

}  // namespace tiller::collision
