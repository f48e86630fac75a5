// SPDX-License-Identifier: MIT
#pragma once

// Opens text files with numbers: CSV files of Tiller, of ur_rtde, and of other tools. Cells are separated by
// commas, semicolons, tabs, vertical bars or blanks. Numbers have a decimal point or comma. Lines that begin
// with # are comments; the last one before the numbers may be the header, and "# name: value" is metadata. A
// line of units may follow the header. The first row of a file without a header is data. Time stamps are
// numbers or ISO 8601 dates.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"
#include "robot/recording/table_format.h"

namespace tiller::recording {

/// Reads the whole file into memory. Cells that are not numbers become NaN, and lines with a wrong number of
/// cells are skipped. problems() reports both.
/// Errors   FileNotReadable; FileCorrupt: no header, or no line of numbers after the header; InvalidArgument:
///          `format` must contain what cannot be detected in the file, e.g. the time column, its unit or the
///          separator
/// Threads  any. Blocks: reads the whole file
Result<std::unique_ptr<Recording>> openCsv(const Text& path, const TableFormat& format = {});

}  // namespace tiller::recording
