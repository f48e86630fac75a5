// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "robot/receive/sample.h"

namespace tiller::live {

/// Converts one sample to a JSON object of field names with numbers, or arrays for vectors. Missing values
/// are omitted. Clears `out` first. Private to this folder.
void writeJson(const receive::Sample& sample, const std::vector<std::string>& fields, std::string& out);

}  // namespace tiller::live
