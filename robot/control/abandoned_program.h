// SPDX-License-Identifier: MIT
#pragma once

// Detects a control program without a client: its process has ended, or its connection is lost. Such a program keeps
// playing at standstill for up to 5 s. No other program is interrupted when control is taken during this time.

#include <array>
#include <string>

#include "robot/core/modes.h"

namespace tiller::control {

/// The control program counts the time without a client in its state register. The register keeps its last value after
/// the program has ended, so only a number that grows with the robot's own time proves that the running program is the
/// control program.
/// Threads  one. Real-time: yes, except fields()
class AbandonedProgram {
public:
    /// The state registers of both ranges, as names of RTDE outputs.
    static std::array<std::string, 2> fields();

    /// Adds a package from the robot, in the order of arrival; packages may be missing.
    /// timestamp  of the robot [s]
    /// states     the values of fields(); NaN if missing
    void add(double timestamp, RuntimeState runtime, const std::array<double, 2>& states);
    void reset() { counts_ = {}; }

    /// True if the program that runs according to the newest package is a control program that has had no client for
    /// at least half a second and is at standstill.
    bool isRunning() const;

private:
    /// A number that grows with the robot's time.
    struct Count {
        bool active = false;
        double since = 0;     ///< time stamps [s]: of the first package,
        double compared = 0;  ///< of the package that the newest one is compared with,
        double newest = 0;    ///< and of the newest one
        double value = 0;     ///< in the compared package [s]
    };
    std::array<Count, 2> counts_;
};

}  // namespace tiller::control
