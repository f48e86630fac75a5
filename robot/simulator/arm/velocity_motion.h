// SPDX-License-Identifier: MIT
#pragma once

// Motions with a speed or a moving target instead of a path: speedj, speedl, servoj, servoc. Every step stays
// within the joint limits. Near the end of a joint range and near a singular position, the speed decreases
// with the distance, unless the motion leads away from this end or position.

#include <optional>

#include "robot/simulator/arm/arm_geometry.h"
#include "robot/simulator/arm/joint_limits.h"
#include "robot/simulator/arm/motion_types.h"
#include "robot/simulator/arm/tool_path.h"

namespace tiller::simulator::arm {

class VelocityMotion {
public:
    enum class Kind : std::uint8_t { SpeedJ, SpeedL, ServoJ, ServoC };

    VelocityMotion(const ArmGeometry& geometry, const JointLimits& limits, double period)
        : geometry_(geometry), limits_(limits), period_(period) {}

    // The commands below start from the velocity in `now`, or continue the current motion. `timeScale` is the
    // ratio of program time to real time.
    void speedJ(const JointTarget& now, double timeScale, const Vector6& qd, double a);
    void speedL(const JointTarget& now, double timeScale, const Vector6& twist, double a, double aRot);
    void servoJ(const JointTarget& now, double timeScale, const Vector6& q, double t, double lookahead,
                double gain);
    void servoC(const JointTarget& now, double timeScale, const ToolPoint& target, double a, double v,
                double r);

    /// Called if no further command has arrived. Speed commands decelerate to rest. Servo commands keep the
    /// last target position, without its velocity.
    void expire();
    /// Ends the motion. The next command starts from the current arm velocity.
    void drop() { running_ = false; }
    bool running() const { return running_; }
    /// Called after another motion has moved the arm to q.
    void relocated(const Vector6& q) { tool_ = ToolPoint(geometry_.tcpPose(q)); }
    /// Called if the TCP offset changes while the arm moves.
    void toolChanged(const JointTarget& now, double timeScale);
    /// True if the arm is at rest and no motion remains.
    bool settled(const JointTarget& state) const;
    Kind kind() const { return kind_; }

    /// Runs one step.
    /// Returns  the reason if the arm must stop; `joint` is then the joint that caused the stop
    std::optional<StopReason> step(double timeScale, JointTarget& state, int& joint);

    bool speedReached() const { return speedReached_; }
    bool targetReached() const { return targetReached_; }  ///< servoC: within the target radius
    /// Factor 0..1 by which limits reduced the speed of the last step.
    double slowedBy() const { return slowedBy_; }
    const ToolPoint& servoTarget() const { return servoCTarget_; }

private:
    void begin(Kind kind, const JointTarget& now, double timeScale);
    std::optional<StopReason> stepSpeedJ(double timeScale, JointTarget& state, int& joint);
    std::optional<StopReason> stepCartesian(double timeScale, JointTarget& state, int& joint);
    std::optional<StopReason> stepServoJ(double timeScale, JointTarget& state, int& joint);
    void pursue();

    const ArmGeometry& geometry_;
    const JointLimits& limits_;
    double period_;
    Kind kind_ = Kind::SpeedJ;
    bool running_ = false;
    bool speedReached_ = false;
    bool targetReached_ = false;
    double slowedBy_ = 1;

    Vector6 velocity_ = Vector6::Zero();        // joint rates or twist, in program time
    Vector6 targetVelocity_ = Vector6::Zero();  // value that velocity_ approaches
    double a_ = 1;
    double aRot_ = 1;
    ToolPoint tool_;  // commanded TCP pose, integrated to prevent drift of the rotation

    Vector6 servoQ_ = Vector6::Zero();
    Vector6 servoRate_ = Vector6::Zero();      // velocity of the target, calculated from successive commands
    Vector6 servoFiltered_ = Vector6::Zero();  // servoRate_, smoothed
    double servoPeriod_ = 0;
    double lookahead_ = 0.1;
    double gain_ = 300;

    ToolPoint servoCTarget_;
    double servoCSpeed_ = 0.25;
    double servoCRadius_ = 0;
    Posture posture_;
};

}  // namespace tiller::simulator::arm
