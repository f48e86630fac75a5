// SPDX-License-Identifier: MIT
#pragma once

// The state of a Controller: a consistent copy, cheap enough to read in every frame.

#include <array>
#include <cstdint>

#include "robot/control/motion_types.h"
#include "robot/core/modes.h"

namespace tiller::control {

/// Identifies one motion. Numbers increase and are never reused.
using MotionId = std::uint64_t;
inline constexpr MotionId kNoMotion = 0;

/// The reason why the arm cannot be moved through this controller.
enum class ControlLoss : std::uint8_t {
    None,      ///< in control
    NotTaken,  ///< takeControl() has not been called
    Taking,    ///< takeControl() is in progress
    Released,  ///< release() was called
    ScriptStopped,  ///< the control program was stopped or paused: by the pendant, another program or a safety stop
    EchoStalled,  ///< the program is reported as running but does not respond
    LinkLost,     ///< the connection failed, or no data arrive
    OwnScript,    ///< a user script is running instead of the control program
    DataStale,  ///< the newest data are older than ControllerOptions::dataTimeout; ends when new data arrive
};

/// The limit that reduces the requested speed.
enum class LimiterKind : std::uint8_t {
    None,
    TcpSpeed,       ///< speed limit of the TCP
    ElbowSpeed,     ///< the same limit, applied to the elbow
    JogSpeed,       ///< TCP or elbow at the limit of this jog: JogTarget::speedCap
    RotationSpeed,  ///< limit of the TCP rotation
    JointSpeed,     ///< a joint would exceed its speed limit
    JointLimit,     ///< a joint is near the limit of its range
    Singularity,    ///< the arm is near a singularity and would approach it further
    SelfCollision,  ///< `link` would come too close to the link `other`
    Obstacle,       ///< `link` would come too close to the box `other` of the surroundings
    Border,         ///< `link` would come too close to the floor or plane `other` of the surroundings
};

/// For a jog: the current limit. For a move: the limit over the whole path. For torques: the reason for the end.
struct Limiter {
    LimiterKind kind = LimiterKind::None;
    int joint = -1;       ///< the limiting joint 0..5, else -1
    double distance = 0;  ///< JointLimit: distance to the limit [rad]; collisions: clearance [m]
    double scale = 1;     ///< factor applied to the requested speed, 0..1
    int link = -1;        ///< collisions: as collision::Contact::link, else -1
    int other = -1;       ///< collisions: as collision::Contact::other, else -1
    bool brake = false;   ///< the arm approaches an object faster than allowed and decelerates as for a stop
};

enum class MotionPhase : std::uint8_t {
    Active,  ///< accepted and not ended
    Ended,   ///< the reason is in MotionState::cause
};

struct MotionState {
    MotionPhase phase = MotionPhase::Ended;
    StopCause cause =
        StopCause::None;  ///< Also None for unknown motions and for motions that ended very long ago
};

/// Threads  a plain copy
struct ControllerStatus {
    bool inControl = false;  ///< false if the data are older than ControllerOptions::dataTimeout
    ControlLoss loss = ControlLoss::NotTaken;
    bool fresh =
        false;  ///< the newest data are not older than this; otherwise all following values are outdated
    RobotMode robotMode = RobotMode::NoController;
    SafetyMode safetyMode = SafetyMode::Undefined;

    MotionId motion = kNoMotion;      ///< the active motion
    bool moving = false;              ///< measured from the received data
    bool executing = false;           ///< control.script has confirmed the execution of `motion`
    Limiter limiter;                  ///< for the active motion; after an end at a limit, for the last one
    MotionId lastMotion = kNoMotion;  ///< the last motion that ended
    StopCause lastCause = StopCause::None;  ///< the reason for its end
    StopMeasurement lastStop;

    std::uint64_t epoch = 0;         ///< increases with every stop
    std::uint64_t restingEpoch = 0;  ///< newest epoch for which the robot has confirmed standstill
    double roundTripMs = 0;          ///< from a command to its echo; 0: not known yet
    double speedFraction = 1;        ///< speed slider
    double speedScaling = 1;         ///< reduction by the controller's own limits
    RuntimeState runtimeState = RuntimeState::Stopped;
    std::uint32_t robotStatusBits = 0;   ///< as RTDE robot_status_bits
    std::uint32_t safetyStatusBits = 0;  ///< as RTDE safety_status_bits
    int waypoint = 0;                    ///< path: current target, counted from 1
    std::array<double, 6> q{};           ///< actual joint positions of the newest data [rad]
    std::array<double, 6> tcpPose{};     ///< actual TCP pose in the base frame [m, rad]
    std::array<double, 6> tcpOffset{};   ///< flange to TCP [m, rad]
    bool forceMode = false;              ///< force mode is permitted, and active if it was started
    bool forceKnown = false;             ///< the robot reports the force at its TCP
    std::uint64_t ticks = 0;             ///< number of data packages answered
    std::uint64_t late = 0;              ///< packages more than half a period late on the host's clock
    std::int64_t dataTimeNs = 0;         ///< arrival of the newest data on the controller's Clock
    double answeredTime = 0;             ///< time stamp of the newest answered data [s]
    bool priorityGranted = false;        ///< the requested priority of the control thread was granted
    bool fastWakeUps = false;            ///< deep sleep of the CPUs is disabled: realtime::CpuLatency
    bool cpusGranted = false;            ///< the requested CPUs were granted
};

}  // namespace tiller::control
