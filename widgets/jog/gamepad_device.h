// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Gamepads, through SDL: left stick X and Y, right stick Z (up and down) and the turn about Z; with the right
// shoulder held the sticks turn instead. Dead-man: left shoulder. The right face key stops.

#include "widgets/jog/input_device.h"

namespace tiller {

/// Owns SDL's part for gamepads for as long as it lives; at most one at a time.
class GamepadSource : public DeviceSource {
public:
    GamepadSource();
    ~GamepadSource() override;
    GamepadSource(const GamepadSource&) = delete;
    GamepadSource& operator=(const GamepadSource&) = delete;

    std::vector<std::unique_ptr<InputDevice>> appeared() override;

private:
    struct Private;
    std::shared_ptr<Private> d_;
};

}  // namespace tiller
