// SPDX-License-Identifier: MIT
#pragma once

// Exports a time range of the history as a file.

#include <QString>
#include <cstdint>
#include <vector>

#include "robot/core/result.h"

namespace tiller {

class SignalStore;

/// Signals of one recording: its own rows and times from the file, as .csv, .h5, .hdf5 or .mcap. Live signals: as
/// exportCsv().
/// t0, t1   on the plots' time axis [s]
/// Returns  rows written
/// Errors   as exportCsv() and recording::exportRecording(); Rejected if the signals have different time axes, and if
///          live signals are to be written to another file than .csv
Result<std::int64_t> exportSignals(const SignalStore& store, const std::vector<int>& shown, double t0,
                                   double t1, const QString& path);

/// Writes every sample of t0 ... t1 [s] as CSV: "timestamp", then one column per signal, named as in
/// recordings. Rows are the samples of the standard stream; additionally requested signals have the value
/// that was valid at that time. A value that the robot does not send is an empty cell; a lost sample is a
/// missing row, as in recordings.
/// Returns  number of rows written
/// Errors   FileNotWritable, DiskFull; InvalidArgument when there is no sample in the range. An existing file
/// stays unchanged on any error
Result<std::int64_t> exportCsv(const SignalStore& store, const std::vector<int>& shown, double t0, double t1,
                               const QString& path);

}  // namespace tiller
