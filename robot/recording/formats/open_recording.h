// SPDX-License-Identifier: MIT
#pragma once

// Recordings of all formats: opens a file, and selects the format for a new file.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording {

/// The format is detected from the first bytes, not from the name.
/// Errors   FileNotReadable; FileCorrupt with the reason
/// Threads  any. Blocks: depends on the format
Result<std::unique_ptr<Recording>> openRecording(const Text& path);

/// The format for RecorderOptions::format, from the end of the path, ignoring case: .csv or .mcap.
/// Errors   InvalidArgument for other paths; the message contains these suffixes
/// Threads  any. Blocks: never
Result<std::shared_ptr<const RecordingFormat>> formatForPath(const Text& path);

}  // namespace tiller::recording
