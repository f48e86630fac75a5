// SPDX-License-Identifier: MIT
#pragma once

// One after the other, with a limit to the patience. std::timed_mutex would do, but ThreadSanitizer does not
// know the call by which it waits (pthread_mutex_clocklock) and so takes every such lock for a fault.

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace tiller {

/// A mutex to wait for with a limit; for std::unique_lock and std::lock_guard.
/// Threads  any
class Turn {
public:
    void lock() {  ///< Blocks: until its turn comes
        std::unique_lock guard(guard_);
        free_.wait(guard, [this] { return !taken_; });
        taken_ = true;
    }
    bool try_lock() { return try_lock_for(std::chrono::nanoseconds(0)); }  ///< Without waiting.
    /// Returns  false when the turn did not come within `patience`
    /// Threads  any. Blocks: at most `patience`
    bool try_lock_for(std::chrono::nanoseconds patience) {
        std::unique_lock guard(guard_);
        if (!free_.wait_for(guard, patience, [this] { return !taken_; })) {
            return false;
        }
        taken_ = true;
        return true;
    }
    void unlock() {  ///< The next one's turn.
        const std::lock_guard guard(guard_);
        taken_ = false;
        free_.notify_one();
    }

private:
    std::mutex guard_;
    std::condition_variable free_;
    bool taken_ = false;
};

}  // namespace tiller
