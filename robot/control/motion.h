// SPDX-License-Identifier: MIT
#pragma once

// The handle of anything that moves the arm: wait for it, cancel it, see how far it is. One kind of handle
// for moves, paths, setpoints, freedrive, script functions and stops.

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "robot/control/control_status.h"
#include "robot/core/deadline.h"
#include "robot/core/result.h"

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
    Stop,  ///< braking to standstill
};

struct MotionProgress {
    MotionPhase phase = MotionPhase::Ended;
    StopCause cause = StopCause::None;
    /// How much of the way is done, 0 ... 1, measured on the arm's actual place. Motions without a known end
    /// (setpoints, freedrive, functions, until contact) stay at 0 until they are completed.
    double fraction = 0;
    int waypoint = 0;          ///< paths: the one headed for, 1 ... waypoints; 0 before the first
    int waypoints = 0;         ///< paths: how many there are
    bool executing = false;    ///< the robot confirmed that it executes this motion
    double speedFraction = 1;  ///< the speed slider now, 0 ... 1: why a move may take its time
    double speedScaling = 1;   ///< what the controller's own limits leave of it, 0 ... 1
};

/// What was decided when a move began. The speed slider and the controller's own limits may slow it down
/// further.
struct MotionPlan {
    std::chrono::duration<double> duration{0};  ///< from standstill to standstill, at a slider of 100 %
    double speed = 0;  ///< moveJ: of the leading joint [rad/s]; moveL: of the TCP [m/s]
    Limiter limiter;   ///< what keeps it below the speed asked for, and how much
};

/// Copies refer to the same motion. The controller must outlive them.
/// Threads  any
class Motion {
public:
    Motion() = default;  ///< of nothing: ended

    MotionId id() const { return id_; }        ///< Never given to another motion.
    MotionKind kind() const { return kind_; }  ///< What began it.
    /// Neither at its end nor stopped.
    bool isActive() const { return state().phase == MotionPhase::Active; }
    MotionState state() const;        ///< Phase, and the cause once it has ended.
    MotionProgress progress() const;  ///< How far along its way, by the newest data.
    /// Of moveJ, moveL and the like; nothing for paths and what has no known end.
    const std::optional<MotionPlan>& plan() const { return plan_; }

    /// Keeps a held motion alive; a free one does not need it.
    /// Returns  false when it has ended, if only by this call coming too late
    /// Blocks   never
    bool refresh() const;

    /// Waits until the motion has come to its end; it does not refresh it. There is no time-out but the
    /// caller's: a move at a slider of 2 % takes fifty times as long, and is waited for with
    /// Deadline::never() as well as at 100 %.
    /// Returns  ok when it reached its target (a Stop: when the arm stands)
    /// Errors   Timeout, Cancelled (the motion goes on), Stopped (naming the cause), NoSolution, UnsafeState,
    ///          LinkLost, NotInControl, ScriptError (a path or function; with line and text)
    /// Blocks   until then; looks every millisecond
    Result<void> wait(const Deadline& deadline) const;

    /// Ends it, decelerating; another motion that took its place goes on.
    /// Returns  false when it had ended already
    bool cancel(StopCause cause = StopCause::ApiCall) const;

    /// Ends it and waits until the arm is at standstill; at once where another motion has taken its place.
    /// Errors   Timeout, Cancelled (the arm still brakes); NotInControl when control was lost meanwhile: standstill is not
    ///          confirmed, and the robot brakes by itself
    /// Blocks   until then; looks every millisecond
    Result<void> stop(const Deadline& deadline) const;

private:
    friend struct MotionAccess;
    Controller* controller_ = nullptr;
    MotionId id_ = kNoMotion;
    MotionKind kind_ = MotionKind::None;
    int waypoints_ = 0;
    std::array<double, 6> from_{};  ///< where it began and shall end: q, or TCP pose for linear moves
    std::array<double, 6> to_{};
    std::optional<MotionPlan> plan_;
};

}  // namespace tiller::control
