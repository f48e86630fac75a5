// SPDX-License-Identifier: MIT
#pragma once

// A stream of targets, one a control cycle: servo (positions), speed (velocities) and torque. The newest target
// wins; the arm goes on with the last one until it is replaced, and brakes when the stream ends.
//
// Torques accelerate: the same one, sent again and again, makes the arm faster and faster, and neither the speed
// slider nor the cap on the speed of TCP and elbow slows it down. So the control program watches the cap: where
// the arm is measured to be faster, the stream ends (StopCause::LimitReached; ControllerStatus::limiter says
// whether the TCP or the elbow was). It is then a little faster still for some milliseconds. How fast the
// joints may turn and where their ranges end only the controller watches, with a protective stop.
//
// However a stream of torques ends, the control program brakes in two steps. It goes on with torques against
// the motion, as large as the inertia asks for and the joints can give, so that the speeds of all joints fall
// with a time constant of 33 ms; the friction, not made up for any more, does the rest. When no joint is faster
// than 0.05 rad/s, or after 100 ms, it brakes in position control as from everything else (or as stopJ, stopL
// ask). Only where the program itself is ended or paused, by a stop of the safety system or a person, does the
// controller brake in its own way.

#include <array>

#include "robot/control/motion.h"
#include "robot/control/motion_types.h"
#include "robot/core/joints.h"
#include "robot/core/spatial.h"

namespace tiller::control {

struct ServoParameters {
    double duration = 0;     ///< time one target rules [s]; 0: the control period
    double lookahead = 0.1;  ///< 0.03 ... 0.2 [s]; larger is smoother and lags more
    double gain = 300;       ///< 100 ... 2000; larger is stiffer
    /// False: a target may be any distance away; what happens then is up to the robot, which follows as fast
    /// as it may or stops protectively.
    bool guarded = true;
};

struct CircularServoParameters {
    double speed = 0.25;        ///< of the tool [m/s]
    double acceleration = 1.2;  ///< [m/s2]
    double blend = 0;           ///< 0 ... 2 [m]
};

struct SpeedParameters {
    double acceleration = 0.5;        ///< joints [rad/s2], tool [m/s2]
    double rotationAcceleration = 0;  ///< tool [rad/s2]; 0: the same number as acceleration
    /// How long each set point is held before the next one is looked at [s]; 0: the control period. Source:
    /// URScript speedj, t
    double duration = 0;
    JogFrame frame = JogFrame::Base;  ///< tool: whose axes the twist is along
    Pose T_base_frame = {};           ///< only for JogFrame::Custom; its rotation counts
};

/// How much of the joints' friction the controller makes up for, 0 ... 1 each, base to wrist 3. Left out: as the
/// controller has it. Source: URScript direct_torque
struct TorqueParameters {
    std::array<double, 6> viscousScale{0.9, 0.9, 0.8, 0.9, 0.9, 0.9};  ///< in steps of a thousandth
    std::array<double, 6> coulombScale{0.8, 0.8, 0.7, 0.8, 0.8, 0.8};
};

/// Made by Motions::start...; ends like any motion, through motion().cancel(), Motions::stopJ/stopL or a new
/// motion. A stream that was ended can never move the arm again: it takes a new start.
/// Threads  any, also several at once
template <class Target, class Parameters>
class Setpoints {
public:
    Setpoints() = default;
    const Motion& motion() const { return motion_; }      ///< To wait for, or to cancel.
    bool isActive() const { return motion_.isActive(); }  ///< Whether send() can still move the arm.

    /// Errors   Stopped (the stream has ended), InvalidArgument (not a number, wrong unit by magnitude),
    ///          LimitExceeded (outside what the arm can, of torques too; a servo target too far from the one before, or at
    ///          first from the arm: see kJointLeeway). A target that is refused has not been sent; the stream
    ///          goes on
    /// Blocks   never. Real-time: yes, as long as there is no error to tell
    Result<void> send(const Target& target);
    /// The same with other parameters from here on.
    Result<void> send(const Target& target, const Parameters& parameters);

private:
    friend class Motions;
    Setpoints(const Motion& motion, const Parameters& parameters)
        : motion_(motion), parameters_(parameters) {}
    Motion motion_;
    Parameters parameters_;
};

using JointServo = Setpoints<JointPositions, ServoParameters>;   ///< [rad]
using PoseServo = Setpoints<Pose, ServoParameters>;              ///< base frame [m, rad]
using CircularServo = Setpoints<Pose, CircularServoParameters>;  ///< base frame [m, rad]
using JointSpeed = Setpoints<JointVelocities, SpeedParameters>;  ///< [rad/s]
using ToolSpeed = Setpoints<Twist, SpeedParameters>;             ///< [m/s, rad/s]
using JointTorque = Setpoints<JointTorques, TorqueParameters>;   ///< [Nm], without those against gravity

}  // namespace tiller::control
