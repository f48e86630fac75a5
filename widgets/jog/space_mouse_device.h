// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A SpaceMouse, read through the socket of the free driver (libspnav). The left button is the enabling
// button. The right button stops the arm.

#include "widgets/jog/input_device.h"

namespace tiller {

class SpaceMouseSource : public DeviceSource {
public:
    std::vector<std::unique_ptr<InputDevice>> appeared() override;

private:
    std::weak_ptr<void> open_;  ///< libspnav supports only one connection, and thus one device
};

}  // namespace tiller
