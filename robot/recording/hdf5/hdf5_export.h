// SPDX-License-Identifier: MIT
#pragma once

// A recording as an HDF5 file for h5py, MATLAB and Octave: one data set a field, in the type the robot sent it in, one
// row a package and one column a number, with the attributes `unit` and `meaning`; `time` [s]; `gaps` with row, packets
// and seconds. Never written live: a crash would cost the whole file.

#include "robot/recording/export.h"

namespace tiller::recording {

/// Whole numbers that are missing become the greatest one of their type, and the attribute `missing` of the data set
/// says which one that is.
/// Errors   FileNotWritable, DiskFull, FieldUnknown, Cancelled, and those of reading
/// Threads  one in the program: libhdf5 is not made for more. Blocks: until it is written
Result<ExportReport> exportHdf5(const Recording& recording, const ExportChoice& choice);

}  // namespace tiller::recording
