// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A SpaceMouse, through the free driver's socket (libspnav). Dead-man: its left key. Its right key stops.

#include "widgets/jog/input_device.h"

namespace tiller {

class SpaceMouseSource : public DeviceSource {
public:
    std::vector<std::unique_ptr<InputDevice>> appeared() override;

private:
    std::weak_ptr<void> open_;  ///< libspnav has one connection, so there is one device
};

}  // namespace tiller
