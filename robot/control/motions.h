// SPDX-License-Identifier: MIT
#pragma once

// Starts all motions of the arm:
//
//   control::Motions motions(controller);
//   auto move = motions.moveJ({0, -1.57, 1.57, -1.57, -1.57, 0}, {.speed = 0.5});
//   if (move) {
//       const auto reached = move->wait(Deadline::after(30s));
//   }
//
// A command ends the active motion; nothing is queued. Each motion ends as follows:
//
//   moveJ, moveL and the like   at the target; without a heartbeat for MoveParameters::heartbeatTimeout
//   movePath                    at the last target; without a heartbeat as above
//   moveUntilContact            at the contact; 100 ms without refresh(), unless Free
//   startJog                    100 ms without refresh(), unless Free; at a limit; at its contactForce
//   servo, speed and torque     100 ms without send(), unless Free; torques above the speed cap
//   stopJ, stopL                at standstill
//
// In addition, all motions end with a newer command, a stop, cancel() of the handle, a robot mode other than
// RUNNING, a safety mode other than NORMAL or REDUCED, the end or pause of the control program, or the loss
// of the connection. The robot ends both Held and Free motions without a target after 100 ms without a
// heartbeat of this PC, so that the arm stops if the process crashes or hangs.
//
// Speed limit: TCP and elbow never exceed the cap, 0.25 m/s by default (ControllerOptions::limits,
// Controller::setSpeedCap). Moves are slowed down accordingly. Motion::plan() and ControllerStatus::limiter
// report the limit, the factor and the duration of the move. A torque stream cannot be slowed down, so it
// ends when the cap is exceeded: see setpoints.h.

#include <chrono>
#include <cstdint>
#include <optional>

#include "robot/control/controller.h"
#include "robot/control/jog.h"
#include "robot/control/motion.h"
#include "robot/control/motion_path.h"
#include "robot/control/setpoints.h"

namespace tiller::control {

struct MoveParameters {
    /// moveJ, moveJToPose: speed of the joint with the largest rotation [rad/s], default 1.05. moveL,
    /// moveLToJoints: TCP speed [m/s], default 0.25, or the cap if it is lower. > 0.
    std::optional<double> speed = {};
    /// moveJ, moveJToPose [rad/s2], default 1.4. moveL, moveLToJoints [m/s2], default 1.2. > 0.
    std::optional<double> acceleration = {};
    Holding holding = Holding::Free;
    /// Maximum time for which a Free move continues without a heartbeat of this PC, e.g. during high CPU load
    /// or while a cable is replugged: 100 ms ... 4 s. The arm moves unsupervised during this time. The robot
    /// then ends the move. A Held move always ends after 100 ms.
    std::chrono::milliseconds heartbeatTimeout = kHoldTime;
};

/// Contacts that end moveUntilContact().
enum class Sought : std::uint8_t {
    NewContact,  ///< an initial contact must be released first
    AnyContact,  ///< an initial contact counts, so the arm does not move
};

struct ContactParameters {
    Twist direction = {};       ///< direction of the contact in the base frame; zeros: any direction
    double acceleration = 0.5;  ///< [m/s2]; > 0
    Sought sought = Sought::NewContact;
    Holding holding = Holding::Held;
};

/// A path that was sent to the robot and can be started. Any motion or stop invalidates it.
class PreparedPath {
public:
    PreparedPath() = default;  ///< Creates an invalid path.

private:
    friend class Motions;
    std::uint64_t epoch_ = 0;
    int waypoints_ = 0;
};

/// All arguments are checked before a command is sent. Errors contain the name of the invalid argument.
/// Errors   of every command: NotInControl, UnsafeState, LinkLost; InvalidArgument (NaN, or a value that
///          suggests degrees or millimetres), LimitExceeded (outside the range of a joint, above the limits
///          of the arm, or a tool speed above the cap), NoSolution (unreachable pose), Stopped (a concurrent
///          stop)
/// Threads  any. Blocks: never, except for functions with a deadline. The controller must outlive this object
///          and all handles
class Motions {
public:
    explicit Motions(Controller& controller) : controller_(&controller) {}
    /// For motions that are prepared before they start, and for sequences of motions. All commands fail with
    /// Stopped if a stop has occurred since Controller::stops() returned this value.
    Motions(Controller& controller, std::uint64_t stops) : controller_(&controller), stops_(stops) {}

