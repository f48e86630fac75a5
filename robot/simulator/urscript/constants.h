// SPDX-License-Identifier: MIT
#pragma once

// Values written as in a program, outside of one: in tables of devices.

#include <string_view>

#include "robot/core/result.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

/// A number, True, False, a text in quotes, a list, a pose `p[...]` or a struct of these.
/// Errors  ScriptError with the reason
Result<Value> constantValue(std::string_view text);

}  // namespace tiller::simulator::urscript
