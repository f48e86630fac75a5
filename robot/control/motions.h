// SPDX-License-Identifier: MIT
#pragma once

// The one door for everything that moves the arm:
//
//   control::Motions motions(controller);
//   auto move = motions.moveJ({0, -1.57, 1.57, -1.57, -1.57, 0}, {.speed = 0.5});
//   if (move) {
//       const auto reached = move->wait(Deadline::after(30s));
//   }
//
// A command ends what was active before it; nothing is queued. What ends each motion by itself:
//
//   moveJ, moveL and the like   the target; a silence of this computer longer than MoveParameters::silence
//   movePath                    its last target; the same
//   moveUntilContact            the contact; 100 ms without refresh(), unless Free
//   startJog                    100 ms without refresh(), unless Free; a limit in its way; its contactForce
//   servo, speed and torque     100 ms without send(), unless Free; torques above the cap on speed
//   stopJ, stopL                standstill
//
// And any of them: a newer command, a stop, cancel() of its handle, a robot mode other than RUNNING, a safety
// mode other than NORMAL or REDUCED, the end or pause of the control program, the loss of the link. Free or
// not, what has no end of its own is ended by the robot after 100 ms without a sign of life of this computer:
// a process that dies or hangs leaves an arm that stands.
//
// Whatever speed is asked for: TCP and elbow get no faster than the cap, 0.25 m/s unless it was set otherwise
// (ControllerOptions::limits, Controller::setSpeedCap). A move is slowed down for it: Motion::plan() and
// ControllerStatus::limiter say by what and how much, and how long the move takes. A stream of torques cannot be
// slowed down: it ends there, see setpoints.h.

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
    /// moveJ, moveJToPose: of the joint that turns most [rad/s], otherwise 1.05. moveL, moveLToJoints: of the
    /// TCP [m/s], otherwise 0.25, or the cap where that is lower. Above 0.
    std::optional<double> speed = {};
    /// moveJ, moveJToPose [rad/s2], otherwise 1.4. moveL, moveLToJoints [m/s2], otherwise 1.2. Above 0.
    std::optional<double> acceleration = {};
    Holding holding = Holding::Free;
    /// A Free move goes on when this computer falls silent for no longer than this (a busy machine, a cable
    /// that is plugged in anew); after that the robot ends it by itself. So long the arm moves on unattended:
    /// 100 ms ... 4 s. A Held one always ends after 100 ms.
    std::chrono::milliseconds silence = kHoldTime;
};

/// Which contact a move looks for.
enum class Sought : std::uint8_t {
    NewContact,  ///< what touches at the start has to let go first
    AnyContact,  ///< one that is there at the start counts: then the arm does not move
};

struct ContactParameters {
    Twist direction = {};       ///< from which contact is looked for, base frame; zeros: any
    double acceleration = 0.5;  ///< [m/s2]; above 0
    Sought sought = Sought::NewContact;
    Holding holding = Holding::Held;
};

/// A path that the robot has and that waits to be begun. Anything else that moves the arm, and any stop, makes it void.
class PreparedPath {
public:
    PreparedPath() = default;  ///< Of nothing: cannot be begun.

private:
    friend class Motions;
    std::uint64_t epoch_ = 0;
    int waypoints_ = 0;
};

/// All arguments are checked before anything is sent; an error names the argument that was wrong.
/// Errors   of every command: NotInControl, UnsafeState, LinkLost; InvalidArgument (not a number, degrees or
///          millimetres by magnitude), LimitExceeded (out of a joint's range, above what the arm can, a tool
///          speed above the cap), NoSolution (poses out of reach), Stopped (a stop came in the same moment)
/// Threads  any. Blocks: never, except where a deadline is taken. The controller must outlive it and all
///          handles it gives.
class Motions {
public:
    explicit Motions(Controller& controller) : controller_(&controller) {}
    /// For what is prepared before it begins, or goes on from one motion to the next: begins nothing once there
    /// has been a stop since Controller::stops() was this (Stopped).
    Motions(Controller& controller, std::uint64_t stops) : controller_(&controller), stops_(stops) {}

