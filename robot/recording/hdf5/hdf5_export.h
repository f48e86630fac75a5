// SPDX-License-Identifier: MIT
#pragma once

// Exports a recording as an HDF5 file for h5py, MATLAB and Octave. The file contains one data set per field
// in the type sent by the robot, with one row per packet, one column per component, and the attributes
// `unit` and `meaning`. It also contains `time` [s], and `gaps` with row, packets and seconds. If there are
// notes, warnings or errors, the group `notes` contains one data set each for their `time` [s], `level`,
// `source` and `text`. HDF5 is not used for live recording, because a crash would destroy the whole file.

#include "robot/recording/export.h"

namespace tiller::recording {

/// Missing integers have the maximum value of their type (UINT64: 2^53 - 1), which is stored in the attribute
/// `missing` of the data set.
/// Errors   FileNotWritable, DiskFull, FieldUnknown, Cancelled, and read errors
/// Threads  one for the whole program, because libhdf5 is not thread-safe. Blocks: until the file is written
Result<ExportReport> exportHdf5(const Recording& recording, const ExportChoice& choice);

}  // namespace tiller::recording
