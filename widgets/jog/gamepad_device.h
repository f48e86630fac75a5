// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Gamepads through SDL: left stick X and Y, right stick Z (up and down) and rotation about Z; with the right
// shoulder button the sticks rotate instead. Enabling button: left shoulder. The right face button stops.

#include "widgets/jog/input_device.h"

namespace tiller {

/// Owns SDL's gamepad subsystem during its lifetime; at most one instance at a time.
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
