// SPDX-License-Identifier: MIT
#pragma once

// The number that makes a stop final. Every motion begins a new epoch and bears its number; every stop begins
// a new, empty one. A command counts only while the epoch it was given for is the present one, and epochs
// never come back.

#include <array>
#include <atomic>
#include <cstdint>

#include "robot/control/control_status.h"

namespace tiller::control {

/// Threads  any. Blocks: never (compare-and-swap). Real-time: yes
class Epoch {
public:
    /// Begins the epoch of a new motion; what was active ends with StopCause::Superseded.
    MotionId beginMotion(std::int64_t nowNs);
    /// The same, unless the epoch has moved on from this one; kNoMotion then.
    MotionId beginMotionAfter(std::uint64_t epoch, std::int64_t nowNs);
    /// The same, unless a stop came since stops() was this; kNoMotion then.
    MotionId beginMotionUnlessStopped(std::uint64_t stops, std::int64_t nowNs);
    /// Begins an empty epoch: ends whatever is active.
    /// Returns  that epoch
    std::uint64_t stop(StopCause cause, std::int64_t nowNs);
    /// Makes this the present epoch, empty, unless it is past already: another client was there before.
    void skipTo(std::uint64_t epoch);
    /// As stop(), but only if that motion is the active one.
    bool end(MotionId motion, StopCause cause, std::int64_t nowNs);

    std::uint64_t current() const;
    /// How many stops there were, those not counted that only make way for another motion. Who reads it
    /// before it prepares a motion sees whether one came meanwhile.
    std::uint64_t stops() const { return stops_.load(std::memory_order_acquire); }
    bool isActive(MotionId motion) const;
    MotionId activeMotion() const;  ///< kNoMotion in an empty epoch
    /// The newest epoch in which nothing may move any more: the present one when it is empty, else the one
    /// before.
    std::uint64_t deadUpTo() const;
    MotionState state(MotionId motion) const;
    /// When the end of this motion was asked for, by the clock of those who ask. Meaningful soon after the
    /// end.
    std::int64_t endedNs(MotionId motion) const;

private:
    // epoch * 2^16 + occupied * 2^8 + how the epoch before it ended
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
    std::array<std::atomic<std::uint64_t>, kMemory> causes_{};  ///< epoch * 2^8 + how it ended
    std::array<std::atomic<std::int64_t>, kMemory> began_{};
};

}  // namespace tiller::control
