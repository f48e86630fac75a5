// SPDX-License-Identifier: MIT
#pragma once

// Every value of the controller's enumerations, in the order of its number: for tables that must miss none,
// and for the tests that check them.

#include <vector>

#include "robot/core/modes.h"

namespace tiller {

/// RTDE's safety_status tells causes apart that older software reports as one safety mode; same numbers.
using SafetyStatus = SafetyMode;

/// Seen as a safety status only, so far. Source: SafetyStatus.msg of the ROS 2 driver
inline constexpr SafetyStatus kIoPlaneStop = static_cast<SafetyStatus>(23);

std::vector<RobotMode> robotModes();
std::vector<SafetyStatus> safetyStatuses();
std::vector<RuntimeState> runtimeStates();

}  // namespace tiller
