// SPDX-License-Identifier: MIT
#pragma once

// Opens recordings of all formats, and selects the format of a new file.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording {

/// The format is detected from the first bytes, not from the name.
/// Errors   FileNotReadable; FileCorrupt with the reason
/// Threads  any. Blocks: depends on the format
Result<std::unique_ptr<Recording>> openRecording(const Text& path);

/// The format for RecorderOptions::format, selected by the extension (case is ignored): .csv or .mcap.
/// Errors   InvalidArgument for other extensions
/// Threads  any. Blocks: never
Result<std::shared_ptr<const RecordingFormat>> formatForPath(const Text& path);

}  // namespace tiller::recording
