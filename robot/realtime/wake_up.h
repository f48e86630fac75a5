// SPDX-License-Identifier: MIT
#pragma once

// Lets threads wait for events of a thread that must not block: waking takes no lock, and needs a system call only
// if a thread is actually waiting.

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
        for (Bed& bed : beds_) {
            if (bed.asleep.exchange(false, std::memory_order_acq_rel)) {
                bed.bell.release();
            }
        }
    }

    /// Waits for the next wake() or the end of the time, unless `happened` returns true.
    template <class Happened>
    void wait(std::chrono::milliseconds atMost, Happened happened) {
        Bed* bed = freeBed();
        if (bed == nullptr) {  // All semaphores are in use: poll every millisecond.
            std::this_thread::sleep_for(std::min(atMost, std::chrono::milliseconds(1)));
            return;
        }
        bed->asleep.store(true, std::memory_order_release);
        sleepers_.fetch_add(1, std::memory_order_acq_rel);
        const bool woken = !happened() && bed->bell.try_acquire_for(atMost);
        if (!woken && !bed->asleep.exchange(false, std::memory_order_acq_rel)) {
            bed->bell.acquire();  // wake() was called meanwhile
        }
        sleepers_.fetch_sub(1, std::memory_order_relaxed);
        bed->taken.store(false, std::memory_order_release);
    }

private:
    struct Bed {
        std::atomic<bool> taken{false};
        std::atomic<bool> asleep{false};
        std::binary_semaphore bell{0};
    };

    Bed* freeBed() {
        for (Bed& bed : beds_) {
            if (!bed.taken.exchange(true, std::memory_order_acq_rel)) {
                return &bed;
            }
        }
        return nullptr;
    }

    std::array<Bed, 16> beds_;
    std::atomic<int> sleepers_{0};
};

}  // namespace tiller::realtime
