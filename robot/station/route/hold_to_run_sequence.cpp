// SPDX-License-Identifier: MIT
#include "robot/station/route/hold_to_run_sequence.h"

#include <utility>

namespace tiller {

using control::StopCause;

HoldToRunSequence::HoldToRunSequence(std::function<std::uint64_t()> stops, Next next, Failed failed)
    : stops_(std::move(stops)), next_(std::move(next)), failed_(std::move(failed)) {}

HoldToRunSequence::~HoldToRunSequence() {
    end(id_, StopCause::WindowClosed);
}

HoldMotion HoldToRunSequence::motion(std::function<HoldBounds()> bounds) {
    return {
        .begin = [this] { return begin(); },
        .hold = [this](HoldMotion::Id id) { return hold(id); },
        .end = [this](HoldMotion::Id id, StopCause cause) { end(id, cause); },
        .runsToEnd = {},
        .bounds = std::move(bounds),
    };
}

Result<HoldMotion::Id> HoldToRunSequence::begin() {
    end(id_, StopCause::Superseded);
    stopsBefore_ = stops_();
    ++id_;
    const Result<bool> begun = beginNext();
    if (!begun) {
        return begun.error();
    }
    if (!*begun) {
        return Error{ErrorCode::NoSolution, {}, {}};
    }
    return id_;
}

Result<bool> HoldToRunSequence::beginNext() {
    step_.reset();
    Result<std::unique_ptr<SequenceStep>> next = next_();
    if (!next) {
        return next.error();
    }
    if (*next == nullptr) {
        return false;
    }
    if (const Result<void> begun = (*next)->begin(stopsBefore_); !begun) {
        return begun.error();
    }
    step_ = std::move(*next);
    return true;
}

bool HoldToRunSequence::hold(HoldMotion::Id id) {
    if (id != id_ || step_ == nullptr) {
        return false;
    }
    // A stop also ends the sequence between two moves, when no motion is active.
    if (stops_() != stopsBefore_) {
        end(id, StopCause::ApiCall);
        return false;
    }
    const Result<SequenceStep::State> state = step_->hold();
    if (state && *state == SequenceStep::State::Going) {
        return true;
    }
    Result<bool> goesOn = false;
    if (!state) {
        step_.reset();
        goesOn = state.error();
    } else if (*state == SequenceStep::State::Done) {
        goesOn = beginNext();
    } else {
        step_.reset();
    }
    // A stop is not a failure.
    if (!goesOn && goesOn.error().code != ErrorCode::Stopped) {
        failed_(goesOn.error());
    }
    return goesOn && *goesOn;
}

void HoldToRunSequence::end(HoldMotion::Id id, StopCause cause) {
    if (id == id_ && step_ != nullptr) {
        std::exchange(step_, nullptr)->end(cause);
    }
}

MoveStep::MoveStep(const MotionPort& port, MoveRequest move, std::function<void(int)> onMove)
    : port_(port), move_(std::move(move)), onMove_(std::move(onMove)) {}

MoveStep::MoveStep(const MotionPort& port, control::MotionPath path, std::function<void(int)> onMove)
    : port_(port), path_(std::move(path)), onMove_(std::move(onMove)) {}

Result<void> MoveStep::begin(std::uint64_t stops) {
    Result<MotionPort::Id> begun = 0;
    if (path_.empty()) {
        move_.stops = stops;
        begun = port_.beginMove(move_);
    } else {
        begun = port_.beginPath(path_, stops);
    }
    if (!begun) {
        return begun.error();
    }
    id_ = *begun;
    onMove_(reportedStep_ = 0);
    return {};
}

Result<SequenceStep::State> MoveStep::hold() {
    const bool alive = port_.hold(id_);
    const Result<control::MotionProgress> progress = port_.progress(id_);
    if (!progress) {
        return progress.error();
    }
    if (const int heading = progress->waypoint - 1; alive && heading > reportedStep_) {
        onMove_(reportedStep_ = heading);
    }
    if (alive) {
        return State::Going;
    }
    return progress->cause == StopCause::Completed ? State::Done : State::Ended;
}

void MoveStep::end(StopCause cause) {
    port_.endMotion(id_, cause);
}

}  // namespace tiller
