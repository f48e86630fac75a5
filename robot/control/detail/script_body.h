// SPDX-License-Identifier: MIT
#pragma once

// Checks the body of a user function before it becomes part of the control program.

#include <QString>

#include "robot/core/result.h"

namespace tiller::control {

/// Checks that each block in these URScript lines (def, thread, sec, if, while) is closed by its own `end`.
/// Otherwise, the body would close the enclosing function or extend beyond it, and would run without the stop
/// functions and the heartbeat check.
/// Errors   InvalidArgument with the line
Result<void> checkBlocks(const QString& body, const QString& context);

}  // namespace tiller::control
