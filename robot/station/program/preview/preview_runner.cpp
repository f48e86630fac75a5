// SPDX-License-Identifier: MIT
#include "robot/station/program/preview/preview_runner.h"

#include <utility>

namespace tiller::program {

PreviewRunner::~PreviewRunner() {
    cancel();
}

void PreviewRunner::cancel() {
    cancelled_ = true;
    if (thread_.joinable()) {
        thread_.join();
    }
}

void PreviewRunner::start(project::Project project, ProgramScript script, ScriptOptions scriptOptions,
                          PreviewOptions options, std::function<void(const Preview&)> done) {
    cancel();
    cancelled_ = false;
    options.isCancelled = [this] { return cancelled_.load(); };
    thread_ = std::thread([this, project = std::move(project), script = std::move(script),
                           scriptOptions = std::move(scriptOptions), options = std::move(options),
                           done = std::move(done)] {
        const Preview preview = previewProgram(project, script, scriptOptions, options);
        if (!cancelled_) {
            done(preview);
        }
    });
}

}  // namespace tiller::program
