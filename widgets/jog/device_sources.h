// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "widgets/jog/input_device.h"

namespace tiller {

/// Every kind of device this build knows: gamepads where SDL is, a SpaceMouse where libspnav is.
std::vector<std::unique_ptr<DeviceSource>> deviceSources();

}  // namespace tiller
