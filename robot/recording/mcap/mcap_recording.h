// SPDX-License-Identifier: MIT
#pragma once

// Opens recordings that mcapFormat() wrote, whole ones and those of a crash.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// Errors   FileNotReadable; FileCorrupt: no MCAP file, or none with robot states in it
/// Threads  any. Blocks: reads the summary of the file, or the head of every part where it has none
Result<std::unique_ptr<Recording>> openMcap(const Text& path);

}  // namespace tiller::recording
