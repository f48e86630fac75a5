// SPDX-License-Identifier: MIT
#pragma once

// What newer controllers tell about themselves over RTDE besides their version: properties, by name.
// Source: the vendor's clients in Python and C++.

#include <string>
#include <vector>

#include "robot/core/version.h"
#include "robot/rtde/codec.h"

namespace tiller::simulator {

/// Whether this software answers RTDE_READ_PROPERTIES; it speaks protocol version 3 then. Older software
/// takes no notice of the request.
bool hasProperties(const SoftwareVersion& software);

/// The reply: the types, NOT_FOUND for what there is not, and the values only when every name is known.
void writeProperties(rtde::Bytes& out, const std::vector<std::string>& names,
                     const SoftwareVersion& software);

}  // namespace tiller::simulator
