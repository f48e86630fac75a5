// SPDX-License-Identifier: MIT
#pragma once

// A taught position with the parameters of the move to it. It contains the joint positions and the pose
// recorded during teaching, one of which is the target: the joint positions to reproduce the arm
// configuration, or the pose if the waypoint belongs to a frame and moves with it.

#include <QJsonObject>
#include <QString>
#include <QUuid>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/core/text.h"
#include "robot/project/waypoint_action.h"
#include "robot/project/waypoint_history.h"

namespace tiller::project {

using tiller::operator<<;  // makes the enumerations below printable

enum class MoveKind {
    Joint,   ///< MoveJ: all joints start and stop together
    Linear,  ///< MoveL: the TCP moves on a straight line
};

enum class TargetKind {
    Joints,  ///< `joints` is the target; `pose` is informative
    Pose,    ///< `pose` is the target; `joints` selects the solution
};

/// Default speeds and accelerations of a new waypoint. Source: defaults of the controller.
inline constexpr double kDefaultJointSpeed = 1.0471975511965976;         ///< [rad/s] 60 deg/s
inline constexpr double kDefaultJointAcceleration = 1.3962634015954636;  ///< [rad/s2] 80 deg/s2
inline constexpr double kDefaultToolSpeed = 0.25;                        ///< [m/s]
inline constexpr double kDefaultToolAcceleration = 1.2;                  ///< [m/s2]

/// Colour mark. The theme defines the displayed colour.
enum class WaypointColour { None, Blue, Orange, Green, Pink, Yellow, Sky };

/// The position of a waypoint in a pattern; columns, rows and layers count from 0.
struct PatternPlace {
    QUuid pattern;  ///< null: no pattern
    int column = 0;
    int row = 0;
    int layer = 0;
    bool isNull() const { return pattern.isNull(); }  ///< True without a pattern.
    friend bool operator==(const PatternPlace&, const PatternPlace&) = default;
};

struct Waypoint {
    QUuid id;
    QString name;
    MoveKind move = MoveKind::Joint;
    TargetKind priority = TargetKind::Joints;
    QUuid frame;     ///< reference frame of `pose`; null: base frame
    Pose tcpOffset;  ///< flange to TCP during teaching [m, rad]
    JointPositions joints;
    Pose pose;                               ///< TCP pose in `frame`
    double jointSpeed = kDefaultJointSpeed;  ///< used by MoveJ [rad/s]
    double toolSpeed = kDefaultToolSpeed;    ///< used by MoveL [m/s]
    double blend = 0;                        ///< [m]; 0: stop at the point
    QString group;                           ///< group name; may be empty
    WaypointColour colour = WaypointColour::None;
    QString note;             ///< may contain several lines
    WaypointActions actions;  ///< executed at the waypoint in this order
    PatternPlace place;       ///< position in the pattern that created it
    WaypointHistory history;
    QJsonObject extra;  ///< unknown fields of the file, preserved when saving

    /// Speed of the selected move type: [rad/s] or [m/s].
    double speed() const { return move == MoveKind::Joint ? jointSpeed : toolSpeed; }
    double acceleration() const {  ///< Acceleration of the selected move type: [rad/s2] or [m/s2]
        return move == MoveKind::Joint ? kDefaultJointAcceleration : kDefaultToolAcceleration;
    }
    friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

/// A taught coordinate system. When it is taught again, the waypoints in it move with it.
struct Frame {
    QUuid id;
    QString name;
    Pose T_base_frame;
    QJsonObject extra;
    friend bool operator==(const Frame&, const Frame&) = default;
};

}  // namespace tiller::project
