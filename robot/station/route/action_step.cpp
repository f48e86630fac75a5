// SPDX-License-Identifier: MIT
#include "robot/station/route/action_step.h"

#include <utility>

#include "robot/station/route/action_words.h"
#include "robot/station/text/texts.h"

namespace tiller {

namespace {

using Pin = project::WaypointActionKind::Pin;
using Time = project::WaypointActionKind::Time;
using Grip = project::WaypointActionKind::Grip;

/// Maximum age of robot data [ms].
constexpr double kOldest = 100;
/// Maximum duration of a gripper motion; a longer motion has failed [s].
constexpr double kMaxGripTime = 15;
/// Maximum time until the robot reports a new output level [s].
constexpr double kMaxConfirmation = 3;

bool isGrip(const project::WaypointAction& action) {
    return kindOf(action).grip != Grip::None;
}

Error sentence(const QString& text) {
    return {ErrorCode::Cancelled, text, {}};
}

}  // namespace

ActionStep::ActionStep(const ActionPort& port, const SessionState& state, project::WaypointAction action)
    : port_(port), state_(state), action_(std::move(action)) {}

ActionStep::~ActionStep() {
    giveUp();
}

QString ActionStep::obstacle(const project::WaypointAction& action, const GripperChoice& gripper) {
    return isGrip(action) && gripper.kind == GripperChoice::Kind::None
               ? tr("No gripper is configured for this robot. Select a gripper under I/O > Gripper.")
               : QString();
}

double ActionStep::longestOf(const project::WaypointAction& action) {
    const project::WaypointActionKind& kind = kindOf(action);
    if (kind.time == Time::Limit) {
        return action.seconds > 0 ? action.seconds : project::kMaxActionTime;
    }
    // The opposite level at the end of a pulse is also confirmed.
    const int confirmations = kind.pin != Pin::Output ? 0 : kind.time == Time::Duration ? 2 : 1;
    return (kind.time == Time::Duration ? action.seconds : 0) + confirmations * kMaxConfirmation +
           (isGrip(action) ? kMaxGripTime : 0);
}

std::shared_ptr<ActionStep::Order> ActionStep::send(std::uint32_t mask, std::uint32_t values) const {
    auto order = std::make_shared<Order>();
    OutputOrder asked;
    asked.token = order->token;
    asked.done = [order](const Result<void>& result) { order->result = result; };
    if (kindOf(action_).time == Time::Duration) {
        asked.pulse = {action_.seconds, [order] { return order->holds.load(); }};
    }
    port_.setOutputs(mask, values, tr("Run route"), asked);
    return order;
}

bool ActionStep::mayGoOn() const {
    return state_.canMove() && state_.link == LinkState::Live && state_.quality.ageMs <= kOldest;
}

Result<void> ActionStep::begin(std::uint64_t) {
    if (!mayGoOn()) {
        return Error{ErrorCode::Stopped, {}, {}};
    }
    const GripperChoice gripper = port_.gripper.choice();
    if (const QString why = obstacle(action_, gripper); !why.isEmpty()) {
        return sentence(why);
    }
    beganAt_ = state_.robotTime;
    const bool close = kindOf(action_).grip == Grip::Close;
    if (kindOf(action_).pin == Pin::Output) {
        order_ = send(pin(), action_.value ? pin() : 0);
    } else if (isGrip(action_) && gripper.usesOutputs()) {
        order_ = send(gripper.outputs(), gripper.outputsTo(close));
    } else if (isGrip(action_)) {
        if (const QString why = port_.gripper.obstacle(); !why.isEmpty()) {
            return sentence(why);
        }
        gripping_ = true;
        port_.gripper.move(close, gripper_);
    }
    return {};
}

Result<SequenceStep::State> ActionStep::hold() {
    if (!mayGoOn()) {
        giveUp();
        return State::Ended;
    }
    if (order_) {
        return holdOutput();
    }
    if (isGrip(action_)) {
        return holdRobotiq();
    }
    if (kindOf(action_).pin == Pin::Input) {
        return holdInput();
    }
    return elapsed() >= action_.seconds ? State::Done : State::Going;
}

Result<SequenceStep::State> ActionStep::holdInput() const {
    const bool on = (state_.digitalInputs & pin()) != 0;
    if (on == action_.value) {
        return State::Done;
    }
    if (elapsed() < longestOf(action_)) {
        return State::Going;
    }
    const QString seconds = QString::number(longestOf(action_), 'g', 6);
    return sentence((action_.value
                         ? tr("%1 did not turn on within %2 s. Check the connected device, then try again.")
                         : tr("%1 did not turn off within %2 s. Check the connected device, then try again."))
                        .arg(ActionWords::terminal(action_), seconds));
}

Result<SequenceStep::State> ActionStep::holdOutput() {
    ++order_->holds;
    if (!order_->result) {
        return State::Going;
    }
    if (!*order_->result) {
        const Error& error = order_->result->error();
        return sentence(tr("The action “%1” was not completed. %2")
                            .arg(ActionWords::of(action_), texts::errorText(error)));
    }
    return State::Done;
}

Result<SequenceStep::State> ActionStep::holdRobotiq() {
    const std::optional<Result<void>> outcome = port_.gripper.outcome(kindOf(action_).grip == Grip::Close);
    if (outcome) {
        gripping_ = false;
        return *outcome ? Result<State>(State::Done) : outcome->error();
    }
    if (elapsed() < kMaxGripTime) {
        return State::Going;
    }
    return sentence(tr("The gripper did not stop moving within %1 s. Check the gripper, then try again.")
                        .arg(kMaxGripTime));
}

void ActionStep::end(control::StopCause) {
    giveUp();
}

void ActionStep::giveUp() {
    gripper_.cancel();
    if (std::exchange(gripping_, false)) {
        port_.gripper.stop();
    }
    if (order_) {
        order_->token.cancel();
    }
}

}  // namespace tiller
