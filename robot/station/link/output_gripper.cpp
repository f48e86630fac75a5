// SPDX-License-Identifier: MIT
#include "robot/station/link/output_gripper.h"

#include "robot/core/clock.h"

namespace tiller {
namespace {

/// Maximum time for which an unconfirmed command is displayed as "pending".
constexpr std::int64_t kGripperConfirmNs = 2 * kNsPerSecond;

bool isOn(const SessionState& state, int output) {
    return ((state.digitalOutputs >> output) & 1U) != 0;
}

}  // namespace

void OutputGripper::choose(const GripperChoice& choice) {
    choice_ = choice;
    hand_ = Hand::Unknown;
    pending_.reset();
    complaint_.clear();
}

void OutputGripper::follow(const SessionState& state, std::int64_t nowNs) {
    hand_ = handIn(state);
    if (pending_ && (state.link != LinkState::Live || hand_ == pending_->wanted)) {
        pending_.reset();
    } else if (pending_ && nowNs - pending_->sinceNs > kGripperConfirmNs) {
        pending_.reset();
        complaint_ = tr(
            "The robot did not confirm the outputs. Another program or the installation may control them.");
    }
}

OutputGripper::Hand OutputGripper::handIn(const SessionState& state) const {
    if (!state.hasData()) {
        return Hand::Unknown;
    }
    const bool close = isOn(state, choice_.closeOutput);
    if (!hasTwo()) {
        return close ? Hand::Closed : Hand::Open;
    }
    const bool open = isOn(state, choice_.openOutput);
    return close && open ? Hand::Both : close ? Hand::Closed : open ? Hand::Open : Hand::Neither;
}

OutputGripper::Command OutputGripper::command(bool close, std::int64_t nowNs) {
    pending_ = Pending{close ? Hand::Closed : Hand::Open, nowNs};
    complaint_.clear();
    return {choice_.outputs(), choice_.outputsTo(close), close ? tr("Gripper: close") : tr("Gripper: open")};
}

QString OutputGripper::text() const {
    if (pending_) {
        return tr("pending…");
    }
    switch (hand_) {
        case Hand::Unknown:
            return tr("unknown");
        case Hand::Open:
            return tr("open requested");
        case Hand::Closed:
            return tr("close requested");
        case Hand::Neither:
            return tr("both outputs off");
        case Hand::Both:
            return tr("both outputs on");
    }
    return {};
}

QString OutputGripper::obstacle(const OutputHolders& holders) const {
    if (hasTwo() && choice_.closeOutput == choice_.openOutput) {
        return tr("Choose different outputs for closing and opening.");
    }
    const QString& close = holders.digital(choice_.closeOutput);
    return !close.isEmpty() || !hasTwo() ? close : holders.digital(choice_.openOutput);
}

}  // namespace tiller
