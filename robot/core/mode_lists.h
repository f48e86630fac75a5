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

std::vector<RobotMode> robotModes();         ///< In the order of their numbers.
std::vector<SafetyStatus> safetyStatuses();  ///< In the order of their numbers.
std::vector<RuntimeState> runtimeStates();   ///< In the order of their numbers.

}  // namespace tiller
