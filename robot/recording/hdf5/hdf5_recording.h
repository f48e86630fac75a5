// SPDX-License-Identifier: MIT
#pragma once

// Opens HDF5 files: files written by exportHdf5(), and other files with numeric data sets at the top level,
// one row per sample.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// Skips data sets that have another length or contain text; problems() reports them.
/// Errors   FileNotReadable; FileCorrupt: not an HDF5 file, or no suitable data sets
/// Threads  one for the whole program, because libhdf5 is not thread-safe
Result<std::unique_ptr<Recording>> openHdf5(const Text& path);

}  // namespace tiller::recording
