// SPDX-License-Identifier: MIT
#pragma once

// The gripper of the robot for panels other than its own: its type, opening and closing.

#include <functional>
#include <optional>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/station/link/gripper_choice.h"

namespace tiller {

struct GripperPort {
    /// The choice of the operator. The caller sets the outputs of an output gripper itself.
    std::function<GripperChoice()> choice = [] { return GripperChoice(); };
    /// Robotiq: the reason why it cannot be moved now, as a sentence; empty if it can.
    std::function<QString()> obstacle = {};
    /// Robotiq: opens or closes it completely, with the speed and force of its panel.
    /// token  cancelled: the command is no longer sent; a sent command needs stop()
    std::function<void(bool close, const CancelToken& token)> move = {};
    /// Robotiq: stops the fingers; a held object stays held.
    std::function<void()> stop = {};
    /// Robotiq: nothing while it moves towards the target of `close`, then the result. Holding an object is
    /// also a result.
    std::function<std::optional<Result<void>>(bool close)> outcome = {};
};

}  // namespace tiller
