// SPDX-License-Identifier: MIT
#pragma once

// Opens text files with numbers: CSV files of Tiller, of ur_rtde, and of other tools. Cells are separated by
// commas, semicolons or tabs. Numbers have a decimal point or comma. A line of units may follow the header.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// Reads the whole file into memory. Cells that are not numbers become NaN, and lines with a wrong number of
/// cells are skipped. problems() reports both.
/// Errors   FileNotReadable; FileCorrupt: no header, or no line of numbers after the header
/// Threads  any. Blocks: reads the whole file
Result<std::unique_ptr<Recording>> openCsv(const Text& path);

}  // namespace tiller::recording
