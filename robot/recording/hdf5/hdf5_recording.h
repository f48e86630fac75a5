// SPDX-License-Identifier: MIT
#pragma once

// Opens HDF5 files: files written by exportHdf5(), and other files with numeric data sets, also in groups,
// with one row per sample.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"
#include "robot/recording/table_format.h"

namespace tiller::recording {

/// Skips data sets that have another length or contain text; problems() reports them.
/// Data sets in groups are named with their path, e.g. "arm/force". The variables of Octave and MATLAB are
/// read with their names.
/// Errors   FileNotReadable; FileCorrupt: not an HDF5 file, or no suitable data sets; InvalidArgument:
///          `format` must contain the time column, its unit or the rate
/// Threads  one for the whole program, because libhdf5 is not thread-safe
Result<std::unique_ptr<Recording>> openHdf5(const Text& path, const TableFormat& format = {});

}  // namespace tiller::recording
