// SPDX-License-Identifier: MIT
#pragma once

// Access to the gripper for all panels except the gripper panel: type, opening and closing.

#include <functional>
#include <optional>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/station/link/gripper_choice.h"

namespace tiller {

struct GripperPort {
    /// Returns the gripper chosen by the operator. For an output gripper, the caller sets the outputs.
    std::function<GripperChoice()> choice = [] { return GripperChoice(); };
    /// Robotiq only: why the gripper cannot be moved now, as a sentence; empty if it can.
    std::function<QString()> obstacle = {};
    /// Robotiq only: opens or closes the gripper completely, with the speed and force set in its panel.
    /// token  if cancelled, the command is not sent; a command already sent needs stop()
    std::function<void(bool close, const CancelToken& token)> move = {};
    /// Robotiq only: stops the fingers. A held object remains gripped.
    std::function<void()> stop = {};
    /// Robotiq only: result of the motion towards `close`; empty while the gripper moves. Gripping an object
    /// is a success.
    std::function<std::optional<Result<void>>(bool close)> outcome = {};
};

}  // namespace tiller
