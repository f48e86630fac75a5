// SPDX-License-Identifier: MIT
#pragma once

// Counts what the receive and the control loop must not do: allocate, and take a lock. A program that links
// hot_threads.cpp gets its own operator new and pthread_mutex_lock, which look at the name of the thread.

#include <cstdint>

namespace tiller::test {

struct HotCounts {
    std::uint64_t allocations = 0;
    std::uint64_t locks = 0;
};

/// From now on (or not any more) the threads named "control" and "tiller-receive" are counted.
void countHotThreads(bool on);
/// Counts the thread that calls this too.
void watchThisThread();
HotCounts hotCounts();
/// How many threads of these names there have been: a test that counts none proves nothing.
int hotThreads();

}  // namespace tiller::test
