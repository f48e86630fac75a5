// SPDX-License-Identifier: MIT
#pragma once

// Executes jobs that would block the window: taking control, connecting, confirming an output.

#include <QObject>
#include <functional>
#include <memory>

#include "robot/core/deadline.h"

namespace tiller {

/// Thread: one, normal priority, started by the constructor, ended by the destructor, which cancels the job
/// under way through its token and drops those that wait. Jobs cross into it, completions out of it.
class SerialExecutor {
public:
    SerialExecutor();
    ~SerialExecutor();
    SerialExecutor(const SerialExecutor&) = delete;
    SerialExecutor& operator=(const SerialExecutor&) = delete;

    /// Runs `job` after those posted before, then the function it returned in the thread of `context` (not at
    /// all once context is gone).
    /// Threads  any. Blocks: never
    void post(QObject* context, std::function<std::function<void()>(const CancelToken&)> job);
    /// Runs `job` even while the worker is ending: for closing things.
    void postCleanup(std::function<void()> job);
    /// Cancels the job under way and drops those that wait, cleanups excepted.
    void cancelAll();

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller
