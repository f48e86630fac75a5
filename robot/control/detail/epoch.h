// SPDX-License-Identifier: MIT
#pragma once

// The counter that makes a stop final. Every motion starts a new epoch, whose number is the ID of the motion.
// Every stop starts a new, empty epoch. A command is valid only in its own epoch. Epochs are never reused.

#include <array>
#include <atomic>
#include <cstdint>

#include "robot/control/control_status.h"

namespace tiller::control {

/// Threads  any. Blocks: never (compare-and-swap). Real-time: yes
class Epoch {
public:
    /// Starts the epoch of a new motion. The active motion ends with StopCause::Superseded.
    MotionId beginMotion(std::int64_t nowNs);
    /// Like beginMotion(), but returns kNoMotion if the epoch has changed since `epoch` was read.
    MotionId beginMotionAfter(std::uint64_t epoch, std::int64_t nowNs);
    /// Like beginMotion(), but returns kNoMotion if a stop has occurred since stops() returned this value.
    MotionId beginMotionUnlessStopped(std::uint64_t stops, std::int64_t nowNs);
    /// Starts an empty epoch, which ends the active motion.
    /// Returns  this epoch
    std::uint64_t stop(StopCause cause, std::int64_t nowNs);
    /// Continues with this epoch as an empty epoch, after another client. No effect if the epoch is in the
    /// past.
    void skipTo(std::uint64_t epoch);
    /// Like stop(), but only if this motion is active.
    bool end(MotionId motion, StopCause cause, std::int64_t nowNs);

    std::uint64_t current() const;
    /// Number of stops. Replacing a motion does not count. Compare two values to detect a stop during the
    /// preparation of a motion.
    std::uint64_t stops() const { return stops_.load(std::memory_order_acquire); }
    bool isActive(MotionId motion) const;
    MotionId activeMotion() const;  ///< kNoMotion in an empty epoch
    /// Newest epoch in which no motion is possible: the current epoch if it is empty, otherwise the previous
    /// one.
    std::uint64_t expiredUpTo() const;
    MotionState state(MotionId motion) const;
    /// Time at which the end of this motion was requested, on the caller's clock. Available only for recent
    /// motions.
    std::int64_t endedNs(MotionId motion) const;

private:
    // epoch * 2^16 + occupied * 2^8 + cause of the previous epoch's end
    using Word = std::uint64_t;
    static constexpr std::size_t kMemory = 256;

    static Word word(std::uint64_t epoch, bool occupied, StopCause cause);
    static std::uint64_t epochOf(Word w) { return w >> 16; }
    static bool isOccupied(Word w) { return ((w >> 8) & 1) != 0; }
    static StopCause causeOf(Word w) { return static_cast<StopCause>(w & 0xff); }
    bool replace(Word& seen, bool occupied, StopCause cause, std::int64_t nowNs);
    void remember(Word w);

    std::atomic<Word> word_{word(1, false, StopCause::None)};
    std::atomic<std::uint64_t> stops_{0};
    std::array<std::atomic<std::uint64_t>, kMemory> causes_{};  ///< epoch * 2^8 + cause of its end
    std::array<std::atomic<std::int64_t>, kMemory> began_{};
};

}  // namespace tiller::control
