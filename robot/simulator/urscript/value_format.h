// SPDX-License-Identifier: MIT
#pragma once

// Converts values to text in two styles, as on the controller.

#include <cstddef>
#include <string>

#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

/// Conversion for to_str and str_cat: six decimals without trailing zeros, ", " between elements. The result
/// may exceed the maximum string length, but no element is added after `limit` characters.
std::string toStr(const Value& v, std::size_t limit = 2048);
/// Conversion for textmsg: six significant digits, "," between elements.
std::string toMessageText(const Value& v, std::size_t limit = 65536);

}  // namespace tiller::simulator::urscript
