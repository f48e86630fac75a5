// SPDX-License-Identifier: MIT
#pragma once

// Opens recordings of all formats.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// The format is detected from the first bytes, not from the name.
/// Errors   FileNotReadable; FileCorrupt with the reason
/// Threads  any. Blocks: depends on the format
Result<std::unique_ptr<Recording>> openRecording(const Text& path);

}  // namespace tiller::recording
