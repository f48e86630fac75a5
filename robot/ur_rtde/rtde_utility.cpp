// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/rtde_utility.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <thread>

#include "robot/platform/thread_priority.h"
#include "robot/realtime/punctual_wait.h"
#include "robot/ur_rtde/detail/waiting.h"

#ifdef __linux__
#include <sys/mman.h>
#include <sys/resource.h>
#endif

namespace ur_rtde {

namespace {

using SteadyClock = std::chrono::steady_clock;

void sleepPrecisely(SteadyClock::time_point end) {
    thread_local tiller::realtime::PunctualWait wait;
    const SteadyClock::time_point up = end - std::chrono::nanoseconds(wait.awakeNs());
    if (SteadyClock::now() < up) {
        tiller::urrtde::sleepUntil(up);
        wait.learn(std::chrono::nanoseconds(SteadyClock::now() - up).count());
    }
    while (SteadyClock::now() < end) {
    }
}

}  // namespace

std::vector<std::string> RTDEUtility::split(const std::string& s, char delimiter) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    while (begin < s.size()) {
        const std::size_t end = std::min(s.find(delimiter, begin), s.size());
        parts.push_back(s.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

bool RTDEUtility::isNumber(const std::string& s) {
    double value = 0;
    const char* begin = s.data() + (!s.empty() && s.front() == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, s.data() + s.size(), value, std::chars_format::fixed);
    return error == std::errc() && end == s.data() + s.size();
}

void RTDEUtility::preciseSleep(double seconds) {
    if (seconds > 0) {
        sleepPrecisely(SteadyClock::now() + std::chrono::duration_cast<SteadyClock::duration>(
                                                std::chrono::duration<double>(seconds)));
    }
}

void RTDEUtility::waitPeriod(const SteadyClock::time_point& t_cycle_start, double dt) {
    sleepPrecisely(t_cycle_start +
                   std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(dt)));
}

bool RTDEUtility::isRealtimeKernelAvailable() {
#ifdef _WIN32
    return true;
#else
    std::ifstream flag("/sys/kernel/realtime");
    int value = 0;
    return (flag >> value) && value == 1;
#endif
}

bool RTDEUtility::setRealtimePriority(int priority) {
#ifdef _WIN32
    // 16 ... 31 on Windows; not run in the project's CI.
    priority = priority >= 31 ? 99 : 50;
#endif
    const auto report = tiller::realtime::requestThreadPriority(priority);
#ifdef __linux__
    // Lock the memory only if its size is not limited. Otherwise, later allocations could fail.
    rlimit limit{};
    if (report.ok() && ::getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY) {
        ::mlockall(MCL_CURRENT | MCL_FUTURE);
    }
#endif
    return report.ok() && priority > 0;
}

}  // namespace ur_rtde
