// SPDX-License-Identifier: MIT
#pragma once

// Interface of a time source. The product uses the steady clock. Tests use a virtual clock, so that their
// results do not depend on the speed of the machine.

#include <atomic>
#include <chrono>
#include <cstdint>

namespace tiller {

/// Monotonic time [ns] from an arbitrary origin.
/// Threads  any. Real-time: yes
class Clock {
public:
    virtual ~Clock() = default;
    virtual std::int64_t nowNs() const = 0;  ///< [ns]
    /// False for a clock that is advanced only manually, for which a wait would never end.
    virtual bool runsByItself() const = 0;
    /// Waits until the time `ns`. The last `awakeNs` are a busy wait, for an accuracy of microseconds if the
    /// CPU is available. Returns at once if the clock does not run automatically.
    virtual void waitUntil(std::int64_t ns, std::int64_t awakeNs) const = 0;
};

class SteadyClock final : public Clock {
public:
    std::int64_t nowNs() const override {  ///< [ns]
        return std::chrono::duration_cast<std::chrono::nanoseconds>(
                   std::chrono::steady_clock::now().time_since_epoch())
            .count();
    }
    bool runsByItself() const override { return true; }
    void waitUntil(std::int64_t ns, std::int64_t awakeNs) const override;  ///< Sleeps, then busy-waits.
    /// Sleeps until `ns` or later, without a busy wait.
    static void sleepUntil(std::int64_t ns);
    /// The default clock. Stateless and shared by all users.
    static const SteadyClock& shared() {
        static const SteadyClock clock;
        return clock;
    }
};

/// A clock that advances only with advanceNs().
class VirtualClock final : public Clock {
public:
    explicit VirtualClock(std::int64_t startNs = 1'000'000'000) : now_(startNs) {}
    std::int64_t nowNs() const override { return now_.load(std::memory_order_acquire); }  ///< [ns]
    bool runsByItself() const override { return false; }
    void waitUntil(std::int64_t /*ns*/, std::int64_t /*awakeNs*/) const override {}  ///< Returns immediately.
    /// Advances the time [ns]. Threads: any
    void advanceNs(std::int64_t ns) { now_.fetch_add(ns, std::memory_order_acq_rel); }

private:
    std::atomic<std::int64_t> now_;
};

inline constexpr std::int64_t kNsPerMs = 1'000'000;
inline constexpr std::int64_t kNsPerSecond = 1'000'000'000;
/// Typical maximum wake-up delay of a sleeping thread [ns].
inline constexpr std::int64_t kWakeUpNs = 100'000;

}  // namespace tiller
