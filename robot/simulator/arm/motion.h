// SPDX-License-Identifier: MIT
#pragma once

// The motion generator of the simulated controller: converts the moves of URScript to target joint positions,
// one set per control period. Commands never block. A script that waits for a command polls progress().
//
// Time. Moves, servo and speed commands run in program time. The speed slider and a pause slow down program
// time without changing the path. stopJ and stopL run in real time, so that a stop takes the same time at
// every slider setting.
//
// Limits. For any sequence of commands, the target speeds stay within the joint limits of the model, target
// accelerations within kJointAccelerationLimit, and positions within kJointPositionLimit. If a motion cannot
// continue within these limits, a joint-space stop replaces it, and a ProtectiveStop is raised.
//
// Threads  the caller's thread only. No allocation after construction.

#include <memory>
#include <optional>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/simulator/arm/motion_types.h"

namespace tiller::simulator::arm {

class MotionGenerator;

class Motion {
public:
    explicit Motion(MotionGenerator& generator) : generator_(generator) {}

    /// Joint move. For a pose, the inverse kinematics solution nearest to the current joint positions is
    /// used.
    /// Returns   a handle; the progress becomes Returned at the target or, if r > 0, at the beginning of the
    ///           blend zone
    /// Errors    InvalidArgument, JointTargetOutOfRange, NoInverseKinematics, NotOperational, Busy
    /// Source    URScript movej
    MotionStart moveJ(const MoveTarget& target, const MoveParameters& parameters);

    /// Straight TCP line with linearly interpolated orientation. An unreachable target causes a
    /// ProtectiveStop instead of an error.
    /// Source    URScript movel
    MotionStart moveL(const MoveTarget& target, const MoveParameters& parameters);

    /// Straight lines at constant tool speed, with corners rounded by circles (t is not used).
    /// Source    URScript movep
    MotionStart moveP(const MoveTarget& target, const MoveParameters& parameters);

    /// Circular arc from the current pose through `via` (only its position is used) to `target`.
    /// Source    URScript movec
    MotionStart moveC(const MoveTarget& via, const MoveTarget& target, const MoveParameters& parameters,
                      ArcOrientation orientation = ArcOrientation::Interpolated);

    /// Follows q for t [s] of program time. The arm keeps following the last q until another command is
    /// given. lookaheadTime 0.03..0.2 [s], gain 100..2000.
    /// Source    URScript servoj
    MotionStart servoJ(const JointPositions& q, double t, double lookaheadTime = 0.1, double gain = 300);

    /// Follows a pose at tool speed v. The progress becomes Returned within r of the pose.
    /// Source    URScript servoc
    MotionStart servoC(const Pose& target, double a, double v, double r);

    /// Joint speeds, reached with acceleration a [rad/s2] of the leading axis. The progress becomes Returned
    /// after t [s] of program time or, without t, when the speed is reached, but not before one period has
    /// elapsed. The arm then keeps the speed for kSpeedHold. If no other command follows, it decelerates with
    /// a.
    /// Source    URScript speedj
    MotionStart speedJ(const JointVelocities& qd, double a, std::optional<double> t = std::nullopt);

    /// TCP velocity in base axes, rotation about the TCP. a [m/s2], aRot [rad/s2] (default: a).
    /// Source    URScript speedl
    MotionStart speedL(const Twist& twist, double a, std::optional<double> t = std::nullopt,
                       std::optional<double> aRot = std::nullopt);

    /// Decelerates all joints together to standstill; a [rad/s2] of the leading axis, real time.
    /// Source    URScript stopj
    MotionStart stopJ(double a);

    /// Decelerates along the current tool direction. a [m/s2], aRot [rad/s2] (default: a), real time.
    /// Source    URScript stopl
    MotionStart stopL(double a, std::optional<double> aRot = std::nullopt);

    /// Joint torques without gravity for one control period. If the command is not repeated, the arm returns
    /// to position control.
    /// Source    URScript direct_torque
    MotionStart directTorque(const JointTorques& torques, const Vector6& viscousScale,
                             const Vector6& coulombScale);

    MotionProgress progress(MotionId id) const;

    /// Called when the thread that commanded the motion has been killed. The motion continues for kSpeedHold,
    /// so that a stopj or a move can take over, and then decelerates.
    void abandon();

    /// get_target_waypoint(): the target of the active move, or the target TCP pose if no move is active.
    Pose targetWaypoint() const;

    /// True while a motion command (including stops) drives the arm.
    bool isActive() const;

    static constexpr double kSpeedHold = 0.02;  ///< [s]

private:
    MotionGenerator& generator_;
};

}  // namespace tiller::simulator::arm
