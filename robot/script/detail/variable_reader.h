// SPDX-License-Identifier: MIT
#pragma once

// Reads the packages with the global variables of the program. Private to robot/script.

#include <cstdint>
#include <span>

#include "robot/core/version.h"
#include "robot/script/program_variables.h"

namespace tiller::script {

/// Applies the body of a package of type 25 to the variables: names, or values.
/// Returns  false if the package does not follow the protocol; the variables are then unchanged
/// Source   client interface manual, "Global variables"
bool readVariables(std::span<const std::uint8_t> body, const SoftwareVersion& version,
                   ProgramVariables& variables);

}  // namespace tiller::script
