// SPDX-License-Identifier: MIT
#include "robot/station/program/preview/preview_runner.h"

#include <utility>

namespace tiller::program {

void PreviewRunner::cancel() {
    task_.cancel();
}

void PreviewRunner::start(project::Project project, ProgramScript script, ScriptOptions scriptOptions,
                          PreviewOptions options, std::function<void(const Preview&)> done) {
    task_.start([project = std::move(project), script = std::move(script),
                 scriptOptions = std::move(scriptOptions), options = std::move(options),
                 done = std::move(done)](const std::atomic<bool>& cancelled) mutable {
        options.isCancelled = [&cancelled] { return cancelled.load(); };
        const Preview preview = previewProgram(project, script, scriptOptions, options);
        if (!cancelled) {
            done(preview);
        }
    });
}

}  // namespace tiller::program
