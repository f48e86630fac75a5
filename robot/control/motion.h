// SPDX-License-Identifier: MIT
#pragma once

// The handle of a motion: waits for the motion, cancels it and returns its progress. Used for moves, paths,
// setpoint streams, freedrive, script functions and stops.

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "robot/control/control_status.h"
#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/script/step_gate.h"

namespace tiller::control {

class Controller;

enum class MotionKind : std::uint8_t {
    None,
    JogCartesian,
    JogJoints,
    MoveJ,
    MoveL,
    Path,
    UntilContact,
    ServoJ,
    ServoL,
    ServoC,
    SpeedJ,
    SpeedL,
    Torque,
    Freedrive,
    Function,
    Script,  ///< a complete program of a user
    Stop,    ///< deceleration to standstill
};

struct MotionProgress {
    MotionPhase phase = MotionPhase::Ended;
    StopCause cause = StopCause::None;
    /// Completed fraction of the path, 0 ... 1, from the actual arm position. For motions without a known end
    /// (setpoints, freedrive, functions, until contact): 0 until completion.
    double fraction = 0;
    int waypoint = 0;          ///< paths: current target, 1 ... waypoints; 0 before the start
    int waypoints = 0;         ///< paths: number of targets
    bool executing = false;    ///< the robot has confirmed the execution of this motion
    double speedFraction = 1;  ///< current speed slider value, 0 ... 1
    double speedScaling = 1;   ///< speed reduction by the controller's own limits, 0 ... 1
};

/// Values computed at the start of a move. The speed slider and the controller's own limits may reduce the
/// speed further.
struct MotionPlan {
    std::chrono::duration<double> duration{
        0};            ///< from standstill to standstill, with the speed slider at 100 %
    double speed = 0;  ///< moveJ: of the joint with the largest rotation [rad/s]; moveL: of the TCP [m/s]
    Limiter limiter;   ///< limit that reduces the requested speed, and its factor
};

/// Copies refer to the same motion. The controller must outlive all copies.
/// Threads  any
class Motion {
public:
    Motion() = default;  ///< Creates an ended motion.

    MotionId id() const { return id_; }  ///< Never reused for another motion.
    MotionKind kind() const { return kind_; }
    /// True until the motion is complete or has been stopped.
    bool isActive() const { return state().phase == MotionPhase::Active; }
    MotionState state() const;        ///< Phase, and the cause after the end.
    MotionProgress progress() const;  ///< Progress according to the newest data.
    /// For moves such as moveJ and moveL; empty for paths and motions without a known end.
    const std::optional<MotionPlan>& plan() const { return plan_; }

    /// Keeps a Held motion active; not needed for a Free motion.
    /// Returns  false if the motion has ended, e.g. because this call came too late
    /// Blocks   never
    bool refresh() const;

    /// Sets which steps of a Script may begin, and changes a variable. Does not refresh a Held motion.
    /// Returns  false if the motion has ended or is not a Script
    /// Blocks   never
    bool setGate(const script::StepGate& gate) const;

    /// Waits for the end of the motion without refreshing it. The deadline is the only time limit. Take the
    /// speed slider into account: at 2 %, a move takes fifty times as long. Deadline::never() waits without a
    /// limit.
    /// Returns  ok if the motion reached its target (for a Stop: standstill)
    /// Errors   Timeout, Cancelled (the motion continues), Stopped (with the cause), NoSolution, UnsafeState,
    ///          LinkLost, NotInControl, ScriptError (for a path or function, with line and text)
    /// Blocks   until the end; polls every millisecond
    Result<void> wait(const Deadline& deadline) const;

    /// Ends the motion with a deceleration. Does not affect a motion that has replaced it.
    /// Returns  false if the motion has already ended
    bool cancel(StopCause cause = StopCause::ApiCall) const;

    /// Ends the motion and waits for standstill; returns at once if another motion has replaced it.
    /// Errors   Timeout, Cancelled (the arm is still decelerating); NotInControl if control was lost while
    ///          waiting (standstill is not confirmed; the robot still decelerates)
    /// Blocks   until the end; polls every millisecond
    Result<void> stop(const Deadline& deadline) const;

private:
    friend struct MotionAccess;
    Controller* controller_ = nullptr;
    MotionId id_ = kNoMotion;
    MotionKind kind_ = MotionKind::None;
    int waypoints_ = 0;
    std::array<double, 6> from_{};  ///< start and target: joint positions, or TCP poses for linear moves
    std::array<double, 6> to_{};
    std::optional<MotionPlan> plan_;
};

}  // namespace tiller::control
