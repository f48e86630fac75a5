// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What panels ask the 3D view to show besides the arm.

#include <QString>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"

namespace tiller {

/// A target that is shown before the arm goes there.
struct Ghost {
    QString name;
    JointPositions q;
    bool linear = false;  ///< the TCP goes along a straight line (MoveL)
    bool reachable = true;
    double speed = 1.05;        ///< [rad/s], or [m/s] when linear, at 100 %
    double acceleration = 1.4;  ///< [rad/s2], or [m/s2]
};

/// A waypoint's place.
struct WaypointMark {
    QString name;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the TCP, in the base frame [m]
    bool selected = false;
};

/// A taught frame, or one that would be made now.
struct FrameMark {
    QString name;
    Pose T_base_frame;
    bool selected = false;  ///< in colours; the others grey
};

}  // namespace tiller
