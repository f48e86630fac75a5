// SPDX-License-Identifier: MIT
#pragma once

// A stretch of the history as a file.

#include <QString>
#include <cstdint>
#include <vector>

#include "robot/core/result.h"

namespace tiller {

class SignalStore;

/// Every sample of t0 ... t1 [s] as CSV: "timestamp", then one column per signal named as in recordings. The rows
/// are those of the stream that comes anyway; what was asked for besides has the value that held then. A value the robot does not send is an empty cell; a lost sample is a missing row, as in recordings.
/// Returns  rows written
/// Errors   FileNotWritable, DiskFull; InvalidArgument when there is no sample in the range. The file that was
///          there before stays in every one of these cases
Result<std::int64_t> exportCsv(const SignalStore& store, const std::vector<int>& shown, double t0, double t1,
                               const QString& path);

}  // namespace tiller
