// SPDX-License-Identifier: MIT
#include "robot/station/program/preview/background_task.h"

#include <utility>

namespace tiller::program {

BackgroundTask::~BackgroundTask() {
    cancel();
}

void BackgroundTask::start(std::function<void(const std::atomic<bool>& cancelled)> work) {
    cancel();
    cancelled_ = false;
    isRunning_ = true;
    thread_ = std::thread([this, work = std::move(work)] {
        work(cancelled_);
        isRunning_ = false;
    });
}

void BackgroundTask::cancel() {
    cancelled_ = true;
    if (thread_.joinable()) {
        thread_.join();
    }
}

}  // namespace tiller::program
