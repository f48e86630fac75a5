// SPDX-License-Identifier: MIT
#pragma once

// Runs a long computation in the background.

#include <atomic>
#include <functional>
#include <thread>

namespace tiller::program {

/// Runs one task at a time in a thread of normal priority. cancel(), the next start() and the destructor end
/// the task. Only the flag `cancelled` is shared with the thread.
class BackgroundTask {
public:
    BackgroundTask() = default;
    ~BackgroundTask();
    BackgroundTask(const BackgroundTask&) = delete;
    BackgroundTask& operator=(const BackgroundTask&) = delete;

    /// Cancels the running task and starts this one.
    /// work     called in the thread; must end soon after `cancelled` becomes true, and must then not report
    ///          a result
    /// Threads  one. Blocks: a few milliseconds while a running task ends
    void start(std::function<void(const std::atomic<bool>& cancelled)> work);
    void cancel();  ///< Ends the running task.
    bool isRunning() const { return isRunning_; }

private:
    std::thread thread_;
    std::atomic<bool> isRunning_ = false;
    std::atomic<bool> cancelled_ = false;
};

}  // namespace tiller::program
