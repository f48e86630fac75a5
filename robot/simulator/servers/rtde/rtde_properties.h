// SPDX-License-Identifier: MIT
#pragma once

// Properties that newer controllers report over RTDE in addition to their version, by name.

#include <string>
#include <vector>

#include "robot/core/version.h"
#include "robot/rtde/codec.h"

namespace tiller::simulator {

/// Whether this software answers RTDE_READ_PROPERTIES; it speaks protocol version 3 then. Older software
/// takes no notice of the request.
bool hasProperties(const SoftwareVersion& software);

/// Writes the reply: the types, NOT_FOUND for unknown names, and the values only if every name is known.
void writeProperties(rtde::Bytes& out, const std::vector<std::string>& names,
                     const SoftwareVersion& software);

}  // namespace tiller::simulator
