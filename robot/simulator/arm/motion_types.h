// SPDX-License-Identifier: MIT
#pragma once

// Types for motion commands and their results: targets, parameters, handles, errors, stops.

#include <array>
#include <cstdint>
#include <variant>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"

namespace tiller::simulator::arm {

/// A waypoint given by joint positions or by a TCP pose in the base frame.
using MoveTarget = std::variant<JointPositions, Pose>;

/// moveJ: a [rad/s2], v [rad/s] of the leading axis. moveL, moveP, moveC: a [m/s2], v [m/s]. For moveJ and
/// moveL, t [s] above 0 overrides a and v. r [m] is the blend radius.
struct MoveParameters {
    double a = 1.2;
    double v = 0.25;
    double t = 0;
    double r = 0;
};

/// Mode of movec.
enum class ArcOrientation : std::uint8_t {
    Interpolated,  ///< mode 0: from the start orientation to the target orientation
    FixedToArc,    ///< mode 1: rotates with the arc and ignores the target orientation
};

/// Identifies a motion command. 0 is invalid. IDs only increase.
using MotionId = std::uint64_t;

/// Why a command was refused. The script that issued the command ends with a runtime error.
enum class MotionError : std::uint8_t {
    None,
    InvalidArgument,        ///< not a number, acceleration or speed not positive, lookahead out of range ...
    JointTargetOutOfRange,  ///< a joint is beyond its range
    NoInverseKinematics,    ///< moveJ to an unreachable pose
    NotOperational,         ///< drives not running, or protective stop not cleared
    Busy,                   ///< a blend is already waiting for its next move
};

/// Result of a motion command: a handle or an error.
struct MotionStart {
    MotionId id = 0;
    MotionError error = MotionError::None;
    int joint = -1;  ///< the joint that caused the error, or -1
    bool ok() const { return error == MotionError::None; }
};

/// Progress of a command. A blocking caller waits while the progress is Running.
enum class MotionProgress : std::uint8_t {
    Running,     ///< the calling thread waits
    Returned,    ///< target reached, blend zone reached, time elapsed, or standstill
    Superseded,  ///< replaced by another command, or abandoned
    Failed,      ///< ended by a protective stop
};

/// Reason for a protective stop by the arm. The arm decelerates and then refuses motion until the stop is
/// cleared.
enum class StopReason : std::uint8_t {
    Singularity,         ///< Cartesian motion into or through a singular position
    PoseUnreachable,     ///< a target or a point of a Cartesian path is out of reach
    JointPositionLimit,  ///< a joint reached the end of its range
    JointSpeedLimit,     ///< the path cannot be followed within the joint limits
    TcpForceLimit,       ///< the contact force exceeds the limit
    PathDeviation,       ///< force mode: a non-compliant axis left its path
    Overload,            ///< the joints cannot hold the load
    WrongPayload,        ///< freedrive with an unknown load, or with the arm pushed at the start
};

struct ProtectiveStop {
    StopReason reason = StopReason::Singularity;
    int joint = -1;  ///< the affected joint, or -1
    MotionId motion = 0;
};

enum class MotionWarning : std::uint8_t {
    OverlappingBlends,  ///< a waypoint was skipped because its blend zone overlaps the previous one
};

/// Name for logs, e.g. "Singularity" or "JointTargetOutOfRange".
const char* stopReasonName(StopReason reason);
const char* motionErrorName(MotionError error);

/// Parameters of force_mode().
struct ForceModeParameters {
    Pose T_base_task;                 ///< force frame in the base frame
    std::array<bool, 6> compliant{};  ///< x y z rx ry rz of the force frame
    Wrench wrench;                    ///< requested wrench along compliant axes, force frame [N, Nm]
    int type = 2;                     ///< 1, 2 or 3: how the frame is transformed
    /// For compliant axes, the maximum TCP speed [m/s, rad/s]. For the other axes, the maximum deviation from
    /// the path [m, rad].
    Vector6 limits = Vector6::Constant(0.1);
    bool followTool = false;  ///< the axes are those of the tool; T_base_task is unused
};

/// Parameters of freedrive_mode().
struct FreedriveParameters {
    std::array<bool, 6> freeAxes{true, true, true, true, true, true};  ///< x y z rx ry rz of the feature
    Pose T_base_feature;      ///< feature in the base frame; unused with `followTool`
    bool followTool = false;  ///< feature "tool": the axes rotate with the tool
};

/// Options for unknown behaviour of a real arm. See assumptions.h.
struct Readings {
    bool stopsScaled = false;         ///< stopj and stopl run in program time
    bool programStopsScaled = false;  ///< protective stops and abort() run in program time
    bool speedCommandsScaled = true;  ///< speedj, speedl, servoj and servoc run in program time
    bool compliesInPause = false;     ///< force mode and freedrive continue while the program is paused
};

}  // namespace tiller::simulator::arm
