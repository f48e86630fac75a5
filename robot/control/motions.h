// SPDX-License-Identifier: MIT
#pragma once

// Everything that moves the arm for a program: moves, paths, setpoints, and stops that choose their own
// deceleration. Each command ends what was active before it, setpoints too: no extra call in between.

#include "robot/control/controller.h"
#include "robot/control/motion.h"
#include "robot/control/motion_path.h"
#include "robot/control/setpoints.h"

namespace tiller::control {

/// Which contact a move looks for.
enum class Sought : std::uint8_t {
    NewContact,  ///< what touches at the start has to let go first
    AnyContact,
};

/// All arguments are checked before anything is sent; an error names the argument that was wrong.
/// Errors   of every command: NotInControl, UnsafeState, LinkLost; InvalidArgument (not a number, degrees or
///          millimetres by magnitude), LimitExceeded, NoSolution (poses)
/// Threads  any. Blocks: never, except where a deadline is taken. The controller must outlive it.
class Motions {
public:
    explicit Motions(Controller& controller) : controller_(&controller) {}

    /// Linear in joint space. Source: URScript movej
    Result<Motion> moveJ(const JointPositions& target, const MoveParameters& parameters);
    /// The same, to the joint positions nearest to the present ones that give this TCP pose.
    Result<Motion> moveJ(const Pose& target, const MoveParameters& parameters);
    /// A straight line of the TCP to a pose in the base frame. Source: URScript movel
    Result<Motion> moveL(const Pose& target, const MoveParameters& parameters);
    /// The same, to the pose these joint positions give.
    Result<Motion> moveL(const JointPositions& target, const MoveParameters& parameters);
    /// Follows the whole path. The control program is sent anew with the path in it, which takes a moment;
    /// the arm must not be moving.
    /// start    how long that may take; the path itself is waited for with the handle
    /// Errors   also Timeout, Cancelled, ScriptError (with line and text)
    Result<Motion> movePath(const MotionPath& path, const Deadline& start, Holding holding = Holding::Free);

    /// Moves the tool until it touches something, then back to where the contact began.
    /// twist        base frame [m/s, rad/s]
    /// direction    from which contact is looked for, base frame; zeros: any
    /// acceleration [m/s2]
    /// sought       whether a contact that is there at the start counts: then the arm does not move
    /// Source       URScript tool_contact
    /// Errors       also VersionUnsupported (software before 5.4), Timeout, Cancelled
    Result<Motion> moveUntilContact(const Twist& twist, const Twist& direction, double acceleration,
                                    const Deadline& start, Sought sought = Sought::NewContact);

    /// Streams; the first target is where the arm stands (servo) or zero (speed) until another one is sent.
    /// holding  Held: without a new target for 100 ms the stream ends and the arm brakes
    /// Source   URScript servoj, servoc, speedj, speedl
    Result<JointServo> startServoJ(const ServoParameters& parameters = {}, Holding holding = Holding::Held);
    Result<PoseServo> startServoL(const ServoParameters& parameters = {}, Holding holding = Holding::Held);
    Result<CircularServo> startServoC(const CircularServoParameters& parameters = {},
                                      Holding holding = Holding::Held);
    Result<JointSpeed> startSpeedJ(const SpeedParameters& parameters = {}, Holding holding = Holding::Held);
    Result<ToolSpeed> startSpeedL(const SpeedParameters& parameters = {}, Holding holding = Holding::Held);

    /// Ends whatever is active; the handle completes when the arm stands. Works whether or not something
    /// moves. deceleration > 0: of the leading joint [rad/s2]. Source: URScript stopj
    Result<Motion> stopJ(double deceleration, StopCause cause = StopCause::ApiCall);
    /// deceleration > 0 [m/s2]; rotationDeceleration [rad/s2], 0: the same number. Source: URScript stopl
    Result<Motion> stopL(double deceleration, double rotationDeceleration = 0,
                         StopCause cause = StopCause::ApiCall);

private:
    Controller* controller_;
};

}  // namespace tiller::control
