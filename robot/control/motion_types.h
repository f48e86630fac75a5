// SPDX-License-Identifier: MIT
#pragma once

// Motion types, causes of stops and stop measurements. Plain data shared by the controller, the session and
// the widgets.

#include <array>
#include <chrono>
#include <cstdint>
#include <limits>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/core/text.h"

namespace tiller::control {

using tiller::operator<<;  // required for the enumerations below

/// Maximum time between two refreshes of a Held motion. Also the maximum time without a heartbeat of this PC
/// for motions without a target.
inline constexpr std::chrono::milliseconds kHoldTime{100};
/// Maximum time until the arm is at standstill, counted from the packet that contains the stop or, if packets
/// stop arriving, from the last packet of this PC. The deceleration increases with the speed of the arm. The
/// deceleration of a joint never exceeds kJointAccelerationLimit, which is sufficient up to 4.4 rad/s.
/// Stopping takes longer if the drives or the load do not permit the deceleration.
inline constexpr std::chrono::milliseconds kStandstillTime{210};
/// Maximum of MoveParameters::heartbeatTimeout. The control program ends after 5 s without a heartbeat.
inline constexpr std::chrono::milliseconds kMaxHeartbeatTimeout{4'000};

/// Held: ends if it is not refreshed for 100 ms. Free: needs no refresh. A Free motion ends when it is
/// complete, when it is stopped, or when the robot has received no heartbeat of this PC for 100 ms (for a
/// move with a target: MoveParameters::heartbeatTimeout).
enum class Holding : std::uint8_t { Held, Free };

/// Determines whether the arm may move without supervision by a client.
enum class Supervision : std::uint8_t {
    Heartbeat,  ///< the arm brakes when the client exits, disconnects or sends nothing for 100 ms
    /// The arm continues until the motion or program is complete, even after the client has exited.
    /// Meanwhile, only a person at the teach pendant or another client can stop it.
    Unattended,
};

enum class JogFrame : std::uint8_t {
    Base,    ///< axes of the controller's base frame
    Tool,    ///< axes of the tool, which rotate with the tool
    Custom,  ///< axes of JogTarget::T_base_frame (a taught frame, or the viewing direction)
};

/// No cap: only the robot's own limits apply.
inline constexpr double kNoCap = std::numeric_limits<double>::infinity();

/// A requested velocity of the arm, valid until it is refreshed, changed or expires. Rotations are about the
/// active TCP.
struct JogTarget {
    enum class Kind : std::uint8_t { Cartesian, Joint };
    Kind kind = Kind::Cartesian;
    JogFrame frame = JogFrame::Base;
    Twist twist = {};         ///< Cartesian: along and about the axes of `frame` [m/s, rad/s]
    JointVelocities qd = {};  ///< Joint [rad/s]
    Pose T_base_frame = {};   ///< only for JogFrame::Custom; only the rotation is used
    /// If above 0 [N], a change of the force at the TCP by more than this value since the start of the jog
    /// ends the jog with StopCause::Contact.
    double contactForce = 0;
    /// Maximum speed of TCP and elbow in this jog [m/s], above 0, in addition to the cap of the controller.
    /// Needed for joint jogs, because their TCP speed depends on the posture.
    double speedCap = kNoCap;

    friend bool operator==(const JogTarget&, const JogTarget&) = default;
};

/// Why a motion ended. The user interface has a separate text for each cause.
enum class StopCause : std::uint8_t {
    None,
    Released,
    PointerLeft,
    FocusLost,
    WindowDeactivated,
    WindowClosed,
    DialogOpened,
    SelectionChanged,  ///< change of tab, perspective, frame, TCP, mode, step or speed class
    SecondButton,
    Escape,
    Space,
    StopButton,
    DeviceLost,
    DataStale,
    UnsafeMode,
    EventLoopStalled,  ///< the caller did not refresh the motion within kHoldTime
    Sleep,
    LinkLost,
    LimitReached,
    ControlLost,
    Completed,     ///< a bounded motion reached its target
    ApiCall,       ///< a program called stop()
    Superseded,    ///< replaced by a newer command
    Contact,       ///< contact detected
    Unreachable,   ///< the robot finds no joint positions for the target
    TargetTooFar,  ///< servo target too far from the previous target: see kJointLeeway
    HoldUnproven,  ///< the key, button or finger is not verified as still pressed
    HeldTooLong,   ///< held longer than the maximum time
};

/// Tolerance for the distance between two targets of a servo stream, for measurement errors and late
/// packages. The distance must not exceed this tolerance plus the distance that the arm can move in the time
/// between the targets (maximum joint speeds; 3 m/s for the tool). The first target is compared with the arm
/// position. servoC has no such limit, because the arm moves to its target at a configured speed.
inline constexpr double kJointLeeway = 0.02;  ///< [rad], for each joint and for the tool's rotation
inline constexpr double kToolLeeway = 0.01;   ///< [m]
inline constexpr double kMaxServoStep = 0.1;  ///< [s]: maximum time used in this calculation

/// Measurement of a stop from the request to standstill, from robot data.
struct StopMeasurement {
    StopCause cause = StopCause::None;
    double durationMs = 0;
    double distanceMm = 0;    ///< path length of the TCP
    std::uint64_t count = 0;  ///< number of stops measured so far; 0: none
};

/// A stop whose time and distance are unknown.
struct UnmeasuredStop {
    enum class Reason : std::uint8_t {
        DataGap,       ///< no data arrived while the arm was stopping
        OtherProgram,  ///< a program of another client moved the arm before standstill
        NotStopped,    ///< the stop did not reach the robot; determined by RobotSession
    };
    StopCause cause = StopCause::None;
    Reason reason = Reason::DataGap;
    std::uint64_t count = 0;  ///< number of such stops so far; 0: none
};

/// Joint limits reported by the controller.
struct JointLimits {
    std::array<double, 6> minPosition{};  ///< [rad]
    std::array<double, 6> maxPosition{};  ///< [rad]
    std::array<double, 6> maxSpeed{};     ///< [rad/s]
};

/// Dynamics and caps of jogs. The decelerations are minimum values: see kStandstillTime. The controller's own
/// limits are higher. All values must be above 0. takeControl() refuses values that suggest a wrong unit:
/// above 3 m/s, 12 rad/s, 150 m/s2, 40 rad/s2. Speeds may be kNoCap.
struct MotionLimits {
    double tcpSpeed = 0.250;  ///< cap of TCP and elbow [m/s]; see also Controller::setSpeedCap
    double tcpRotationSpeed = 0.7853981633974483;  ///< [rad/s] 45 deg/s
    double jointSpeed = 0.5235987755982988;        ///< [rad/s] 30 deg/s
    double jogAcceleration = 0.5;                  ///< [m/s2]
    double jogDeceleration = 2.0;                  ///< [m/s2]
    double jointAcceleration = 2.0;                ///< [rad/s2]
    double jointDeceleration = 4.0;                ///< [rad/s2]
};

}  // namespace tiller::control
