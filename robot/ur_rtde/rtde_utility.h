// SPDX-License-Identifier: MIT
#pragma once

// Utilities of the ur_rtde interface: text splitting, periodic waits, real-time priority.

#include <ur_rtde/rtde.h>

#include <chrono>
#include <string>
#include <vector>

/// Priority value that keeps the current priority of a thread.
#define RT_PRIORITY_UNDEFINED 0

namespace ur_rtde {

class RTDEUtility {
public:
    /// Splits text at the delimiters. An empty last part is omitted.
    static std::vector<std::string> split(const std::string& s, char delimiter);
    /// True if the whole text is a decimal number.
    static bool isNumber(const std::string& s);
    /// Sleeps, and then busy-waits for the last part.
    /// seconds  [s]; no effect if not positive
    static void preciseSleep(double seconds);
    /// Sleeps for the rest of a period.
    /// dt  duration of the period [s]
    static void waitPeriod(const std::chrono::steady_clock::time_point& t_cycle_start, double dt);
    /// True on a fully preemptible kernel (PREEMPT_RT) and on Windows.
    static bool isRealtimeKernelAvailable();
    /// Requests real-time priority for the calling thread, and locks the program's memory if permitted.
    /// priority  1 ... 99, on Windows 16 ... 31
    /// Returns   true if the priority was granted
    static bool setRealtimePriority(int priority);
};

}  // namespace ur_rtde
