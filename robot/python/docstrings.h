// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace tiller::python {

/// What help() says about "Class" or "Class.method"; empty when there is no such entry.
const char* docstring(std::string_view name);

}  // namespace tiller::python
