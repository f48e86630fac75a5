// SPDX-License-Identifier: MIT
#include "robot/platform/sleep.h"

#ifdef __linux__
#include <time.h>

#include <cerrno>
#else
#include <chrono>
#include <thread>
#endif

namespace tiller {

void sleepUntilNs(std::int64_t until) {
#ifdef __linux__
    // std::chrono::steady_clock is CLOCK_MONOTONIC on Linux.
    constexpr std::int64_t kNsInSecond = 1'000'000'000;
    const timespec time{static_cast<time_t>(until / kNsInSecond), static_cast<long>(until % kNsInSecond)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
    }
#else
    // This code is not run in the project's CI.
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(std::chrono::nanoseconds(until)));
#endif
}

}  // namespace tiller
