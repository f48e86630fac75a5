// SPDX-License-Identifier: MIT
#pragma once

// The one slot between those who want the arm to move and the control thread. The last command wins; one that
// has been stopped, replaced or not refreshed in time is gone for good.

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>

#include "robot/control/epoch.h"
#include "robot/control/motion_types.h"

namespace tiller::control {

/// Without a refresh for this long a held motion ends.
inline constexpr std::int64_t kHoldTimeNs = 100'000'000;

struct MotionCommand {
    enum class Kind : std::uint8_t { None, Jog, MoveJ, MoveL };
    MotionId id = kNoMotion;
    Kind kind = Kind::None;
    bool held = true;
    JogTarget jog;                   ///< Jog
    std::array<double, 6> target{};  ///< MoveJ: q [rad]; MoveL: pose in the base frame [m, rad]
    double speed = 0;
    double acceleration = 0;
};

/// Callers' side: threads any; they wait for each other's copy of a command, never for the control thread,
/// and stop() waits for nobody. Control thread's side: take() and active(), real-time, wait-free.
class Mailbox {
public:
    MotionId start(MotionCommand command, std::int64_t nowNs);
    /// Returns  false when the motion has ended, if only by this call coming too late
    bool refresh(MotionId motion, std::int64_t nowNs);
    bool refresh(MotionId motion, const JogTarget& target, std::int64_t nowNs);
    void stop(StopCause cause, std::int64_t nowNs) { epoch_.stop(cause, nowNs); }
    bool end(MotionId motion, StopCause cause, std::int64_t nowNs) {
        return epoch_.end(motion, cause, nowNs);
    }
    const Epoch& epoch() const { return epoch_; }

    /// The command to follow now, or null. Ends it first when its holder has fallen silent.
    /// Threads  the control thread only; the reference lives until the next call
    const MotionCommand* active(std::int64_t nowNs);

private:
    bool refreshLocked(MotionId motion, const JogTarget* target, std::int64_t nowNs);
    void publish(const MotionCommand& command);

    Epoch epoch_;
    std::atomic<std::int64_t> refreshedNs_{0};

    std::mutex callers_;
    MotionCommand last_;  ///< under the mutex: what was published last

    // Triple buffer: the callers fill `back_`, the control thread reads `front_`, and the third changes hands
    // through `middle_` (its index, and kFresh when the callers put it there).
    static constexpr unsigned kFresh = 4;
    std::array<MotionCommand, 3> slots_;
    std::atomic<unsigned> middle_{1};
    unsigned back_ = 0;   ///< under the mutex
    unsigned front_ = 2;  ///< control thread
};

}  // namespace tiller::control
