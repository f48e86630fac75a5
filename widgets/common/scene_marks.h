// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What panels ask the 3D view to show besides the arm.

#include <QString>
#include <optional>
#include <vector>

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
    bool otherModel = false;    ///< why it is not reachable: it was taught with another robot model
};

/// The arm as it stood in a moment that is replayed: never where it is now.
struct ReplayMark {
    JointPositions q;
    QString words;  ///< of which moment
    friend bool operator==(const ReplayMark&, const ReplayMark&) = default;
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

/// A way of the TCP that is drawn as a line: where it has been, or where it will go.
struct PathMark {
    enum class Kind {
        Breadcrumb,  ///< went: what Back would undo
        Coming,      ///< will go, once it is held
    };
    Kind kind = Kind::Coming;
    std::vector<Eigen::Vector3d> places;  ///< corners of the line, base frame [m]
    /// Where something stands in the way, and what: "Elbow limit".
    struct Limit {
        Eigen::Vector3d place = Eigen::Vector3d::Zero();
        QString text;
    };
    std::optional<Limit> limit;
};

}  // namespace tiller
