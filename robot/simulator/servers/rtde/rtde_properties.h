// SPDX-License-Identifier: MIT
#pragma once

// Properties that newer controllers report over RTDE, by name, in addition to their version.

#include <string>
#include <vector>

#include "robot/core/version.h"
#include "robot/rtde/codec.h"

namespace tiller::simulator {

/// True if this software supports protocol version 3 and replies to RTDE_READ_PROPERTIES. Older software
/// ignores the request.
bool hasProperties(const SoftwareVersion& software);

/// Writes the reply: the types, NOT_FOUND for unknown names, and the values only if all names are known.
void writeProperties(rtde::Bytes& out, const std::vector<std::string>& names,
                     const SoftwareVersion& software);

}  // namespace tiller::simulator
