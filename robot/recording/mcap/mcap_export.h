// SPDX-License-Identifier: MIT
#pragma once

// Exports a recording, or a part of it, as an MCAP file with one flat message per row, a float64 per column,
// and the events as log messages.

#include "robot/recording/export.h"

namespace tiller::recording {

/// Times are rounded to nanoseconds since 1970. If the recording does not contain its start time, the times
/// start at 0. Characters that ROS does not permit in column names are replaced by _. `packages_lost`
/// contains the number of missing packets.
/// Errors   FileNotWritable, DiskFull, FieldUnknown, Cancelled, and read errors
/// Blocks   until the file is written
Result<ExportReport> exportMcap(const Recording& recording, const ExportChoice& choice);

}  // namespace tiller::recording
