// SPDX-License-Identifier: MIT
#pragma once

// A mutex with a timeout. std::timed_mutex would be sufficient, but ThreadSanitizer does not support its wait
// function (pthread_mutex_clocklock) and reports every lock as an error.

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace tiller {

/// Usable with std::unique_lock and std::lock_guard.
/// Threads  any
class Turn {
public:
    void lock() {  ///< Blocks: until the mutex is free
        std::unique_lock guard(guard_);
        free_.wait(guard, [this] { return !taken_; });
        taken_ = true;
    }
    bool try_lock() { return try_lock_for(std::chrono::nanoseconds(0)); }  ///< Blocks: never
    /// Returns  false if the mutex was not free in time
    /// Threads  any. Blocks: at most for the given time
    bool try_lock_for(std::chrono::nanoseconds timeout) {
        std::unique_lock guard(guard_);
        if (!free_.wait_for(guard, timeout, [this] { return !taken_; })) {
            return false;
        }
        taken_ = true;
        return true;
    }
    void unlock() {
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
