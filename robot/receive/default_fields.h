// SPDX-License-Identifier: MIT
#pragma once

// The field lists of recordings, the user interface and the ur_rtde compatibility layer.

#include <string>
#include <vector>

namespace tiller::receive {

/// The fields that ur_rtde subscribes to on every software version, in its order.
std::vector<std::string> commonFields();
/// Adds the registers of ur_rtde: integer register 2 and registers 12 to 19 of both types.
/// upper  use the upper range of registers, which starts at 24
void addOutputRegisters(std::vector<std::string>& fields, bool upper);

}  // namespace tiller::receive
