// SPDX-License-Identifier: MIT
#pragma once

// The motion generator of the simulated controller: converts the moves of URScript to target joint positions, one
// set per control period. Commands never block; a script that waits for a command polls progress().
//
// Time. Moves, servo and speed commands run in program time: the speed slider and a pause stretch it, the path
// stays the same. stopJ and stopL run in real time, so that a stop takes the same time at every slider setting.
//
// Limits. For any sequence of commands, target speeds stay within the joint limits of the model, changes of the
// target velocity within kJointAccelerationLimit, positions within kJointPositionLimit. A motion that cannot
// continue within these limits becomes a joint-space stop and a ProtectiveStop.
//
// Threads  one, the caller's. No allocation after construction.

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

    /// Joint move; for a pose, the solution nearest to the current joints is used.
    /// Returns   a handle; Returned at the target, or where the blend zone begins if r > 0
    /// Errors    InvalidArgument, JointTargetOutOfRange, NoInverseKinematics, NotOperational, Busy
    /// Source    URScript movej
    MotionStart moveJ(const MoveTarget& target, const MoveParameters& parameters);

    /// Straight TCP line; the orientation changes in proportion. A target out of reach is a ProtectiveStop,
    /// not an error.
    /// Source    URScript movel
    MotionStart moveL(const MoveTarget& target, const MoveParameters& parameters);

    /// Straight lines at constant tool speed, with corners rounded by circles (t is not used).
    /// Source    URScript movep
    MotionStart moveP(const MoveTarget& target, const MoveParameters& parameters);

    /// Circular arc from the current pose through `via` (only its position is used) to `target`.
    /// Source    URScript movec
    MotionStart moveC(const MoveTarget& via, const MoveTarget& target, const MoveParameters& parameters,
                      ArcOrientation orientation = ArcOrientation::Interpolated);

    /// Follows q for t [s] of program time; keeps following the last q until another command is given.
    /// lookaheadTime 0.03..0.2 [s], gain 100..2000.
    /// Source    URScript servoj
    MotionStart servoJ(const JointPositions& q, double t, double lookaheadTime = 0.1, double gain = 300);

    /// Follows a pose at tool speed v; Returned within r of it.
    /// Source    URScript servoc
    MotionStart servoC(const Pose& target, double a, double v, double r);

    /// Joint speeds, reached with acceleration a [rad/s2] of the leading axis. Returned after t [s] of
    /// program time or, without t, when the speed is reached, in both cases after one period at the earliest.
    /// The speed is then kept for kSpeedHold; without a further command the arm then decelerates with a.
    /// Source    URScript speedj
    MotionStart speedJ(const JointVelocities& qd, double a, std::optional<double> t = std::nullopt);

    /// TCP velocity in base axes, rotation about the TCP; a [m/s2], aRot [rad/s2] (a if absent).
    /// Source    URScript speedl
    MotionStart speedL(const Twist& twist, double a, std::optional<double> t = std::nullopt,
                       std::optional<double> aRot = std::nullopt);

    /// Decelerates to standstill, all joints together; a [rad/s2] of the leading axis, real time.
    /// Source    URScript stopj
    MotionStart stopJ(double a);

    /// Decelerates along the current tool direction; a [m/s2], aRot [rad/s2] (a if absent), real time.
    /// Source    URScript stopl
    MotionStart stopL(double a, std::optional<double> aRot = std::nullopt);

    /// Joint torques without gravity for one control period; returns to position control when not repeated.
    /// Source    URScript direct_torque
    MotionStart directTorque(const JointTorques& torques, const Vector6& viscousScale,
                             const Vector6& coulombScale);

    MotionProgress progress(MotionId id) const;

    /// The thread that commanded the motion was killed. The motion continues for kSpeedHold, so that a stopj or a
    /// move can take over, then decelerates.
    void abandon();

    /// get_target_waypoint(): target of the active move, otherwise the target TCP pose.
    Pose targetWaypoint() const;

    /// True while a motion command (stops included) drives the arm.
    bool isActive() const;

    static constexpr double kSpeedHold = 0.02;  ///< [s]

private:
    MotionGenerator& generator_;
};

}  // namespace tiller::simulator::arm
