// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A SpaceMouse, through the socket of the free driver (libspnav). Enabling button: left. The right button stops.

#include "widgets/jog/input_device.h"

namespace tiller {

class SpaceMouseSource : public DeviceSource {
public:
    std::vector<std::unique_ptr<InputDevice>> appeared() override;

private:
    std::weak_ptr<void> open_;  ///< libspnav supports only one connection, so there is one device
};

}  // namespace tiller
