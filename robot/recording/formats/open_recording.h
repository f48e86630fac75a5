// SPDX-License-Identifier: MIT
#pragma once

// One door to recordings of every format.

#include <memory>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// What it is, the first bytes tell, not the name.
/// Errors   FileNotReadable; FileCorrupt, saying what is wrong with it
/// Threads  any. Blocks: as opening that format does
Result<std::unique_ptr<Recording>> openRecording(const Text& path);

}  // namespace tiller::recording
