// SPDX-License-Identifier: MIT
#pragma once

// Runs a preview in the background.

#include <functional>

#include "robot/station/program/preview/background_task.h"
#include "robot/station/program/preview/preview.h"

namespace tiller::program {

/// The task thread uses copies of the project and the script, and returns the preview.
class PreviewRunner {
public:
    /// Cancels the running preview and starts this one.
    /// done     called in the thread of the preview, unless the preview is cancelled first
    /// Threads  one. Blocks: a few milliseconds while a running preview ends
    void start(project::Project project, ProgramScript script, ScriptOptions scriptOptions,
               PreviewOptions options, std::function<void(const Preview&)> done);
    void cancel();  ///< Ends the running preview without calling `done`.

private:
    BackgroundTask task_;
};

}  // namespace tiller::program
