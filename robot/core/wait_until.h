// SPDX-License-Identifier: MIT
#pragma once

// Waits for a condition by polling.

#include <algorithm>
#include <chrono>
#include <thread>

#include "robot/core/deadline.h"

namespace tiller {

/// Polls `happened` at intervals of `look`, at most 10 ms. Use it for conditions set by another process, or
/// by a thread that must not make the system call of a notification.
/// Returns  true if the condition became true before the deadline
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
