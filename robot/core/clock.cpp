// SPDX-License-Identifier: MIT
#include "robot/core/clock.h"

#include <thread>

#ifdef __linux__
#include <time.h>

#include <cerrno>
#endif

namespace tiller {

void SteadyClock::sleepUntil(std::int64_t ns) {
#ifdef __linux__
    // std::chrono::steady_clock is CLOCK_MONOTONIC on Linux.
    const timespec until{static_cast<time_t>(ns / kNsPerSecond), static_cast<long>(ns % kNsPerSecond)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    }
#else
    // This code is not run in the project's CI.
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(std::chrono::nanoseconds(ns)));
#endif
}

void SteadyClock::waitUntil(std::int64_t ns, std::int64_t awakeNs) const {
    if (ns - nowNs() > awakeNs) {
        sleepUntil(ns - awakeNs);
    }
    while (nowNs() < ns) {
    }
}

}  // namespace tiller
