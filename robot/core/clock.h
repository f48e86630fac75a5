// SPDX-License-Identifier: MIT
#pragma once

// Where time comes from. The product runs on the steady clock; tests put a virtual one in its place, so that
// nothing they check depends on how fast the machine is.

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
    /// False where time stands still until it is told to go on: nothing may wait for it then.
    virtual bool runsByItself() const = 0;
    /// Returns at this moment and no earlier, to within microseconds if the machine is there: the last
    /// `awakeNs` are spun away. At once where time does not run by itself.
    virtual void waitUntil(std::int64_t ns, std::int64_t awakeNs) const = 0;
};

class SteadyClock final : public Clock {
public:
    std::int64_t nowNs() const override {  ///< [ns]
        return std::chrono::duration_cast<std::chrono::nanoseconds>(
                   std::chrono::steady_clock::now().time_since_epoch())
            .count();
    }
    bool runsByItself() const override { return true; }                    ///< Real time.
    void waitUntil(std::int64_t ns, std::int64_t awakeNs) const override;  ///< Sleeps, then spins.
    /// Sleeps until this moment at least, without spinning.
    static void sleepUntil(std::int64_t ns);
    /// For owners that were given no clock: it has no state, so one serves all.
    static const SteadyClock& shared() {
        static const SteadyClock clock;
        return clock;
    }
};

/// Stands still until told to go on.
class VirtualClock final : public Clock {
public:
    explicit VirtualClock(std::int64_t startNs = 1'000'000'000) : now_(startNs) {}
    std::int64_t nowNs() const override { return now_.load(std::memory_order_acquire); }  ///< [ns]
    bool runsByItself() const override { return false; }  ///< Only advanceNs() moves it.
    void waitUntil(std::int64_t /*ns*/, std::int64_t /*awakeNs*/) const override {}     ///< Returns at once.
    void advanceNs(std::int64_t ns) { now_.fetch_add(ns, std::memory_order_acq_rel); }  ///< [ns], any thread

private:
    std::atomic<std::int64_t> now_;
};

inline constexpr std::int64_t kNsPerMs = 1'000'000;
inline constexpr std::int64_t kNsPerSecond = 1'000'000'000;
/// How late a sleeping thread wakes up at most, mostly.
inline constexpr std::int64_t kWakeUpNs = 100'000;

}  // namespace tiller
