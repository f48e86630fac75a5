// SPDX-License-Identifier: MIT
#pragma once

// The RobotState package of the primary and secondary interfaces, sent ten times a second. Source: client
// interface manual; sizes and order recorded from the vendor's simulator.

#include <cstdint>
#include <vector>

#include "robot/simulator/plant/telemetry.h"

namespace tiller::simulator::primary {

/// first  whether to include KinematicsInfo and ConfigurationData, which each client receives only once
std::vector<std::uint8_t> robotState(const Telemetry& now, bool first);

}  // namespace tiller::simulator::primary
