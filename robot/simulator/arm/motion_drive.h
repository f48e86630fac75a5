// SPDX-License-Identifier: MIT
#pragma once

// Moves the arm along a path, at a speed or with torques, one control period at a time. Maintains program
// time and applies the final joint limits. MotionGenerator checks and plans the commands.

#include <array>
#include <limits>
#include <optional>

#include "robot/simulator/arm/arm_geometry.h"
#include "robot/simulator/arm/arm_state.h"
#include "robot/simulator/arm/joint_limits.h"
#include "robot/simulator/arm/motion_types.h"
#include "robot/simulator/arm/path_motion.h"
#include "robot/simulator/arm/path_segment.h"
#include "robot/simulator/arm/velocity_motion.h"

namespace tiller::simulator::arm {

class TorqueMotion;

class MotionDrive {
public:
    MotionDrive(const ArmGeometry& geometry, double period, const JointPositions& start);

    MotionProgress progress(MotionId id) const;
    void abandon();
    Pose targetWaypoint() const;
    bool isActive() const { return mode_ != Mode::Rest; }
    bool followsPath() const { return mode_ == Mode::Path; }
    bool followsTorque() const { return mode_ == Mode::Torque; }
    /// Limits the TCP speed of the program [m/s]; infinity: no limit. The limit slows down the motion along
    /// its path; speedScaling() includes this reduction.
    void setToolSpeedLimit(double limit) { toolSpeedLimit_ = limit; }
    TimeScaleSource scaledBy() const { return scaledBy_; }

    // the arm
    void step();
    const JointTarget& target() const { return state_; }
    void setOperational(bool operational);
    void setSpeedFraction(double fraction) { slider_ = fraction; }
    void setReadings(const Readings& readings) { readings_ = readings; }
    const Readings& readings() const { return readings_; }
    double speedFraction() const { return slider_; }
    void hold() { held_ = true; }
    void resume() { held_ = false; }
    bool isHeld() const { return held_; }
    /// Speed scaling by limits, pause and resume. Does not include the slider.
    double speedScaling() const { return scaling_; }
    /// Discards all commands and stops in joint space.
    void abort(double deceleration);
    /// Places the arm in `state`, either at rest (`state.qd` zero) or with a velocity that is then reduced to
    /// zero.
    void relocate(const JointTarget& state);
    /// Sets the target after force mode or freedrive has moved the arm. Speed commands continue from this
    /// target.
    void rebase(const JointTarget& state);
    /// Sets the TCP. Speed commands use it at once as the centre of rotation. A tool path in progress is
    /// completed with the old TCP.
    void setTcp(const Pose& T_flange_tcp);
    void setTorqueMotion(TorqueMotion* torque) { torque_ = torque; }
    /// If set, as in freedrive, commands return without effect.
    void setIgnoringCommands(bool ignoring) { ignoring_ = ignoring; }

    void raise(StopReason reason, int joint);
    /// Like raise(), but called within a step. The arm is in `state`, and the first period of the stop is
    /// executed at once.
    void raiseFrom(const JointTarget& state, StopReason reason);
    const std::optional<ProtectiveStop>& protectiveStop() const { return protectiveStop_; }
    void clearProtectiveStop() { protectiveStop_.reset(); }
    std::optional<MotionWarning> takeWarning();
    const JointLimits& limits() const { return limits_; }

protected:
    enum class Mode : std::uint8_t { Rest, Path, Velocity, Torque };
    struct Record {
        MotionId id = 0;
        MotionProgress progress = MotionProgress::Superseded;
    };
    static constexpr std::size_t kRecords = 64;
    static constexpr int kMaxWarnings = 8;

    std::optional<MotionError> refusal() const;
    MotionStart begin();
    MotionStart ignored();
    void finish(MotionId id, MotionProgress progress);
    void supersede();

    void adoptTcp();
    /// pace  rate of the time base of the stop relative to real time
    bool jointRunOut(double deceleration, Segment& segment, double pace = 1) const;
    void startStop(double deceleration, MotionId id, bool scaled = false);
    /// Rate of the time base of a stop that begins in this period, relative to real time.
    double stopPace(bool scaled) const;
    /// Rate of time for speed and servo commands.
    double velocityScale() const { return readings_.speedCommandsScaled ? programScale_ : pauseScale_; }
    bool moving() const { return state_.qd.cwiseAbs().maxCoeff() > 1e-9; }

    void stepScale();
    void explainScaling(double toolFactor, bool byJoints);
    double toolSpeedFactor(const Vector6& qd) const;
    void stepPath();
    void stepStop();
    void stepVelocity();
    void stepTorque();
    std::optional<StopReason> chooseStep(double target, double& scale, PathCandidate& candidate, int& joint);
    void pathFailed(StopReason reason, int joint);
    void startVelocity(MotionId id, std::optional<double> t);

    ArmGeometry geometry_;  // separate copy with the TCP of the current motion
    std::optional<Pose> tcpToCome_;
    double period_;
    JointLimits limits_;
    PathPlanner planner_;
    PathMotion path_;
    VelocityMotion velocity_;
    TorqueMotion* torque_ = nullptr;
    Segment scratch_;
    Segment runOut_;
    Posture posture_;
    PathCandidate candidate_;

    Mode mode_ = Mode::Rest;
    JointTarget state_;
    bool operational_ = false;
    bool ignoring_ = false;

    Readings readings_;
    double slider_ = 1;
    bool held_ = false;
    double programScale_ = 1;  // slider and pause, ramped
    double pathScale_ = 1;     // requested scale, reduced to the maximum within the limits
    double pauseScale_ = 1;    // pause only, ramped
    double scaling_ = 1;
    TimeScaleSource scaledBy_ = TimeScaleSource::NotScaled;
    double programRate_ = 0;   // speed of the fastest joint, in program time
    double velocityPace_ = 1;  // rate of program time in the last speed or servo step
    double toolSpeedLimit_ = std::numeric_limits<double>::infinity();

    MotionId lastId_ = 0;
    MotionId activeId_ = 0;
    MotionId goalId_ = 0;  // ID of a move waiting to be blended in
    std::array<Record, kRecords> records_{};
    double blockingLeft_ = 0;
    bool blocksUntilSpeed_ = false;
    bool blocking_ = false;
    double sinceReturned_ = 0;
    double abandonedFor_ = -1;

    std::optional<ProtectiveStop> protectiveStop_;
    std::array<MotionWarning, kMaxWarnings> warnings_{};
    int warningCount_ = 0;
    // Program time by which the last timed speed or servo command overran. This time is subtracted from the
    // next command.
    double overrun_ = 0;
};

}  // namespace tiller::simulator::arm
