// SPDX-License-Identifier: MIT
#pragma once

// The single command slot between the callers and the control thread. The last command wins; a command that was
// stopped, replaced or not refreshed in time cannot become active again.

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

#include "robot/control/detail/epoch.h"
#include "robot/control/motion_types.h"
#include "robot/realtime/triple_buffer.h"

namespace tiller::control {

/// A held motion ends without a refresh for this time.
inline constexpr std::int64_t kHoldTimeNs = std::chrono::nanoseconds(kHoldTime).count();

struct MotionCommand {
    enum class Kind : std::uint8_t { None, Jog, MoveJ, MoveL, Program };
    MotionId id = kNoMotion;
    Kind kind = Kind::None;
    bool held = true;
    JogTarget jog;             ///< only for Jog
    std::int32_t program = 0;  ///< only for Program: a ScriptCommand
    std::int32_t choice = 0;   ///< only for Program: see control.script
    /// MoveJ: q [rad]; MoveL: pose in the base frame [m, rad]; Program: see control.script
    std::array<double, 6> target{};
    double speed = 0;
    double acceleration = 0;
    double rotationAcceleration = 0;
    std::array<double, 3> rotation{};  ///< only for Program: rotation vector of a custom frame
    Limiter limiter;                   ///< of a move: the limit that reduces the requested speed
    /// Maximum time without a heartbeat, for a free move or path; 0: default.
    std::chrono::milliseconds silence{0};
};

/// A stop with a specific deceleration; valid for the epoch it created.
struct Brake {
    enum class Along : std::uint8_t { AsFits, Joints, Line };
    std::uint64_t epoch = 0;
    Along along = Along::AsFits;
    double deceleration = 0;
    double rotationDeceleration = 0;
};

/// Callers: any thread; they wait for each other while copying a command, never for the control thread, and stop()
/// does not wait. Control thread: take() and active() are real-time and wait-free.
class Mailbox {
public:
    MotionId start(MotionCommand command, std::int64_t nowNs);
    /// As start(), unless a stop or another motion occurred since `epoch` was current.
    /// Returns  kNoMotion in this case
    MotionId startAfter(std::uint64_t epoch, MotionCommand command, std::int64_t nowNs);
    /// As start(), unless a stop occurred since this number of stops: Epoch::stops(). Other motions do not matter.
    /// Returns  kNoMotion in this case
    MotionId startUnlessStopped(std::uint64_t stops, MotionCommand command, std::int64_t nowNs);
    /// Returns  false if the motion has ended, e.g. because this call came too late
    bool refresh(MotionId motion, std::int64_t nowNs);
    bool refresh(MotionId motion, const JogTarget& target, std::int64_t nowNs);
    /// Refreshes a Program with new values; its identity and holding are unchanged.
    bool change(MotionId motion, const MotionCommand& values, std::int64_t nowNs);
    enum class Change : std::uint8_t { Done, Ended, Refused };
    /// As change(), if mayFollow(the previous command, the time since its last refresh [ns]) returns true.
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
    /// Whether the active motion has a target: a move or a path.
    bool hasAnEnd();

    /// The command to execute, or null. Ends the command first if it was not refreshed in time.
    /// Threads  the control thread only; the reference is valid until the next call
    const MotionCommand* active(std::int64_t nowNs);
    /// The deceleration for this empty epoch. Threads: the control thread only
    Brake brake(std::uint64_t epoch);

private:
    bool isRefreshable(MotionId motion, std::int64_t nowNs);
    bool replace(MotionId motion, const MotionCommand& values, std::int64_t nowNs);
    void publish(const MotionCommand& command);

    Epoch epoch_;
    std::atomic<std::int64_t> refreshedNs_{0};

    std::mutex callers_;
    MotionCommand last_;  ///< protected by the mutex: the command published last

    realtime::TripleBuffer<MotionCommand> newest_;  ///< published under the mutex
    realtime::TripleBuffer<Brake> brake_;           ///< published under the mutex
};

}  // namespace tiller::control
