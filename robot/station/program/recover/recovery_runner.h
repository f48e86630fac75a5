// SPDX-License-Identifier: MIT
#pragma once

// Runs a recoverability check in the background.

#include <functional>

#include "robot/station/program/preview/background_task.h"
#include "robot/station/program/recover/recovery_map.h"

namespace tiller::program {

/// The task thread uses copies of the project and the script, and returns the marks.
class RecoveryRunner {
public:
    /// Cancels the running check and starts this one.
    /// inputs   of the simulated robot, as for a preview
    /// done     called in the thread of the check, unless the check is cancelled first
    /// Threads  one. Blocks: a few milliseconds while a running check ends
    void start(project::Project project, const QUuid& program, ProgramScript script,
               ScriptOptions scriptOptions, std::vector<InputChange> inputs,
               std::function<void(const RecoveryMap&)> done);
    void cancel();  ///< Ends the running check without calling `done`.
    bool isRunning() const { return task_.isRunning(); }

private:
    BackgroundTask task_;
};

}  // namespace tiller::program
