// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace tiller::python {

/// Returns the text for help() of "Class" or "Class.method"; empty if there is no entry.
const char* docstring(std::string_view name);

}  // namespace tiller::python
