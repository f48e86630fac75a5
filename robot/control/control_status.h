// SPDX-License-Identifier: MIT
#pragma once

// What the controller tells about itself: one consistent copy, cheap enough to take in every frame.

#include <array>
#include <cstdint>

#include "robot/control/motion_types.h"
#include "robot/core/modes.h"

namespace tiller::control {

/// Names one motion from its start to its end. Numbers only ever grow; one that has ended never lives again.
using MotionId = std::uint64_t;
inline constexpr MotionId kNoMotion = 0;

/// Why the arm cannot be moved through this controller.
enum class ControlLoss : std::uint8_t {
    None,           ///< in control
    NotTaken,       ///< takeControl() has not been called
    Taking,         ///< takeControl() is under way
    Released,       ///< release() was called
    ScriptStopped,  ///< our program was stopped or paused: on the pendant, by another program, by a safety
                    ///< stop
    EchoStalled,    ///< the program is said to run but answers no more
    LinkLost,       ///< the connection broke, or data stopped coming
    OwnScript,      ///< a script of the user's runs in place of the control program
    DataStale,  ///< the newest data are older than ControllerOptions::dataTimeout; ends when data come again
};

/// What holds the asked-for speed down.
enum class LimiterKind : std::uint8_t {
    None,
    TcpSpeed,       ///< the cap on the TCP
    ElbowSpeed,     ///< the same cap on the elbow
    JogSpeed,       ///< TCP or elbow at the cap of this jog: JogTarget::speedCap
    RotationSpeed,  ///< the cap on the rotation of the TCP
    JointSpeed,     ///< a joint would turn too fast
    JointLimit,     ///< a joint is near the end of its range
    Singularity,    ///< the arm is near a singularity and would go deeper
    SelfCollision,  ///< `link` would come too near to the link `other`
    Obstacle,       ///< `link` would come too near to the box `other` of the surroundings
    Border,         ///< `link` would come too near to the floor or plane `other` of the surroundings
};

/// Of a jog: at this moment, and as the arm moves on. Of a move: for all of its way. Of torques: what they were
/// ended by.
struct Limiter {
    LimiterKind kind = LimiterKind::None;
    int joint = -1;       ///< 0..5 where a joint is to blame, else -1
    double distance = 0;  ///< JointLimit: left to the end of the range [rad]; collisions: between the two [m]
    double scale = 1;     ///< asked-for speed times this is what is sent, 0..1
    int link = -1;        ///< collisions: as collision::Contact::link, else -1
    int other = -1;       ///< collisions: as collision::Contact::other, else -1
    bool brake = false;   ///< the arm moves towards something faster than allowed: it slows down like a stop
};

enum class MotionPhase : std::uint8_t {
    Active,  ///< accepted and not ended
    Ended,   ///< see MotionState::cause
};

struct MotionState {
    MotionPhase phase = MotionPhase::Ended;
    StopCause cause = StopCause::None;  ///< None too for numbers never given, or ended very long ago
};

/// Threads  a plain copy
struct ControllerStatus {
    bool inControl = false;  ///< never by data older than ControllerOptions::dataTimeout
    ControlLoss loss = ControlLoss::NotTaken;
    bool fresh = false;  ///< the newest data are no older than that; otherwise all below describes the past
    RobotMode robotMode = RobotMode::NoController;
    SafetyMode safetyMode = SafetyMode::Undefined;

    MotionId motion = kNoMotion;      ///< the active one
    bool moving = false;              ///< measured on the received data, not what was asked
    bool executing = false;           ///< control.script confirmed that it executes `motion`
    Limiter limiter;                  ///< of the active motion; of the last one after it ended at a limit
    MotionId lastMotion = kNoMotion;  ///< the last one that ended
    StopCause lastCause = StopCause::None;  ///< and why
    StopMeasurement lastStop;

    std::uint64_t epoch = 0;         ///< moves on with every stop
    std::uint64_t restingEpoch = 0;  ///< newest epoch for which the robot said that it moves nothing
    double roundTripMs = 0;          ///< command out to echo back; 0 = not known yet
    double speedFraction = 1;        ///< speed slider
    double speedScaling = 1;         ///< what the controller's own limits leave of it
    RuntimeState runtimeState = RuntimeState::Stopped;
    std::uint32_t robotStatusBits = 0;   ///< as RTDE robot_status_bits
    std::uint32_t safetyStatusBits = 0;  ///< as RTDE safety_status_bits
    int waypoint = 0;                    ///< of a path, counted from 1: the one headed for
    std::array<double, 6> q{};           ///< actual joint positions of the newest data [rad]
    std::array<double, 6> tcpPose{};     ///< actual TCP pose in the base frame [m, rad]
    std::array<double, 6> tcpOffset{};   ///< flange to TCP [m, rad]
    bool forceMode = false;              ///< force mode may go on, and is on if it was begun
    bool forceKnown = false;             ///< the robot tells the force on its TCP
    std::uint64_t ticks = 0;             ///< data packages answered
    std::uint64_t late = 0;              ///< of those, more than half a period late by the host's clock
    std::int64_t dataTimeNs = 0;         ///< when the newest data arrived; by the controller's Clock
    double answeredTime = 0;             ///< time stamp of the newest data whose answer has been sent [s]
    bool priorityGranted = false;        ///< the control thread got the priority it asked for
    bool fastWakeUps = false;            ///< its processors are kept from deep sleep: realtime::CpuLatency
    bool cpusGranted = false;            ///< ... and the CPUs
};

}  // namespace tiller::control