    /// Moves linearly in joint space to the target [rad]. Source: URScript movej
    Result<Motion> moveJ(const JointPositions& target, const MoveParameters& parameters = {});
    /// Like moveJ(), to the joint positions with this TCP pose [m, rad] that are nearest to the current joint
    /// positions.
    Result<Motion> moveJToPose(const Pose& target, const MoveParameters& parameters = {});
    /// Moves the TCP on a straight line to a pose in the base frame [m, rad]. Source: URScript movel
    Result<Motion> moveL(const Pose& target, const MoveParameters& parameters = {});
    /// Like moveL(), to the TCP pose at these joint positions.
    Result<Motion> moveLToJoints(const JointPositions& target, const MoveParameters& parameters = {});
    /// Follows the whole path to its last target. The control program is sent again together with the path.
    /// The arm must be at standstill.
    /// start    time limit for sending; use the handle to wait for the end of the path
    /// heartbeatTimeout  as MoveParameters::heartbeatTimeout
    /// Errors   also Timeout, Cancelled, ScriptError (with line and text)
    Result<Motion> movePath(const MotionPath& path, const Deadline& start, Holding holding = Holding::Free,
                            std::chrono::milliseconds heartbeatTimeout = kHoldTime);
    /// First part of movePath(): sends the path without moving. For hold-to-run operation from a thread that
    /// must not block.
    Result<PreparedPath> preparePath(const MotionPath& path, const Deadline& start);
    /// Second part of movePath(): starts the path. Blocks: never
    /// Errors   also Stopped if any motion or stop has occurred since the preparation
    Result<Motion> startPath(const PreparedPath& path, Holding holding = Holding::Free,
                             std::chrono::milliseconds heartbeatTimeout = kHoldTime);

    /// Moves the tool until contact, and then back to the pose of the first contact. If parameters.holding is
    /// Held (the default), call Motion::refresh() at least every 100 ms, or the arm stops.
    /// twist    base frame [m/s, rad/s]
    /// start    time limit for setting up the contact detection
    /// Source   URScript tool_contact
    /// Errors   also VersionUnsupported (software before 5.4), Timeout, Cancelled
    Result<Motion> moveUntilContact(const Twist& twist, const Deadline& start,
                                    const ContactParameters& parameters = {});

    /// Moves at a velocity until the jog is refreshed with another velocity or ended. A velocity above the
    /// limits is reduced, not refused. If `holding` is Held, call Jog::refresh() at least every 100 ms, or
    /// the arm stops.
    /// Errors   also FieldUnknown (contactForce on a robot that does not report forces)
    Result<Jog> startJog(const JogTarget& target, Holding holding = Holding::Held);

    /// Starts a stream. Until the first target is sent, the target is the current position (servo) or zero
    /// (speed).
    /// holding  Held: the stream ends and the arm stops after 100 ms without a new target. Free: the last
    ///          target remains active until the stream ends
    /// Source   URScript servoj, servoc, speedj, speedl
    Result<JointServo> startServoJ(const ServoParameters& parameters = {}, Holding holding = Holding::Held);
    /// Like startServoJ(), with TCP poses in the base frame.
    Result<PoseServo> startServoL(const ServoParameters& parameters = {}, Holding holding = Holding::Held);
    /// Like startServoJ(), with TCP poses that are approached at a configured speed. Source: URScript servoc
    Result<CircularServo> startServoC(const CircularServoParameters& parameters = {},
                                      Holding holding = Holding::Held);
    /// Like startServoJ(), with joint velocities.
    Result<JointSpeed> startSpeedJ(const SpeedParameters& parameters = {}, Holding holding = Holding::Held);
    /// Like startServoJ(), with twists of the TCP.
    Result<ToolSpeed> startSpeedL(const SpeedParameters& parameters = {}, Holding holding = Holding::Held);

    /// Like startServoJ(), with joint torques. The controller holds the arm position until the first torques
    /// are sent. The torques exclude gravity: the controller compensates it for the arm and the configured
    /// payload. The stream ends with damping if the speed cap is exceeded: see setpoints.h.
    /// Source   URScript direct_torque
    /// Errors   also VersionUnsupported (software before 5.25.1, PolyScope X before 10.12.1, CB3)
    Result<JointTorque> startTorque(const TorqueParameters& parameters = {}, Holding holding = Holding::Held);

    /// Ends the active motion, if any; the handle completes at standstill. deceleration > 0: of the leading
    /// joint [rad/s2]. Source: URScript stopj
    Result<Motion> stopJ(double deceleration = 4.0, StopCause cause = StopCause::ApiCall);
    /// Like stopJ(), along the path of the tool. deceleration > 0 [m/s2]; rotationDeceleration [rad/s2], 0:
    /// same value. Source: URScript stopl
    Result<Motion> stopL(double deceleration = 2.0, double rotationDeceleration = 0,
                         StopCause cause = StopCause::ApiCall);

private:
    std::uint64_t stops() const;

    Controller* controller_;
    std::optional<std::uint64_t> stops_;
};

}  // namespace tiller::control
