// SPDX-License-Identifier: MIT
#pragma once

// Small helpers of the ur_rtde interface: splitting text, keeping time, asking for real-time priority.

#include <ur_rtde/rtde.h>

#include <chrono>
#include <string>
#include <vector>

/// "No wish": the thread keeps the priority it has.
#define RT_PRIORITY_UNDEFINED 0

namespace ur_rtde {

class RTDEUtility {
public:
    /// The parts between delimiters; an empty last part is left out.
    static std::vector<std::string> split(const std::string& s, char delimiter);
    /// True when the whole text is one decimal number.
    static bool isNumber(const std::string& s);
    /// Sleeps, and spins for the last moments where the system wakes up too late.
    /// seconds  [s]; nothing happens when it is not positive
    static void preciseSleep(double seconds);
    /// Sleeps for what is left of a period.
    /// dt  length of the period [s]
    static void waitPeriod(const std::chrono::steady_clock::time_point& t_cycle_start, double dt);
    /// Whether the kernel says of itself that it is fully preemptible (PREEMPT_RT); true on Windows.
    static bool isRealtimeKernelAvailable();
    /// Asks real-time priority for the calling thread, and locks the program's memory where that is
    /// permitted.
    /// priority  1 ... 99, on Windows 16 ... 31
    /// Returns   whether it was granted
    static bool setRealtimePriority(int priority);
};

}  // namespace ur_rtde
