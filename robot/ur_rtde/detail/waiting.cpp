// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/detail/waiting.h"

#include <atomic>
#include <thread>

namespace tiller::urrtde {

namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kAskEvery(10);
std::atomic<bool (*)()> interruptCheck{nullptr};
thread_local int uninterrupted = 0;

}  // namespace

void setInterruptCheck(bool (*check)()) {
    interruptCheck = check;
}

bool isInterrupted() {
    thread_local SteadyClock::time_point asked{};
    const auto check = interruptCheck.load();
    if (check == nullptr || uninterrupted > 0) {
        return false;
    }
    const auto now = SteadyClock::now();
    if (now - asked < kAskEvery) {
        return false;
    }
    asked = now;
    return check();
}

void throwIfInterrupted() {
    if (isInterrupted()) {
        throw Interrupted();
    }
}

Uninterrupted::Uninterrupted() {
    ++uninterrupted;
}

Uninterrupted::~Uninterrupted() {
    --uninterrupted;
}

Deadline within(std::chrono::milliseconds time) {
    return Deadline::after(time, CancelToken(&isInterrupted));
}

void sleepUntil(SteadyClock::time_point end) {
    constexpr std::chrono::milliseconds kWaitStep(50);
    for (auto now = SteadyClock::now(); now + kWaitStep < end; now = SteadyClock::now()) {
        std::this_thread::sleep_for(kWaitStep);
        throwIfInterrupted();
    }
    std::this_thread::sleep_until(end);
}

void raise(const Error& error) {
    if (error.code == ErrorCode::Cancelled) {
        throw Interrupted();
    }
    throw std::runtime_error(error.toString().toStdString());
}

}  // namespace tiller::urrtde
