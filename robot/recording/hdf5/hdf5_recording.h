// SPDX-License-Identifier: MIT
#pragma once

// Opens HDF5 files: files written by exportHdf5(), and other files with numeric data sets at the top level,
// one row per sample.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// Data sets with a different length or with text are skipped and reported by problems().
/// Errors   FileNotReadable; FileCorrupt: not an HDF5 file, or no suitable data sets
/// Threads  one for the whole program, because libhdf5 is not thread-safe
Result<std::unique_ptr<Recording>> openHdf5(const Text& path);

}  // namespace tiller::recording
