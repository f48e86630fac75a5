// SPDX-License-Identifier: MIT
#pragma once

// A taught place of the arm and how to go there. It keeps both the joints and the pose it was taught with,
// and says which of the two rules: joints for a place that must come back with the same arm posture, the pose
// for one that belongs to a frame and moves with it.

#include <QJsonObject>
#include <QString>
#include <QUuid>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/core/text.h"
#include "robot/project/waypoint_action.h"
#include "robot/project/waypoint_history.h"

namespace tiller::project {

using tiller::operator<<;  // for the enumerations below

enum class MoveKind {
    Joint,   ///< MoveJ: all joints start and stop together
    Linear,  ///< MoveL: the TCP goes along a straight line
};

enum class Ruling {
    Joints,  ///< `joints` is the target; `pose` is remembered
    Pose,    ///< `pose` is the target; `joints` picks the arm posture
};

/// Default speeds and accelerations of a new waypoint. Source: the controller's own defaults.
inline constexpr double kDefaultJointSpeed = 1.0471975511965976;         ///< [rad/s] 60 deg/s
inline constexpr double kDefaultJointAcceleration = 1.3962634015954636;  ///< [rad/s2] 80 deg/s2
inline constexpr double kDefaultToolSpeed = 0.25;                        ///< [m/s]
inline constexpr double kDefaultToolAcceleration = 1.2;                  ///< [m/s2]

/// A mark to find it by. Which colour it is on screen, the theme decides.
enum class WaypointColour { None, Blue, Orange, Green, Pink, Yellow, Sky };

/// Which place of which pattern a waypoint is; columns, rows and layers count from 0.
struct PatternPlace {
    QUuid pattern;  ///< null: of none
    int column = 0;
    int row = 0;
    int layer = 0;
    bool isNull() const { return pattern.isNull(); }  ///< Of no pattern.
    friend bool operator==(const PatternPlace&, const PatternPlace&) = default;
};

struct Waypoint {
    QUuid id;
    QString name;
    MoveKind move = MoveKind::Joint;
    Ruling ruling = Ruling::Joints;
    QUuid frame;     ///< of `pose`; null is the base frame
    Pose tcpOffset;  ///< flange to TCP at the time of teaching [m, rad]
    JointPositions joints;
    Pose pose;                               ///< of the TCP, in `frame`
    double jointSpeed = kDefaultJointSpeed;  ///< used by MoveJ [rad/s]
    double toolSpeed = kDefaultToolSpeed;    ///< used by MoveL [m/s]
    double blend = 0;                        ///< [m]; 0 stops in the point
    QString group;                           ///< those with the same word belong together; may be empty
    WaypointColour colour = WaypointColour::None;
    QString note;             ///< may have several lines
    WaypointActions actions;  ///< done there, in this order
    PatternPlace place;       ///< in the pattern that made it
    WaypointHistory history;
    QJsonObject extra;  ///< fields of the file that this version does not know

    /// Speed and acceleration of its kind of move: [rad/s, rad/s2] or [m/s, m/s2].
    double speed() const { return move == MoveKind::Joint ? jointSpeed : toolSpeed; }
    double acceleration() const {  ///< [rad/s2] or [m/s2]
        return move == MoveKind::Joint ? kDefaultJointAcceleration : kDefaultToolAcceleration;
    }
    friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

/// A taught coordinate system. Waypoints given in it move when it is taught anew.
struct Frame {
    QUuid id;
    QString name;
    Pose T_base_frame;
    QJsonObject extra;
    friend bool operator==(const Frame&, const Frame&) = default;
};

}  // namespace tiller::project
