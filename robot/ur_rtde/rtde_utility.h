// SPDX-License-Identifier: MIT
#pragma once

// Utilities of the ur_rtde interface: splitting text, periodic waits, real-time priority.

#include <ur_rtde/rtde.h>

#include <chrono>
#include <string>
#include <vector>

/// Value for a thread that keeps its current priority.
#define RT_PRIORITY_UNDEFINED 0

namespace ur_rtde {

class RTDEUtility {
public:
    /// Splits a text at the delimiters; an empty last part is omitted.
    static std::vector<std::string> split(const std::string& s, char delimiter);
    /// True if the whole text is one decimal number.
    static bool isNumber(const std::string& s);
    /// Sleeps, then busy-waits at the end for precision.
    /// seconds  [s]; no effect if not positive
    static void preciseSleep(double seconds);
    /// Sleeps for the rest of a period.
    /// dt  length of the period [s]
    static void waitPeriod(const std::chrono::steady_clock::time_point& t_cycle_start, double dt);
    /// True on a fully preemptible kernel (PREEMPT_RT) and on Windows.
    static bool isRealtimeKernelAvailable();
    /// Requests real-time priority for the calling thread, and locks the program's memory if permitted.
    /// priority  1 ... 99, on Windows 16 ... 31
    /// Returns   whether it was granted
    static bool setRealtimePriority(int priority);
};

}  // namespace ur_rtde
