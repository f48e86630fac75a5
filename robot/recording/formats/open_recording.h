// SPDX-License-Identifier: MIT
#pragma once

// Recordings of every format: opening a file, and the format that a new file is written in.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording {

/// The format is detected from the first bytes, not from the name.
/// Errors   FileNotReadable; FileCorrupt with the reason
/// Threads  any. Blocks: depends on the format
Result<std::unique_ptr<Recording>> openRecording(const Text& path);

/// The format for RecorderOptions::format by the end of the path, in capital or small letters: .csv or .mcap.
/// Errors   InvalidArgument for another end, naming both
/// Threads  any. Blocks: never
Result<std::shared_ptr<const RecordingFormat>> formatForPath(const Text& path);

}  // namespace tiller::recording
