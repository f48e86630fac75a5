// SPDX-License-Identifier: MIT
#pragma once

// The gripper of the robot for panels other than its own: which one it is, and what opens and closes it.

#include <functional>
#include <optional>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/station/link/gripper_choice.h"

namespace tiller {

struct GripperPort {
    /// As the operator chose it; outputs are for whoever asks to set.
    std::function<GripperChoice()> choice = [] { return GripperChoice(); };
    /// Of a Robotiq: why it cannot be moved now, as a sentence; empty when it can.
    std::function<QString()> obstacle = {};
    /// Of a Robotiq: opens or closes it as far as it goes, as fast and as strong as its panel says.
    /// token  cancelled: it is not sent any more; for what has been sent there is stop
    std::function<void(bool close, const CancelToken& token)> move = {};
    /// Of a Robotiq: its fingers stand where they are; what they hold they go on holding.
    std::function<void()> stop = {};
    /// Of a Robotiq: nothing while it is on its way to where `close` sends it, then how that ended. What it
    /// holds is an end too.
    std::function<std::optional<Result<void>>(bool close)> outcome = {};
};

}  // namespace tiller
