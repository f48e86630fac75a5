// SPDX-License-Identifier: MIT
#pragma once

// One action at a waypoint as a step of a hold-to-run sequence: an output, a wait, or the gripper. No command
// is sent after the button is released. Every condition that ends a motion also ends the action: a Robotiq
// gripper stops, and a pulsed output is switched back, even if the window hangs. Times are measured with the
// robot's clock. Inputs are checked once per frame, so a change shorter than 16 ms may be missed.

#include <QCoreApplication>
#include <atomic>
#include <memory>
#include <optional>

#include "robot/project/waypoint_action.h"
#include "robot/station/link/gripper_port.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/route/hold_to_run_sequence.h"

namespace tiller {

/// Robot functions for actions, other than motion.
struct ActionPort {
    /// Like RobotOutputs::setDigitalOutputs().
    std::function<void(std::uint32_t mask, std::uint32_t values, const QString& what,
                       const OutputOrder& order)>
        setOutputs = {};
    GripperPort gripper = {};
};

class ActionStep : public SequenceStep {
    Q_DECLARE_TR_FUNCTIONS(ActionStep)

public:
    /// port, state  must outlive the object; `state` must always contain the current state
    ActionStep(const ActionPort& port, const SessionState& state, project::WaypointAction action);
    ~ActionStep() override;

    /// Errors  Cancelled, with a sentence: no gripper is selected, or it cannot move
    Result<void> begin(std::uint64_t stops) override;
    /// Errors  Cancelled, with a sentence: an input did not change in time, an output was not set, or the
    ///         gripper failed
    Result<State> hold() override;
    void end(control::StopCause cause) override;

    /// Maximum duration of the action [s].
    static double longestOf(const project::WaypointAction& action);
    /// Why the action is not possible with this gripper, as a sentence; empty if it is possible.
    static QString obstacle(const project::WaypointAction& action, const GripperChoice& gripper);

private:
    /// One command to the outputs, shared with the worker that executes it.
    struct Order {
        CancelToken token;
        std::atomic<std::uint32_t> holds{0};  ///< incremented while the button is held
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
    double beganAt_ = 0;  ///< start time on the robot's clock [s]
    std::shared_ptr<Order> order_;
    CancelToken gripper_;
    bool gripping_ = false;  ///< a Robotiq gripper is moving to a commanded position
};

}  // namespace tiller
