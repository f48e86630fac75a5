// SPDX-License-Identifier: MIT
#pragma once

// Counts allocations and locks in the receive and control loops. A program that links hot_threads.cpp gets
// replacements of operator new and pthread_mutex_lock that check the name of the thread.

#include <cstdint>

namespace tiller::test {

struct HotCounts {
    std::uint64_t allocations = 0;
    std::uint64_t locks = 0;
};

/// Starts or stops counting for the threads named "control" and "tiller-receive".
void countHotThreads(bool on);
/// Also counts the calling thread.
void watchThisThread();
HotCounts hotCounts();
/// Number of threads with these names so far. Without such threads, a test would prove nothing.
int hotThreads();

}  // namespace tiller::test
