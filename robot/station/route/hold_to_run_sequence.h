// SPDX-License-Identifier: MIT
#pragma once

// Several things done one after the other under one press of one key: ways to go, and what is done between them.
// Letting go, or whatever else ends the hold, ends the one under way and begins no other; neither does any that
// would begin after a stop, whoever stopped.

#include <cstdint>
#include <functional>
#include <memory>

#include "robot/station/link/hold_motion.h"
#include "robot/station/link/motion_port.h"

namespace tiller {

/// One of them. It lives from its begin to its end.
class SequenceStep {
public:
    enum class State {
        Going,
        Done,
        Ended,  ///< by itself, before it was done: a stop, or the robot
    };

    virtual ~SequenceStep() = default;
    /// stops  as MotionPort::stops when the key was pressed
    virtual Result<void> begin(std::uint64_t stops) = 0;
    /// Keeps it alive, at least every 100 ms.
    virtual Result<State> hold() = 0;
    /// Ends it before it is done: afterwards nothing of it goes on.
    virtual void end(control::StopCause cause) = 0;
};

class HoldToRunSequence {
public:
    /// The step that comes now; null when all are done. An error ends the sequence.
    using Next = std::function<Result<std::unique_ptr<SequenceStep>>()>;
    /// Why it ended before its end, when that is not a stop.
    using Failed = std::function<void(const Error&)>;

    /// stops  how many there were: MotionPort::stops
    HoldToRunSequence(std::function<std::uint64_t()> stops, Next next, Failed failed);
    ~HoldToRunSequence();

    /// For the key.
    /// bounds  asked when the first step has begun
    HoldMotion motion(std::function<HoldBounds()> bounds);
    bool isActive() const { return step_ != nullptr; }

private:
    Result<HoldMotion::Id> begin();
    bool hold(HoldMotion::Id id);
    void end(HoldMotion::Id id, control::StopCause cause);
    /// Returns  false when there is none, or it could not begin
    Result<bool> beginNext();

    std::function<std::uint64_t()> stops_;
    Next next_;
    Failed failed_;
    std::unique_ptr<SequenceStep> step_;
    HoldMotion::Id id_ = 0;
    std::uint64_t stopsBefore_ = 0;
};

/// A way to go: one move, or several blended into each other.
class MoveStep : public SequenceStep {
public:
    /// told  which of the moves is headed for, counted from 0; called when it changes
    MoveStep(const MotionPort& port, MoveRequest move, std::function<void(int)> told);
    MoveStep(const MotionPort& port, control::MotionPath path, std::function<void(int)> told);

    Result<void> begin(std::uint64_t stops) override;
    Result<State> hold() override;
    void end(control::StopCause cause) override;

private:
    const MotionPort& port_;
    MoveRequest move_;
    control::MotionPath path_;
    std::function<void(int)> told_;
    MotionPort::Id id_ = 0;
    int toldOf_ = -1;
};

}  // namespace tiller
