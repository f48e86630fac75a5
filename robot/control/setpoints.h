// SPDX-License-Identifier: MIT
#pragma once

// A stream of targets, one per control cycle: servo (positions), speed (velocities) and torque. The newest
// target wins. The arm continues with the last target until the next one arrives, and stops at the end of the
// stream.
//
// A constant torque keeps accelerating the arm, and neither the speed slider nor the speed cap of TCP and
// elbow slows it down. Therefore, the control program monitors the cap. If the measured speed exceeds the
// cap, the stream ends (StopCause::LimitReached; ControllerStatus::limiter reports TCP or elbow). The speed
// may increase slightly for a few more milliseconds. Joint speeds and joint ranges are monitored only by the
// controller, which reacts with a protective stop.
//
// At the end of a torque stream, the control program decelerates in two steps. First, it applies torques
// against the motion, based on the inertia and within the joint limits. All joint speeds then decrease with a
// time constant of 33 ms, assisted by the uncompensated friction. When no joint is faster than 0.05 rad/s, or
// after 100 ms, the control program stops the arm in position control as after other motions (or as requested
// by stopJ, stopL). If the safety system or a person ends or pauses the program, the controller decelerates
// the arm.

#include <array>

#include "robot/control/motion.h"
#include "robot/control/motion_types.h"
#include "robot/core/joints.h"
#include "robot/core/spatial.h"

namespace tiller::control {

struct ServoParameters {
    double duration = 0;     ///< duration of one target [s]; 0: the control period
    double lookahead = 0.1;  ///< 0.03 ... 0.2 [s]; larger values are smoother and have more delay
    double gain = 300;       ///< 100 ... 2000; higher values are stiffer
    /// False: targets at any distance are accepted. The robot then follows at its maximum speed or triggers a
    /// protective stop.
    bool guarded = true;
};

struct CircularServoParameters {
    double speed = 0.25;        ///< tool speed [m/s]
    double acceleration = 1.2;  ///< [m/s2]
    double blend = 0;           ///< 0 ... 2 [m]
};

struct SpeedParameters {
    double acceleration = 0.5;        ///< joint [rad/s2] or tool acceleration [m/s2]
    double rotationAcceleration = 0;  ///< tool rotation [rad/s2]; 0: the same value as acceleration
    /// Duration of each setpoint [s]; 0: the control period. Source: URScript speedj, t
    double duration = 0;
    JogFrame frame = JogFrame::Base;  ///< tool: frame of the twist
    Pose T_base_frame = {};           ///< only for JogFrame::Custom; only the rotation is used
};

/// Friction compensation by the controller, 0 ... 1 for each joint from base to wrist 3. Empty: settings of
/// the controller. Source: URScript direct_torque
struct TorqueParameters {
    std::array<double, 6> viscousScale{0.9, 0.9, 0.8, 0.9, 0.9, 0.9};  ///< resolution 0.001
    std::array<double, 6> coulombScale{0.8, 0.8, 0.7, 0.8, 0.8, 0.8};
};

/// Created by Motions::start... and ended like any motion: with motion().cancel(), Motions::stopJ/stopL or a
/// new motion. An ended stream cannot move the arm again; start a new stream.
/// Threads  any, several at once
template <class Target, class Parameters>
class Setpoints {
public:
    Setpoints() = default;
    const Motion& motion() const { return motion_; }      ///< Handle to wait for the stream or to cancel it.
    bool isActive() const { return motion_.isActive(); }  ///< True if send() can still move the arm.

    /// Errors   Stopped (the stream has ended), InvalidArgument (NaN, or a value that suggests a wrong unit),
    ///          LimitExceeded (outside the limits of the arm, including torques; a servo target too far from
    ///          the previous target, or the first target too far from the arm: see kJointLeeway). A refused
    ///          target is not sent; the stream continues
    /// Blocks   never. Real-time: yes, unless an error is returned
    Result<void> send(const Target& target);
    /// Sends a target with new parameters, which stay active.
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
using JointTorque = Setpoints<JointTorques, TorqueParameters>;   ///< [Nm], without gravity compensation

}  // namespace tiller::control
