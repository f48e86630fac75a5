// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Gamepads, accessed through SDL. The left stick moves the TCP along X and Y. The right stick moves the TCP
// along Z (up and down) and rotates the tool about Z. While the right shoulder button is held, both sticks
// rotate the tool. The left shoulder button is the enabling button. The right face button stops the arm.

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
