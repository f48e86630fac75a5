// SPDX-License-Identifier: MIT
#pragma once

// All values of the controller's enumerations in numeric order, for complete tables and the tests that check them.

#include <vector>

#include "robot/core/modes.h"

namespace tiller {

/// RTDE's safety_status distinguishes causes that older software reports as a single safety mode. The numbers
/// are the same.
using SafetyStatus = SafetyMode;

/// So far observed only as a safety status. Source: SafetyStatus.msg of the ROS 2 driver
inline constexpr SafetyStatus kIoPlaneStop = static_cast<SafetyStatus>(23);

std::vector<RobotMode> robotModes();         ///< In numeric order.
std::vector<SafetyStatus> safetyStatuses();  ///< In numeric order.
std::vector<RuntimeState> runtimeStates();   ///< In numeric order.

}  // namespace tiller
