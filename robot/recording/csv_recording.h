// SPDX-License-Identifier: MIT
#pragma once

// Opens text files of numbers: ours, those of ur_rtde, and what other tools write: cells between commas, semicolons or
// tabs, numbers with a decimal point or comma, a line of units under the heading.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// Reads the whole file into memory. Cells that are no numbers become NaN, lines with too few or too many cells are
/// left out, and problems() says so.
/// Errors   FileNotReadable; FileCorrupt: there is no heading, or no line of numbers under it
/// Threads  any. Blocks: reads the whole file
Result<std::unique_ptr<Recording>> openCsv(const Text& path);

}  // namespace tiller::recording
