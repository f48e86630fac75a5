// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "robot/receive/sample.h"

namespace tiller::live {

/// One sample as a JSON object: numbers by the names of their fields, vectors as arrays; what the robot does not send is
/// left out. Empties `out` first. Private to this room.
void writeJson(const receive::Sample& sample, const std::vector<std::string>& fields, std::string& out);

}  // namespace tiller::live
