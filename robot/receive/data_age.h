// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace tiller::receive {

/// Maximum age of data that show what the robot is doing now. If the newest packet is older, the robot's
/// modes, programs and motion are unknown, and motions of a Controller end.
inline constexpr std::chrono::milliseconds kMaxDataAge{100};

}  // namespace tiller::receive
