// SPDX-License-Identifier: MIT
#pragma once

// What RTDEReceiveInterface follows unless told otherwise. Private to this room.

#include <string>
#include <vector>

namespace tiller::urrtde {

/// upper  the registers from 24 on
std::vector<std::string> receiveFields(bool upper);

}  // namespace tiller::urrtde
