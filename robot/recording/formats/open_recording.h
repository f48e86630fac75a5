// SPDX-License-Identifier: MIT
#pragma once

// Recordings of every format: opening a file, and the format that a new file is written in.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording {

/// What it is, the first bytes tell, not the name.
/// Errors   FileNotReadable; FileCorrupt, saying what is wrong with it
/// Threads  any. Blocks: as opening that format does
Result<std::unique_ptr<Recording>> openRecording(const Text& path);

/// The format for RecorderOptions::format by the end of the path, in capital or small letters: .csv or .mcap.
/// Errors   InvalidArgument for another end, naming both
/// Threads  any. Blocks: never
Result<std::shared_ptr<const RecordingFormat>> formatForPath(const Text& path);

}  // namespace tiller::recording
