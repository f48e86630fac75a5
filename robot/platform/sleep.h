// SPDX-License-Identifier: MIT
#pragma once

// Sleeps without a busy wait, as precisely as the system can.

#include <cstdint>

namespace tiller {

/// until    time of std::chrono::steady_clock [ns]
/// Threads  any. Blocks: until that time or later
void sleepUntilNs(std::int64_t until);

}  // namespace tiller
