// SPDX-License-Identifier: MIT
#pragma once

// The body of a function as a caller writes it, before it becomes part of the control program.

#include <QString>

#include "robot/core/result.h"

namespace tiller::control {

/// Whether each block of these lines of URScript (def, thread, sec, if, while) is closed by an `end` of theirs. Anything
/// else would close or reach around the function they become, and run outside it: without its stops and heartbeat.
/// Errors   InvalidArgument naming the line
Result<void> checkBlocks(const QString& body, const QString& context);

}  // namespace tiller::control
