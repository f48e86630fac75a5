// SPDX-License-Identifier: MIT
#pragma once

// Opens HDF5 files: those of exportHdf5(), and others whose data sets at the top are numbers, one row a moment.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// Data sets of another length than most, or of texts, are left out, and problems() says so.
/// Errors   FileNotReadable; FileCorrupt: no HDF5 file, or none with data sets like that
/// Threads  one in the program: libhdf5 is not made for more
Result<std::unique_ptr<Recording>> openHdf5(const Text& path);

}  // namespace tiller::recording
