// SPDX-License-Identifier: MIT
#include "robot/station/program/recover/recovery_runner.h"

#include <utility>

namespace tiller::program {

void RecoveryRunner::cancel() {
    task_.cancel();
}

void RecoveryRunner::start(project::Project project, const QUuid& program, ProgramScript script,
                           ScriptOptions scriptOptions, std::vector<InputChange> inputs,
                           std::function<void(const RecoveryMap&)> done) {
    task_.start([project = std::move(project), program, script = std::move(script),
                 scriptOptions = std::move(scriptOptions), inputs = std::move(inputs),
                 done = std::move(done)](const std::atomic<bool>& cancelled) {
        RecoveryOptions options;
        options.preview.inputs = inputs;
        options.preview.isCancelled = [&cancelled] { return cancelled.load(); };
        const RecoveryMap map = checkRecovery(project, program, script, scriptOptions, options);
        if (!cancelled) {
            done(map);
        }
    });
}

}  // namespace tiller::program
