// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/device_sources.h"

#ifdef TILLER_HAS_SDL
#include "widgets/jog/gamepad_device.h"
#endif
#ifdef TILLER_HAS_SPNAV
#include "widgets/jog/space_mouse_device.h"
#endif

namespace tiller {

std::vector<std::unique_ptr<DeviceSource>> deviceSources() {
    std::vector<std::unique_ptr<DeviceSource>> sources;
#ifdef TILLER_HAS_SDL
    sources.push_back(std::make_unique<GamepadSource>());
#endif
#ifdef TILLER_HAS_SPNAV
    sources.push_back(std::make_unique<SpaceMouseSource>());
#endif
    return sources;
}

}  // namespace tiller
