// SPDX-License-Identifier: MIT
#include "robot/station/program/execution/step_log.h"

namespace tiller::program {

void StepLog::add(double time, RuntimeState runtime, int value, int gate) {
    constexpr int kSettling = 2;
    const bool active = runtime != RuntimeState::Stopped && runtime != RuntimeState::Stopping;
    switch (phase_) {
        case Phase::Before:
            phase_ = active ? Phase::Before : Phase::Stopped;
            return;
        case Phase::Stopped:
            if (active) {
                phase_ = Phase::Running;
                began_ = time;
                settling_ = kSettling;
            }
            return;
        case Phase::Running:
            break;
        case Phase::Ended:
            return;
    }
    const double now = time - began_;
    if (step_ > 0 && !isWaiting_) {
        timings_[static_cast<std::size_t>(step_ - 1)].total += now - time_;
    }
    time_ = now;
    isPausedOnRobot_ = runtime == RuntimeState::Pausing || runtime == RuntimeState::Paused;
    if (settling_ > 0) {
        --settling_;
        return;
    }
    follow(value);
    isWaiting_ = active && gate < 0;
    begun_ = gate < 0 ? -1 - gate : gate;
    if (!active) {
        step_ = 0;
        phase_ = Phase::Ended;
    }
}

void StepLog::follow(int value) {
    const int steps = static_cast<int>(timings_.size());
    value_ = value;
    failed_ = value < 0 && -value <= steps ? -value : 0;
    const int next = value > 0 && value <= steps ? value : 0;
    if (next == step_) {
        return;
    }
    step_ = next;
    if (step_ > 0) {
        last_ = step_;
        StepTiming& timing = timings_[static_cast<std::size_t>(step_ - 1)];
        timing.first = timing.count++ == 0 ? time_ : timing.first;
    }
}

}  // namespace tiller::program
