// SPDX-License-Identifier: MIT
#pragma once

// Runs a preview in the background.

#include <atomic>
#include <functional>
#include <thread>

#include "robot/station/program/preview/preview.h"

namespace tiller::program {

/// Thread: one at a time, normal priority, started by start(), ended by cancel(), the next start() and the
/// destructor. Copies of project and script are passed to the thread, which returns the preview.
class PreviewRunner {
public:
    PreviewRunner() = default;
    ~PreviewRunner();
    PreviewRunner(const PreviewRunner&) = delete;
    PreviewRunner& operator=(const PreviewRunner&) = delete;

    /// Cancels the running preview and starts this one.
    /// done     called in the thread of the preview, unless the preview is cancelled first
    /// Threads  one. Blocks: a few milliseconds while a running preview ends
    void start(project::Project project, ProgramScript script, ScriptOptions scriptOptions,
               PreviewOptions options, std::function<void(const Preview&)> done);
    void cancel();  ///< Ends the running preview; `done` is not called afterwards.

private:
    std::thread thread_;
    std::atomic<bool> cancelled_ = false;
};

}  // namespace tiller::program
