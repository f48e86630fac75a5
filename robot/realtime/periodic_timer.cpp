// SPDX-License-Identifier: MIT
#include "robot/realtime/periodic_timer.h"

#include <algorithm>
#include <thread>

#ifdef __linux__
#include <time.h>

#include <cerrno>
#endif

namespace tiller::realtime {

namespace {

// std::chrono::steady_clock is CLOCK_MONOTONIC here, which is what clock_nanosleep takes.
std::int64_t nowNs() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void sleepUntil(std::int64_t ns) {
#ifdef __linux__
    const timespec until{static_cast<time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    }
#else
    // Not run in this project's CI.
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(std::chrono::nanoseconds(ns)));
#endif
}

}  // namespace

PeriodicTimer::PeriodicTimer(std::chrono::nanoseconds period)
    : periodNs_(std::max<std::int64_t>(period.count(), 1)) {
    restart();
}

void PeriodicTimer::restart() {
    nextNs_ = nowNs() + periodNs_;
}

std::uint64_t PeriodicTimer::wait() {
    const std::int64_t now = nowNs();
    std::uint64_t missed = 0;
    if (now >= nextNs_) {
        missed = static_cast<std::uint64_t>((now - nextNs_) / periodNs_) + 1;
        nextNs_ += static_cast<std::int64_t>(missed) * periodNs_;
    }
    sleepUntil(nextNs_);
    latenessNs_ = nowNs() - nextNs_;
    nextNs_ += periodNs_;
    return missed;
}

}  // namespace tiller::realtime
