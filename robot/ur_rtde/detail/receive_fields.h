// SPDX-License-Identifier: MIT
#pragma once

// Default fields of RTDEReceiveInterface. Private to robot/ur_rtde.

#include <string>
#include <vector>

namespace tiller::urrtde {

/// upper  use the registers from number 24 on
std::vector<std::string> receiveFields(bool upper);

}  // namespace tiller::urrtde
