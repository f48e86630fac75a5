// SPDX-License-Identifier: MIT
#pragma once

// Exports a recording in the format given by the end of the path.

#include "robot/recording/export.h"

namespace tiller::recording {

/// True if exportRecording() has a format for this path; see fileFormats().
bool canExportTo(const Text& path);
/// Writes choice.path. `style` only affects CSV.
/// Errors   InvalidArgument for other paths, and those of exportCsv(), exportHdf5() and exportMcap()
/// Threads  as exportHdf5(). Blocks: until the file is written
Result<ExportReport> exportRecording(const Recording& recording, const ExportChoice& choice,
                                     const CsvStyle& style = {});

}  // namespace tiller::recording
