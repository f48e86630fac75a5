// SPDX-License-Identifier: MIT
#pragma once

// A sequence of moves and actions that runs while a button is held. When the button is released or the hold
// ends for another reason, the current step ends and no other step starts. After a stop by any cause, no step
// starts.

#include <cstdint>
#include <functional>
#include <memory>

#include "robot/station/link/hold_motion.h"
#include "robot/station/link/motion_port.h"

namespace tiller {

/// One step of a sequence. The object exists only while the step runs.
class SequenceStep {
public:
    enum class State {
        Going,
        Done,
        Ended,  ///< stopped early, by Tiller or by the robot
    };

    virtual ~SequenceStep() = default;
    /// stops  MotionPort::stops when the button was pressed
    virtual Result<void> begin(std::uint64_t stops) = 0;
    /// Keeps the step active. Call at least every 100 ms.
    virtual Result<State> hold() = 0;
    /// Ends the step early. No part of the step continues.
    virtual void end(control::StopCause cause) = 0;
};

class HoldToRunSequence {
public:
    /// Returns the next step, or null after the last. An error ends the sequence.
    using Next = std::function<Result<std::unique_ptr<SequenceStep>>()>;
    /// Receives the error if the sequence ends early, except after a stop.
    using Failed = std::function<void(const Error&)>;

    /// stops  returns the number of stops, as MotionPort::stops
    HoldToRunSequence(std::function<std::uint64_t()> stops, Next next, Failed failed);
    ~HoldToRunSequence();

    /// The motion for the button.
    /// bounds  called after the first step has started
    HoldMotion motion(std::function<HoldBounds()> bounds);
    bool isActive() const { return step_ != nullptr; }

private:
    Result<HoldMotion::Id> begin();
    bool hold(HoldMotion::Id id);
    void end(HoldMotion::Id id, control::StopCause cause);
    /// Returns false if there is no next step or if it could not start.
    Result<bool> beginNext();

    std::function<std::uint64_t()> stops_;
    Next next_;
    Failed failed_;
    std::unique_ptr<SequenceStep> step_;
    HoldMotion::Id id_ = 0;
    std::uint64_t stopsBefore_ = 0;
};

/// One move, or several blended moves.
class MoveStep : public SequenceStep {
public:
    /// onMove  called with the index of the current move, from 0, when it changes
    MoveStep(const MotionPort& port, MoveRequest move, std::function<void(int)> onMove);
    MoveStep(const MotionPort& port, control::MotionPath path, std::function<void(int)> onMove);

    Result<void> begin(std::uint64_t stops) override;
    Result<State> hold() override;
    void end(control::StopCause cause) override;

private:
    const MotionPort& port_;
    MoveRequest move_;
    control::MotionPath path_;
    std::function<void(int)> onMove_;
    MotionPort::Id id_ = 0;
    int reportedStep_ = -1;
};

}  // namespace tiller
