// SPDX-License-Identifier: MIT
#pragma once

// Exports a time range of the history as a file.

#include <QString>
#include <cstdint>
#include <vector>

#include "robot/core/result.h"

namespace tiller {

class SignalStore;

/// A note in the plots.
struct HistoryNote {
    double time = 0;         ///< on the plots' time axis [s]
    std::int64_t utcNs = 0;  ///< [ns since 1970]; 0: unknown
    QString text;
};

/// For signals of one recording, writes the rows and times of its file as .csv, .h5, .hdf5 or .mcap. For live
/// signals, see exportCsv().
/// t0, t1   times on the plots' time axis [s]
/// notes    notes of the signals' recording or of the live data. Notes in the range are exported, together
///          with those in the file of the recording
/// Returns  number of rows written
/// Errors   as for exportCsv() and recording::exportRecording(); Rejected if the signals have different time
///          axes, if the range contains too many values, or if the format for live signals is not .csv
Result<std::int64_t> exportSignals(const SignalStore& store, const std::vector<int>& shown, double t0,
                                   double t1, const QString& path,
                                   const std::vector<HistoryNote>& notes = {});

/// Writes every sample of t0 ... t1 [s] as CSV: "timestamp" of the controller, then one column per signal,
/// named as in recordings. Each row is a sample of the standard stream. For an additionally requested signal,
/// the cell contains the last valid value at the time of the row. A value that the robot does not send is an
/// empty cell. A lost sample is a missing row, as in recordings. Notes are written to a second file, as by
/// recording::writeCsvNotes().
/// Returns  number of rows written
/// Errors   FileNotWritable, DiskFull; InvalidArgument if there is no sample in the range; Rejected if the
///          samples are of different robots. An existing file is unchanged after an error
Result<std::int64_t> exportCsv(const SignalStore& store, const std::vector<int>& shown, double t0, double t1,
                               const QString& path, const std::vector<HistoryNote>& notes = {});

}  // namespace tiller
