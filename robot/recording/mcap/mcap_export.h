// SPDX-License-Identifier: MIT
#pragma once

// Exports a recording, or a part of it, as an MCAP file: one flat message per row with a float64 per column, and the
// events as log messages.

#include "robot/recording/export.h"

namespace tiller::recording {

/// Times are nanoseconds since 1970, rounded; they start at 1970 if the recording does not contain its start time.
/// Characters of column names that ROS does not allow are replaced by _. Missing packages are counted in
/// `packages_lost`.
/// Errors   FileNotWritable, DiskFull, FieldUnknown, Cancelled, and read errors
/// Blocks   until the file is written
Result<ExportReport> exportMcap(const Recording& recording, const ExportChoice& choice);

}  // namespace tiller::recording
