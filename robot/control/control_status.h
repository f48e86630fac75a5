// SPDX-License-Identifier: MIT
#pragma once

// State of a Controller, returned as a consistent copy. Fast enough to read in every frame of the user
// interface.

#include <array>
#include <cstdint>

#include "robot/control/motion_types.h"
#include "robot/core/modes.h"

namespace tiller::control {

/// Identifies one motion. IDs increase and are never reused.
using MotionId = std::uint64_t;
inline constexpr MotionId kNoMotion = 0;

/// Reason why this controller cannot move the arm.
enum class ControlLoss : std::uint8_t {
    None,           ///< in control
    NotTaken,       ///< takeControl() has not been called
    Taking,         ///< takeControl() is running
    Released,       ///< release() was called
    ScriptStopped,  ///< the teach pendant, another program or a safety stop ended or paused the control
                    ///< program
    EchoStalled,    ///< the control program is reported as running, but does not respond
    LinkLost,       ///< the connection failed or no data arrive
    OwnScript,      ///< a user script is running in place of the control program
    DataStale,      ///< the newest data are older than ControllerOptions::dataTimeout; cleared by new data
};

/// The limit that reduces the requested speed.
enum class LimiterKind : std::uint8_t {
    None,
    TcpSpeed,       ///< Tiller's speed cap, reached by the TCP
    ElbowSpeed,     ///< Tiller's speed cap, reached by the elbow
    JogSpeed,       ///< JogTarget::speedCap for TCP and elbow
    RotationSpeed,  ///< limit of the TCP rotation speed
    JointSpeed,     ///< speed limit of a joint
    JointLimit,     ///< a joint is near the limit of its range
    Singularity,    ///< the arm is near a singularity and moving towards it
    SelfCollision,  ///< `link` would come too close to the link `other`
    Obstacle,       ///< `link` would come too close to the box `other` of the environment
    Border,         ///< `link` would come too close to the floor or plane `other` of the environment
};

/// Jog: the current limit. Move: the limit along the whole path. Torque stream: the limit that ended it.
struct Limiter {
    LimiterKind kind = LimiterKind::None;
    int joint = -1;       ///< limiting joint 0..5; -1: no joint
    double distance = 0;  ///< JointLimit: distance to the limit [rad]; collision limits: clearance [m]
    double scale = 1;     ///< factor applied to the requested speed, 0..1
    int link = -1;        ///< collision limits: as collision::Contact::link; otherwise -1
    int other = -1;       ///< collision limits: as collision::Contact::other; otherwise -1
    bool brake = false;   ///< the arm approaches an object too fast and brakes as for a stop
};

enum class MotionPhase : std::uint8_t {
    Active,  ///< accepted and not yet ended
    Ended,   ///< the reason is in MotionState::cause
};

struct MotionState {
    MotionPhase phase = MotionPhase::Ended;
    StopCause cause =
        StopCause::None;  ///< Also None for unknown motions and for motions whose record has been overwritten
};

struct ControllerStatus {
    bool inControl = false;  ///< false if the data are older than ControllerOptions::dataTimeout
    ControlLoss loss = ControlLoss::NotTaken;
    bool fresh = false;  ///< data are not older than dataTimeout; if false, all following values are outdated
    RobotMode robotMode = RobotMode::NoController;
    SafetyMode safetyMode = SafetyMode::Undefined;

    MotionId motion = kNoMotion;  ///< the active motion
    bool moving = false;          ///< measured from the received data
    bool executing = false;       ///< control.script has confirmed the execution of `motion`
    Limiter limiter;              ///< limit of the active motion, or the limit at which the last motion ended
    MotionId lastMotion = kNoMotion;        ///< the last motion that ended
    StopCause lastCause = StopCause::None;  ///< cause of its end
    StopMeasurement lastStop;
    UnmeasuredStop lastUnmeasured;

    std::uint64_t epoch = 0;         ///< increases with every stop
    std::uint64_t restingEpoch = 0;  ///< newest epoch whose standstill the robot has confirmed
    double roundTripMs = 0;          ///< time from a command to its echo; 0: not known yet
    double speedFraction = 1;        ///< speed slider value
    double speedScaling = 1;         ///< speed reduction by the controller's own limits
    RuntimeState runtimeState = RuntimeState::Stopped;
    std::uint64_t playing = 0;           ///< number of packets that reported a running program
    std::uint32_t robotStatusBits = 0;   ///< as RTDE robot_status_bits
    std::uint32_t safetyStatusBits = 0;  ///< as RTDE safety_status_bits
    int waypoint = 0;                    ///< paths: current target, counted from 1
    std::array<double, 6> q{};           ///< actual joint positions in the newest data [rad]
    std::array<double, 6> tcpPose{};     ///< actual TCP pose in the base frame [m, rad]
    std::array<double, 6> tcpOffset{};   ///< flange to TCP [m, rad]
    bool forceMode = false;              ///< force mode is permitted, and active if a client has started it
    bool forceKnown = false;             ///< the robot reports the force at the TCP
    std::uint64_t ticks = 0;             ///< number of packets answered
    std::uint64_t late = 0;        ///< number of packets more than half a period late on the host's clock
    std::int64_t dataTimeNs = 0;   ///< arrival time of the newest data on the controller's Clock
    double answeredTime = 0;       ///< timestamp of the newest answered data [s]
    bool priorityGranted = false;  ///< the control thread has the requested priority
    bool fastWakeUps = false;      ///< deep sleep of the CPUs is disabled: realtime::CpuLatency
    bool cpusGranted = false;      ///< the control thread runs on the requested CPUs
};

}  // namespace tiller::control
