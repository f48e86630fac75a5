// SPDX-License-Identifier: MIT
#pragma once

// The one list of fields that recordings, the interface and the ur_rtde face build upon.

#include <string>
#include <vector>

namespace tiller::receive {

/// What ur_rtde follows on every software, in its order.
std::vector<std::string> commonFields();
/// Adds integer register 2 and registers 12 to 19 of both kinds, which ur_rtde follows too.
/// upper  of the range from 24 on
void addOutputRegisters(std::vector<std::string>& fields, bool upper);

}  // namespace tiller::receive
