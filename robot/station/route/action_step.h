// SPDX-License-Identifier: MIT
#pragma once

// One action at a waypoint as a step of what a key holds: an output, a wait, the gripper. Nothing of it is sent once
// the key is let go, and whatever would end a motion ends it too: the fingers of a Robotiq stand where they are, an
// output that pulses goes back, also when the window hangs. Time is the robot's own, and inputs are looked at once a
// frame: a change that is over within 16 ms may be missed.

#include <QCoreApplication>
#include <atomic>
#include <memory>
#include <optional>

#include "robot/project/waypoint_action.h"
#include "robot/station/link/gripper_port.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/route/hold_to_run_sequence.h"

namespace tiller {

/// What actions need of the robot besides motion.
struct ActionPort {
    /// As RobotOutputs::setDigitalOutputs().
    std::function<void(std::uint32_t mask, std::uint32_t values, const QString& what,
                       const OutputOrder& order)>
        setOutputs = {};
    GripperPort gripper = {};
};

class ActionStep : public SequenceStep {
    Q_DECLARE_TR_FUNCTIONS(ActionStep)

public:
    /// port, state  must outlive it; the state is always the newest
    ActionStep(const ActionPort& port, const SessionState& state, project::WaypointAction action);
    ~ActionStep() override;

    /// Errors  Cancelled, with a sentence: there is no gripper, or it cannot move
    Result<void> begin(std::uint64_t stops) override;
    /// Errors  Cancelled, with a sentence: an input did not come in time, an output was not set, the gripper failed
    Result<State> hold() override;
    void end(control::StopCause cause) override;

    /// How long it may take [s].
    static double longestOf(const project::WaypointAction& action);
    /// Why it cannot be done with this gripper, as a sentence; empty when it can.
    static QString obstacle(const project::WaypointAction& action, const GripperChoice& gripper);

private:
    /// One command to the outputs, shared with the worker that carries it out.
    struct Order {
        CancelToken token;
        std::atomic<std::uint32_t> holds{0};  ///< grows while the key is held
        std::optional<Result<void>> result;
    };
    std::shared_ptr<Order> send(std::uint32_t mask, std::uint32_t values) const;
    Result<State> holdOutput();
    Result<State> holdInput() const;
    Result<State> holdRobotiq();
    bool mayGoOn() const;
    double elapsed() const { return state_.robotTime - beganAt_; }  ///< [s]
    std::uint32_t pin() const { return 1U << project::channelOf(action_.group, action_.pin); }
    void giveUp();

    const ActionPort& port_;
    const SessionState& state_;
    project::WaypointAction action_;
    double beganAt_ = 0;  ///< robot's time [s]
    std::shared_ptr<Order> order_;
    CancelToken gripper_;
    bool gripping_ = false;  ///< a Robotiq was sent somewhere, and is not there yet
};

}  // namespace tiller
