// SPDX-License-Identifier: MIT
#pragma once

// Constant values in URScript notation outside of programs, e.g. in device tables.

#include <string_view>

#include "robot/core/result.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

/// Parses a number, True, False, a quoted string, a list, a pose `p[...]` or a struct of such values.
/// Errors  ScriptError with the reason
Result<Value> constantValue(std::string_view text);

}  // namespace tiller::simulator::urscript
