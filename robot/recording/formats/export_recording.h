// SPDX-License-Identifier: MIT
#pragma once

// Exports a recording in the format given by the file name extension.

#include "robot/recording/export.h"

namespace tiller::recording {

/// True if exportRecording() supports the extension of this path: .csv, .h5, .hdf5 or .mcap
/// (case-insensitive).
bool canExportTo(const Text& path);
/// Writes choice.path. `style` only affects CSV.
/// Errors   InvalidArgument for other extensions, and the errors of exportCsv(), exportHdf5() and
///          exportMcap()
/// Threads  as exportHdf5(). Blocks: until the file is written
Result<ExportReport> exportRecording(const Recording& recording, const ExportChoice& choice,
                                     const CsvStyle& style = {});

}  // namespace tiller::recording
