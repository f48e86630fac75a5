// SPDX-License-Identifier: MIT
#include "robot/control/detail/epoch.h"

namespace tiller::control {

Epoch::Word Epoch::word(std::uint64_t epoch, bool occupied, StopCause cause) {
    return (epoch << 16) | (static_cast<Word>(occupied) << 8) | static_cast<Word>(cause);
}

// Stores the cause of an earlier epoch before its word is overwritten. Several threads may store the same
// value concurrently. A late thread finds a newer entry and does not overwrite it.
void Epoch::remember(Word w) {
    const std::uint64_t ended = epochOf(w) - 1;
    const std::uint64_t entry = (ended << 8) | static_cast<std::uint64_t>(causeOf(w));
    auto& slot = causes_[ended % kMemory];
    std::uint64_t old = slot.load(std::memory_order_relaxed);
    while (old < entry && !slot.compare_exchange_weak(old, entry, std::memory_order_acq_rel)) {
    }
}

bool Epoch::replace(Word& seen, bool occupied, StopCause cause, std::int64_t nowNs) {
    remember(seen);
    const std::uint64_t next = epochOf(seen) + 1;
    // Store before the exchange, so that the time is visible with the epoch. A concurrent caller for the same
    // epoch writes nearly the same time.
    began_[next % kMemory].store(nowNs, std::memory_order_relaxed);
    return word_.compare_exchange_weak(seen, word(next, occupied, cause), std::memory_order_acq_rel,
                                       std::memory_order_acquire);
}

MotionId Epoch::beginMotion(std::int64_t nowNs) {
    Word seen = word_.load(std::memory_order_acquire);
    while (!replace(seen, true, StopCause::Superseded, nowNs)) {
    }
    return epochOf(seen) + 1;
}

MotionId Epoch::beginMotionAfter(std::uint64_t epoch, std::int64_t nowNs) {
    Word seen = word_.load(std::memory_order_acquire);
    while (epochOf(seen) == epoch) {
        if (replace(seen, true, StopCause::Superseded, nowNs)) {
            return epoch + 1;
        }
    }
    return kNoMotion;
}

// stop() increments the count before it exchanges the word. If the increment is not visible here, stop()
// either ends this motion or makes the exchange fail.
MotionId Epoch::beginMotionUnlessStopped(std::uint64_t stops, std::int64_t nowNs) {
    Word seen = word_.load(std::memory_order_acquire);
    while (this->stops() == stops) {
        const std::uint64_t next = epochOf(seen) + 1;
        if (replace(seen, true, StopCause::Superseded, nowNs)) {
            return next;
        }
    }
    return kNoMotion;
}

std::uint64_t Epoch::stop(StopCause cause, std::int64_t nowNs) {
    if (cause != StopCause::Superseded) {
        stops_.fetch_add(1, std::memory_order_acq_rel);
    }
    Word seen = word_.load(std::memory_order_acquire);
    while (!replace(seen, false, cause, nowNs)) {
    }
    return epochOf(seen) + 1;
}

void Epoch::skipTo(std::uint64_t epoch) {
    Word seen = word_.load(std::memory_order_acquire);
    while (epochOf(seen) < epoch) {
        remember(seen);
        if (word_.compare_exchange_weak(seen, word(epoch, false, StopCause::ControlLost),
                                        std::memory_order_acq_rel, std::memory_order_acquire)) {
            return;
        }
    }
}

bool Epoch::end(MotionId motion, StopCause cause, std::int64_t nowNs) {
    Word seen = word_.load(std::memory_order_acquire);
    while (epochOf(seen) == motion && isOccupied(seen)) {
        if (replace(seen, false, cause, nowNs)) {
            return true;
        }
    }
    return false;
}

std::uint64_t Epoch::current() const {
    return epochOf(word_.load(std::memory_order_acquire));
}

bool Epoch::isActive(MotionId motion) const {
    return motion != kNoMotion && activeMotion() == motion;
}

MotionId Epoch::activeMotion() const {
    const Word w = word_.load(std::memory_order_acquire);
    return isOccupied(w) ? epochOf(w) : kNoMotion;
}

std::uint64_t Epoch::expiredUpTo() const {
    const Word w = word_.load(std::memory_order_acquire);
    return isOccupied(w) ? epochOf(w) - 1 : epochOf(w);
}

MotionState Epoch::state(MotionId motion) const {
    const Word w = word_.load(std::memory_order_acquire);
    if (motion >= epochOf(w)) {
        const bool active = motion == epochOf(w) && isOccupied(w);
        return {active ? MotionPhase::Active : MotionPhase::Ended, StopCause::None};
    }
    if (motion + 1 == epochOf(w)) {
        return {MotionPhase::Ended, causeOf(w)};
    }
    const std::uint64_t entry = causes_[motion % kMemory].load(std::memory_order_acquire);
    const bool known = (entry >> 8) == motion;
    return {MotionPhase::Ended, known ? static_cast<StopCause>(entry & 0xff) : StopCause::None};
}

std::int64_t Epoch::endedNs(MotionId motion) const {
    return began_[(motion + 1) % kMemory].load(std::memory_order_relaxed);
}

}  // namespace tiller::control
