// SPDX-License-Identifier: MIT
#pragma once

// Wakes those who wait for the next event of a thread that must not wait for them: it takes no lock, and
// makes a system call only for those who sleep just then.

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <semaphore>
#include <thread>

namespace tiller::realtime {

/// Threads  wake() one, wait() any. Real-time: wake() yes
class WakeUp {
public:
    void wake() {  ///< Real-time: yes
        // Writes as well as reads, so that one of the two comes first: this, and who lies down afterwards sees
        // what has happened; or that, and it is seen here.
        if (sleepers_.fetch_add(0, std::memory_order_acq_rel) == 0) {
            return;
        }
        for (Bed& bed : beds_) {
            if (bed.asleep.exchange(false, std::memory_order_acq_rel)) {
                bed.bell.release();
            }
        }
    }

    /// Sleeps until the next wake(), or the time is over, unless `happened` says that there is no need to.
    template <class Happened>
    void wait(std::chrono::milliseconds atMost, Happened happened) {
        Bed* bed = freeBed();
        if (bed == nullptr) {  // a crowd: those who find none look every millisecond
            std::this_thread::sleep_for(std::min(atMost, std::chrono::milliseconds(1)));
            return;
        }
        bed->asleep.store(true, std::memory_order_release);
        sleepers_.fetch_add(1, std::memory_order_acq_rel);
        const bool woken = !happened() && bed->bell.try_acquire_for(atMost);
        if (!woken && !bed->asleep.exchange(false, std::memory_order_acq_rel)) {
            bed->bell.acquire();  // it was rung meanwhile
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
