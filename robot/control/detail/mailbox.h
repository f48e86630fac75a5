// SPDX-License-Identifier: MIT
#pragma once

// The single command slot between the callers and the control thread. The last command wins. A command that
// was stopped, replaced or not refreshed in time cannot become active again.

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

#include "robot/control/detail/epoch.h"
#include "robot/control/motion_types.h"
#include "robot/realtime/triple_buffer.h"
#include "robot/script/step_gate.h"

namespace tiller::control {

/// A Held motion ends if it is not refreshed for this time.
inline constexpr std::int64_t kHoldTimeNs = std::chrono::nanoseconds(kHoldTime).count();

struct MotionCommand {
    /// Script: a user program runs instead of the control program, so the packets contain only the heartbeat,
    /// the epoch and the step gate.
    enum class Kind : std::uint8_t { None, Jog, MoveJ, MoveL, Program, Script };
    MotionId id = kNoMotion;
    Kind kind = Kind::None;
    bool held = true;
    JogTarget jog;             ///< only for Jog
    std::int32_t program = 0;  ///< only for Program: a ScriptCommand
    /// Program: see control.script; Script: script::StepGate::value()
    std::int32_t choice = 0;
    /// MoveJ: q [rad]; MoveL: pose in the base frame [m, rad]; Program: see control.script; Script: value,
    /// variable and number of a script::VariableChange
    std::array<double, 6> target{};
    double speed = 0;
    double acceleration = 0;
    double rotationAcceleration = 0;
    std::array<double, 3> rotation{};  ///< only for Program: rotation vector of the custom frame
    Limiter limiter;                   ///< for a move: the limit that reduces the requested speed
    /// Maximum time without a heartbeat for a Free move or path; 0: default.
    std::chrono::milliseconds heartbeatTimeout{0};
};

/// Sets the step gate of a Script.
void setGateOf(MotionCommand& command, const script::StepGate& gate);

/// A stop with a given deceleration; valid for the epoch created by the stop.
struct Brake {
    enum class Along : std::uint8_t { AsFits, Joints, Line };
    std::uint64_t epoch = 0;
    Along along = Along::AsFits;
    double deceleration = 0;
    double rotationDeceleration = 0;
};

/// Callers: any thread. They wait for each other while copying a command, but never for the control thread;
/// stop() does not wait. Control thread: take() and active() are real-time and wait-free.
class Mailbox {
public:
    MotionId start(MotionCommand command, std::int64_t nowNs);
    /// Like start(), unless a stop or another motion has occurred since `epoch`.
    /// Returns  kNoMotion in this case
    MotionId startAfter(std::uint64_t epoch, MotionCommand command, std::int64_t nowNs);
    /// Like start(), unless a stop has occurred since Epoch::stops() returned `stops`. Other motions have no
    /// effect.
    /// Returns  kNoMotion in this case
    MotionId startUnlessStopped(std::uint64_t stops, MotionCommand command, std::int64_t nowNs);
    /// Returns  false if the motion has ended, e.g. because this call came too late
    bool refresh(MotionId motion, std::int64_t nowNs);
    bool refresh(MotionId motion, const JogTarget& target, std::int64_t nowNs);
    /// Refreshes a Program with new values. ID and holding do not change.
    bool change(MotionId motion, const MotionCommand& values, std::int64_t nowNs);
    /// Sets the step gate of a Script. Does not refresh the motion.
    /// Returns  false if the motion has ended
    bool setGate(MotionId motion, const script::StepGate& gate);
    enum class Change : std::uint8_t { Done, Ended, Refused };
    /// Like change(), if mayFollow(previous command, time since its last refresh [ns]) returns true.
    template <class MayFollow>
    Change changeIf(MotionId motion, const MotionCommand& values, std::int64_t nowNs, MayFollow mayFollow) {
        const std::lock_guard lock(callers_);
        const std::int64_t since = nowNs - refreshedNs_.load(std::memory_order_acquire);
        if (last_.id == motion && epoch_.isActive(motion) && !mayFollow(last_, since)) {
            return Change::Refused;
        }
        return replace(motion, values, nowNs) ? Change::Done : Change::Ended;
    }
    /// Returns  the epoch of the stop
    std::uint64_t stop(const Brake& brake, StopCause cause, std::int64_t nowNs);
    std::uint64_t stop(StopCause cause, std::int64_t nowNs) { return epoch_.stop(cause, nowNs); }
    bool end(MotionId motion, StopCause cause, std::int64_t nowNs) {
        return epoch_.end(motion, cause, nowNs);
    }
    const Epoch& epoch() const { return epoch_; }
    void skipTo(std::uint64_t epoch) { epoch_.skipTo(epoch); }
    /// True if the active motion has a target: a move or a path.
    bool hasAnEnd();

    /// Returns the command to execute, or null. Ends a command that was not refreshed in time.
    /// Threads  the control thread only; the reference is valid until the next call
    const MotionCommand* active(std::int64_t nowNs);
    /// The deceleration requested for this empty epoch. Threads: the control thread only
    Brake brake(std::uint64_t epoch);

private:
    bool isRefreshable(MotionId motion, std::int64_t nowNs);
    bool replace(MotionId motion, const MotionCommand& values, std::int64_t nowNs);
    void publish(const MotionCommand& command);

    Epoch epoch_;
    std::atomic<std::int64_t> refreshedNs_{0};

    std::mutex callers_;
    MotionCommand last_;  ///< last published command; protected by the mutex

    realtime::TripleBuffer<MotionCommand> newest_;  ///< published under the mutex
    realtime::TripleBuffer<Brake> brake_;           ///< published under the mutex
};

}  // namespace tiller::control