    /// Linear in joint space. Ends at the target [rad]. Source: URScript movej
    Result<Motion> moveJ(const JointPositions& target, const MoveParameters& parameters = {});
    /// The same, to the joint positions nearest to the present ones that give this TCP pose [m, rad].
    Result<Motion> moveJToPose(const Pose& target, const MoveParameters& parameters = {});
    /// A straight line of the TCP to a pose in the base frame [m, rad], where it ends. Source: URScript movel
    Result<Motion> moveL(const Pose& target, const MoveParameters& parameters = {});
    /// The same, to the pose these joint positions give.
    Result<Motion> moveLToJoints(const JointPositions& target, const MoveParameters& parameters = {});
    /// Follows the whole path and ends at its last target. The control program is sent anew with the path in
    /// it, which takes a moment; the arm must not be moving.
    /// start    how long that may take; the path itself is waited for with the handle
    /// silence  as MoveParameters::silence
    /// Errors   also Timeout, Cancelled, ScriptError (with line and text)
    Result<Motion> movePath(const MotionPath& path, const Deadline& start, Holding holding = Holding::Free,
                            std::chrono::milliseconds silence = kHoldTime);
    /// The first half of movePath(): sends it and moves nothing. For a thread that can wait, where another one, which
    /// cannot, holds.
    Result<PreparedPath> preparePath(const MotionPath& path, const Deadline& start);
    /// The second half. Blocks: never
    /// Errors   also Stopped when anything has moved the arm, or a stop came, since it was prepared
    Result<Motion> startPath(const PreparedPath& path, Holding holding = Holding::Free,
                             std::chrono::milliseconds silence = kHoldTime);

    /// Moves the tool until it touches something, then back to where the contact began, and ends there. Held:
    /// Motion::refresh() at least every 100 ms, or it ends and the arm brakes.
    /// twist    base frame [m/s, rad/s]
    /// start    how long setting up the contact detection may take
    /// Source   URScript tool_contact
    /// Errors   also VersionUnsupported (software before 5.4), Timeout, Cancelled
    Result<Motion> moveUntilContact(const Twist& twist, const Deadline& start,
                                    const ContactParameters& parameters = {});

    /// Moves at a velocity until it is refreshed with another one or ended. The target is slowed down to the
    /// limits, never refused for its size. Held: Jog::refresh() at least every 100 ms, or it ends and the arm
    /// brakes.
    /// Errors   also FieldUnknown (contactForce, on a robot that tells no force)
    Result<Jog> startJog(const JogTarget& target, Holding holding = Holding::Held);

    /// Streams; the first target is where the arm stands (servo) or zero (speed) until another one is sent.
    /// holding  Held: without a new target for 100 ms the stream ends and the arm brakes. Free: the last
    ///          target rules on until the stream is ended
    /// Source   URScript servoj, servoc, speedj, speedl
    Result<JointServo> startServoJ(const ServoParameters& parameters = {}, Holding holding = Holding::Held);
    /// As startServoJ, with TCP poses in the base frame.
    Result<PoseServo> startServoL(const ServoParameters& parameters = {}, Holding holding = Holding::Held);
    /// As startServoJ, with TCP poses that are gone to at a speed of their own. Source: URScript servoc
    Result<CircularServo> startServoC(const CircularServoParameters& parameters = {},
                                      Holding holding = Holding::Held);
    /// As startServoJ, with joint velocities.
    Result<JointSpeed> startSpeedJ(const SpeedParameters& parameters = {}, Holding holding = Holding::Held);
    /// As startServoJ, with twists of the TCP.
    Result<ToolSpeed> startSpeedL(const SpeedParameters& parameters = {}, Holding holding = Holding::Held);

    /// As startServoJ, with joint torques. Until the first ones are sent the controller holds the arm in its
    /// place, from then on only the torques do. Gravity is not part of them: the controller carries the arm and
    /// the payload it was told of. The cap on speed ends the stream, and its end is damped: see setpoints.h.
    /// Source   URScript direct_torque
    /// Errors   also VersionUnsupported (software before 5.25.1, PolyScope X before 10.12.1, CB3)
    Result<JointTorque> startTorque(const TorqueParameters& parameters = {}, Holding holding = Holding::Held);

    /// Ends whatever is active; the handle completes when the arm stands. Works whether or not something
    /// moves. deceleration > 0: of the leading joint [rad/s2]. Source: URScript stopj
    Result<Motion> stopJ(double deceleration = 4.0, StopCause cause = StopCause::ApiCall);
    /// The same along the line of the tool. deceleration > 0 [m/s2]; rotationDeceleration [rad/s2], 0: the
    /// same number. Source: URScript stopl
    Result<Motion> stopL(double deceleration = 2.0, double rotationDeceleration = 0,
                         StopCause cause = StopCause::ApiCall);

private:
    std::uint64_t stops() const;

    Controller* controller_;
    std::optional<std::uint64_t> stops_;
};

}  // namespace tiller::control
