// SPDX-License-Identifier: MIT
#pragma once

// Opens recordings written by mcapFormat(), including files left incomplete by a crash.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// Errors   FileNotReadable; FileCorrupt: not an MCAP file, or no robot states in it
/// Threads  any. Blocks: reads the summary of the file, or all record headers if there is none
Result<std::unique_ptr<Recording>> openMcap(const Text& path);

}  // namespace tiller::recording
