// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "widgets/jog/input_device.h"

namespace tiller {

/// Returns the sources for all device types of this build: gamepads with SDL, SpaceMouse with libspnav.
std::vector<std::unique_ptr<DeviceSource>> deviceSources();

}  // namespace tiller
