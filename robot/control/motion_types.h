// SPDX-License-Identifier: MIT
#pragma once

// What may be asked of the arm, why it stops, and what a stop measured. Plain data, shared by the controller,
// the session and the widgets.

#include <array>
#include <chrono>
#include <cstdint>
#include <limits>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/core/text.h"

namespace tiller::control {

using tiller::operator<<;  // for the enumerations below

/// How long a held motion lasts without a refresh, and what has no end of its own without a heartbeat of this
/// computer.
inline constexpr std::chrono::milliseconds kHoldTime{100};
/// How long after the newest packet from this computer the arm is at standstill, whether that packet brought a stop
/// or no other one followed: the faster the arm, the harder it brakes. No joint is asked for more than
/// kJointAccelerationLimit, which is enough up to 4.4 rad/s; and the arm takes longer where its drives or its load
/// permit less.
inline constexpr std::chrono::milliseconds kStandstillTime{210};
/// The longest silence a move may be given (MoveParameters::silence): after 5 s the control program ends.
inline constexpr std::chrono::milliseconds kLongestSilence{4'000};

/// Held: ends when its holder does not refresh it for 100 ms. Free: needs no holder, and ends when it is done,
/// when it is stopped, and when the robot has heard nothing of this computer for 100 ms (a move with an end:
/// for MoveParameters::silence).
enum class Holding : std::uint8_t { Held, Free };

/// Whether something may move the arm although no client supervises it.
enum class Supervision : std::uint8_t {
    Heartbeat,  ///< the arm brakes when the client ends, closes the connection or sends nothing for 100 ms
    /// The arm moves on after the client has ended, until the motion or program is done. No one but a person
    /// at the pendant, or another client, can stop it then.
    Unattended,
};

enum class JogFrame : std::uint8_t {
    Base,    ///< axes of the controller's base frame
    Tool,    ///< axes of the tool, followed while it turns
    Custom,  ///< axes of JogTarget::T_base_frame (a taught frame, or the direction the operator looks from)
};

/// A cap that is none: the robot's own limits remain.
inline constexpr double kNoCap = std::numeric_limits<double>::infinity();

/// A velocity the arm shall have until it is refreshed, changed or expires. Rotation is about the active TCP.
struct JogTarget {
    enum class Kind : std::uint8_t { Cartesian, Joint };
    Kind kind = Kind::Cartesian;
    JogFrame frame = JogFrame::Base;
    Twist twist = {};         ///< Cartesian: in the axes of `frame` [m/s, rad/s]
    JointVelocities qd = {};  ///< Joint [rad/s]
    Pose T_base_frame = {};   ///< only for JogFrame::Custom; its rotation counts, its position does not
    /// Above 0: ends with StopCause::Contact when the force on the TCP has changed by more than this since
    /// the motion began [N].
    double contactForce = 0;
    /// Highest speed of TCP and elbow in this jog [m/s], above 0. The cap of the controller applies as well. A joint
    /// jog needs it: how fast the TCP gets at a joint speed depends on the posture.
    double speedCap = kNoCap;

    friend bool operator==(const JogTarget&, const JogTarget&) = default;
};

/// Why a motion ended. Each has its own sentence in the interface.
enum class StopCause : std::uint8_t {
    None,
    Released,
    PointerLeft,
    FocusLost,
    WindowDeactivated,
    WindowClosed,
    DialogOpened,
    SelectionChanged,  ///< tab, perspective, frame, TCP, mode, step or speed class
    SecondButton,
    Escape,
    Space,
    StopButton,
    DeviceLost,
    DataStale,
    UnsafeMode,
    EventLoopStalled,  ///< the caller did not refresh in time
    Sleep,
    LinkLost,
    LimitReached,
    ControlLost,
    Completed,     ///< a bounded motion reached its target
    ApiCall,       ///< a program called stop()
    Superseded,    ///< a newer command took the one slot
    Contact,       ///< contact detection found what it was started for
    Unreachable,   ///< a target for which the robot finds no joint positions
    TargetTooFar,  ///< a servo target further off than the arm could get since the one before
    HoldUnproven,  ///< nothing proved any more that the key, button or finger was still down
    HeldTooLong,   ///< held for the longest time a motion may be held
};

/// A servo stream leads the arm in small steps: no target may lie further from the one before than the arm
/// can get in the time since (its joints' highest speeds; the tool's 3 m/s), and this much more, for what the
/// arm's place was measured with and for packages that come late. The first target is judged from where the
/// arm is. servoC is exempt: it goes to its target at its own speed, however far that is.
inline constexpr double kJointLeeway = 0.02;      ///< [rad], of each joint and of the tool's rotation
inline constexpr double kToolLeeway = 0.01;       ///< [m]
inline constexpr double kLongestServoStep = 0.1;  ///< [s]: after a longer silence no more than in this time

/// From the moment the stop was asked for to standstill, measured on the data received from the robot.
struct StopMeasurement {
    StopCause cause = StopCause::None;
    double durationMs = 0;
    double distanceMm = 0;    ///< path length of the TCP
    std::uint64_t count = 0;  ///< number of stops measured so far; 0 = none yet
};

/// What the controller says its joints can do.
struct JointLimits {
    std::array<double, 6> minPosition{};  ///< [rad]
    std::array<double, 6> maxPosition{};  ///< [rad]
    std::array<double, 6> maxSpeed{};     ///< [rad/s]
};

/// Jog dynamics and caps. Decelerations are the least ones: see kStandstillTime. The controller has its own, wider ones. All above 0; takeControl() refuses what can
/// only be another unit: above 3 m/s, 12 rad/s, 150 m/s2, 40 rad/s2. kNoCap is a speed without a cap.
struct MotionLimits {
    double tcpSpeed = 0.250;                       ///< of TCP and elbow [m/s]; also Controller::setSpeedCap
    double tcpRotationSpeed = 0.7853981633974483;  ///< [rad/s] 45 deg/s
    double jointSpeed = 0.5235987755982988;        ///< [rad/s] 30 deg/s
    double jogAcceleration = 0.5;                  ///< [m/s2]
    double jogDeceleration = 2.0;                  ///< [m/s2]
    double jointAcceleration = 2.0;                ///< [rad/s2]
    double jointDeceleration = 4.0;                ///< [rad/s2]
};

}  // namespace tiller::control
