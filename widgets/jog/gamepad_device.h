// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Gamepads through SDL. The left stick moves in X and Y. The right stick moves in Z (up and down) and rotates
// about Z. While the right shoulder button is held, the sticks rotate instead. The left shoulder button is
// the enabling button. The right face button stops the arm.

#include "widgets/jog/input_device.h"

namespace tiller {

/// Owns the gamepad subsystem of SDL. Only one instance may exist at a time.
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
