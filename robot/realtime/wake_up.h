// SPDX-License-Identifier: MIT
#pragma once

// Lets threads wait for events of a thread that must not block. wake() takes no lock and makes a system call
// only if a thread is waiting.

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <semaphore>
#include <thread>

namespace tiller::realtime {

/// Threads  wake(): one; wait(): any. Real-time: wake() yes
class WakeUp {
public:
    void wake() {  ///< Real-time: yes
        // A read-modify-write orders this call relative to the registration of a waiter: either the waiter sees the
        // event, or this call sees the waiter.
        if (sleepers_.fetch_add(0, std::memory_order_acq_rel) == 0) {
            return;
        }
        for (Waiter& waiter : waiters_) {
            if (waiter.asleep.exchange(false, std::memory_order_acq_rel)) {
                waiter.semaphore.release();
            }
        }
    }

    /// Waits for the next wake() or until the time has elapsed, unless `happened` returns true.
    template <class Happened>
    void wait(std::chrono::milliseconds atMost, Happened happened) {
        Waiter* waiter = freeWaiter();
        if (waiter == nullptr) {  // All semaphores are in use: poll every millisecond.
            std::this_thread::sleep_for(std::min(atMost, std::chrono::milliseconds(1)));
            return;
        }
        waiter->asleep.store(true, std::memory_order_release);
        sleepers_.fetch_add(1, std::memory_order_acq_rel);
        const bool woken = !happened() && waiter->semaphore.try_acquire_for(atMost);
        if (!woken && !waiter->asleep.exchange(false, std::memory_order_acq_rel)) {
            waiter->semaphore.acquire();  // wake() was called in the meantime
        }
        sleepers_.fetch_sub(1, std::memory_order_relaxed);
        waiter->taken.store(false, std::memory_order_release);
    }

private:
    struct Waiter {
        std::atomic<bool> taken{false};
        std::atomic<bool> asleep{false};
        std::binary_semaphore semaphore{0};
    };

    Waiter* freeWaiter() {
        for (Waiter& waiter : waiters_) {
            if (!waiter.taken.exchange(true, std::memory_order_acq_rel)) {
                return &waiter;
            }
        }
        return nullptr;
    }

    std::array<Waiter, 16> waiters_;
    std::atomic<int> sleepers_{0};
};

}  // namespace tiller::realtime
