// SPDX-License-Identifier: MIT
#pragma once

// The one slot between those who want the arm to move and the control thread. The last command wins; one that
// has been stopped, replaced or not refreshed in time is gone for good.

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

#include "robot/control/detail/epoch.h"
#include "robot/control/motion_types.h"
#include "robot/realtime/triple_buffer.h"

namespace tiller::control {

/// Without a refresh for this long a held motion ends.
inline constexpr std::int64_t kHoldTimeNs = std::chrono::nanoseconds(kHoldTime).count();

struct MotionCommand {
    enum class Kind : std::uint8_t { None, Jog, MoveJ, MoveL, Program };
    MotionId id = kNoMotion;
    Kind kind = Kind::None;
    bool held = true;
    JogTarget jog;             ///< Jog
    std::int32_t program = 0;  ///< Program: what control.script shall do, a ScriptCommand
    std::int32_t choice = 0;   ///< Program: as control.script says
    /// MoveJ: q [rad]; MoveL: pose in the base frame [m, rad]; Program: as control.script says
    std::array<double, 6> target{};
    double speed = 0;
    double acceleration = 0;
    double rotationAcceleration = 0;
    std::array<double, 3> rotation{};  ///< Program: rotation vector of a custom frame
    Limiter limiter;                   ///< of a move: what keeps it below the speed asked for
    /// Of a free move or path: how long it lasts without a heartbeat; 0: as everything else.
    std::chrono::milliseconds silence{0};
};

/// A stop that chooses its deceleration; it counts for the epoch it made.
struct Brake {
    enum class Along : std::uint8_t { AsFits, Joints, Line };
    std::uint64_t epoch = 0;
    Along along = Along::AsFits;
    double deceleration = 0;
    double rotationDeceleration = 0;
};

/// Callers' side: threads any; they wait for each other's copy of a command, never for the control thread,
/// and stop() waits for nobody. Control thread's side: take() and active(), real-time, wait-free.
class Mailbox {
public:
    MotionId start(MotionCommand command, std::int64_t nowNs);
    /// The same, unless a stop or another motion came since `epoch` was the current one.
    /// Returns  kNoMotion then
    MotionId startAfter(std::uint64_t epoch, MotionCommand command, std::int64_t nowNs);
    /// The same, unless a stop came since there were so many: Epoch::stops(). Other motions do not matter.
    /// Returns  kNoMotion then
    MotionId startUnlessStopped(std::uint64_t stops, MotionCommand command, std::int64_t nowNs);
    /// Returns  false when the motion has ended, if only by this call coming too late
    bool refresh(MotionId motion, std::int64_t nowNs);
    bool refresh(MotionId motion, const JogTarget& target, std::int64_t nowNs);
    /// Refreshes a Program with other values; its identity and holding stay.
    bool change(MotionId motion, const MotionCommand& values, std::int64_t nowNs);
    enum class Change : std::uint8_t { Done, Ended, Refused };
    /// The same, if mayFollow(the command before, the time since its last refresh [ns]) says so.
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
    /// Whether what is active comes to an end by itself: a move, a path.
    bool hasAnEnd();

    /// The command to follow now, or null. Ends it first when its holder has fallen silent.
    /// Threads  the control thread only; the reference lives until the next call
    const MotionCommand* active(std::int64_t nowNs);
    /// How to brake in this empty epoch. Threads: the control thread only
    Brake brake(std::uint64_t epoch);

private:
    bool isRefreshable(MotionId motion, std::int64_t nowNs);
    bool replace(MotionId motion, const MotionCommand& values, std::int64_t nowNs);
    void publish(const MotionCommand& command);

    Epoch epoch_;
    std::atomic<std::int64_t> refreshedNs_{0};

    std::mutex callers_;
    MotionCommand last_;  ///< under the mutex: what was published last

    realtime::TripleBuffer<MotionCommand> newest_;  ///< published under the mutex
    realtime::TripleBuffer<Brake> brake_;           ///< published under the mutex
};

}  // namespace tiller::control
