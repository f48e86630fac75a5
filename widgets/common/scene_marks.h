// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Marks that panels request in the 3D view.

#include <QString>
#include <optional>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"

namespace tiller {

/// A target, displayed before the arm moves there.
struct Ghost {
    QString name;
    JointPositions q;
    bool linear = false;  ///< the TCP moves along a straight line (MoveL)
    bool reachable = true;
    double speed = 1.05;        ///< [rad/s], or [m/s] if linear, at 100 %
    double acceleration = 1.4;  ///< [rad/s2], or [m/s2] if linear
    bool otherModel = false;    ///< taught with a different robot model and therefore not reachable
};

/// The arm at the replayed time. Never represents the current position of the robot.
struct ReplayMark {
    JointPositions q;
    QString words;                           ///< text about the replayed time
    std::optional<RobotModelId> model = {};  ///< empty: drawn as the model of the connected arm
    friend bool operator==(const ReplayMark&, const ReplayMark&) = default;
};

/// A waypoint in the 3D view.
struct WaypointMark {
    QString name;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< position of the TCP in the base frame [m]
    bool selected = false;
};

/// A taught frame, or the preview of a new frame.
struct FrameMark {
    QString name;
    Pose T_base_frame;
    bool selected = false;  ///< if true, drawn in colour; otherwise grey
};

/// A path of the TCP that is drawn as a line: the past path or the planned path.
struct PathMark {
    enum class Kind {
        Breadcrumb,  ///< past path that the Back button would retrace
        Coming,      ///< planned path of the button that the operator would hold next
    };
    Kind kind = Kind::Coming;
    std::vector<Eigen::Vector3d> places;  ///< corners of the line, base frame [m]
    /// Position and name of a limit on the path, e.g. "Elbow limit".
    struct Limit {
        Eigen::Vector3d place = Eigen::Vector3d::Zero();
        QString text;
    };
    std::optional<Limit> limit;
};

}  // namespace tiller
