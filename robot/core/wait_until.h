// SPDX-License-Identifier: MIT
#pragma once

// Waiting for what nobody announces.

#include <algorithm>
#include <chrono>
#include <thread>

#include "robot/core/deadline.h"

namespace tiller {

/// Waits for what happens in a thread that must not ring a bell, because it makes no system call for others, or
/// in another program: by looking every `look`.
/// Returns  whether it happened before the deadline
template <class Happened>
bool waitUntil(const Deadline& deadline, Happened happened,
               std::chrono::nanoseconds look = std::chrono::milliseconds(1)) {
    while (!happened()) {
        if (deadline.hasExpired()) {
            return false;
        }
        std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(deadline.nextPoll(), look));
    }
    return true;
}

}  // namespace tiller
