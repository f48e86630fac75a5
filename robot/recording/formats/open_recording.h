// SPDX-License-Identifier: MIT
#pragma once

// Opens recordings of all formats, and selects the format for a new file.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"
#include "robot/recording/recording_format.h"
#include "robot/recording/table_format.h"

namespace tiller::recording {

/// Opens a recording. The format is detected from the first bytes of the file.
/// format   for tables that other programs wrote
/// Errors   FileNotReadable; FileCorrupt with the reason; InvalidArgument with the members of `format` that
///          the file needs
/// Threads  any. Blocks: depends on the format
Result<std::unique_ptr<Recording>> openRecording(const Text& path, const TableFormat& format = {});

/// Format for RecorderOptions::format, selected by the extension of the path (case-insensitive), from the
/// rows of fileFormats() that a recorder can write.
/// Errors   InvalidArgument for other extensions; the message contains the supported extensions
/// Threads  any. Blocks: never
Result<std::shared_ptr<const RecordingFormat>> formatForPath(const Text& path);

}  // namespace tiller::recording
