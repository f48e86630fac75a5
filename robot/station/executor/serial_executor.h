// SPDX-License-Identifier: MIT
#pragma once

// Executes jobs that would block the window: taking control, connecting, confirming an output.

#include <QObject>
#include <functional>
#include <memory>

#include "robot/core/deadline.h"

namespace tiller {

/// Runs jobs in one thread of normal priority, from construction to destruction. The destructor cancels the
/// current job through its token and drops waiting jobs. Completions run in the thread of their context.
class SerialExecutor {
public:
    SerialExecutor();
    ~SerialExecutor();
    SerialExecutor(const SerialExecutor&) = delete;
    SerialExecutor& operator=(const SerialExecutor&) = delete;

    /// Runs `job` after all jobs posted before. Then runs the returned function in the thread of `context`,
    /// unless `context` has been destroyed.
    /// Threads  any. Blocks: never
    void post(QObject* context, std::function<std::function<void()>(const CancelToken&)> job);
    /// Runs `job` even if the worker is ending, e.g. to close resources.
    void postCleanup(std::function<void()> job);
    /// Cancels the current job and drops waiting jobs, except cleanup jobs.
    void cancelAll();

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller
