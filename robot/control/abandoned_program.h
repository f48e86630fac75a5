// SPDX-License-Identifier: MIT
#pragma once

// Detects an abandoned control program, i.e. one whose client has exited or lost the connection. Such a
// program runs at standstill for up to 5 s. Taking control during this time does not interrupt the program of
// another client.

#include <array>
#include <string>

#include "robot/core/modes.h"

namespace tiller::control {

/// The control program counts the time without a client in its state register. The register keeps its last
/// value after the program has ended. Only a value that increases with robot time proves that the running
/// program is the control program.
/// Threads  one. Real-time: yes, except fields()
class AbandonedProgram {
public:
    /// RTDE output names of the state registers of both ranges.
    static std::array<std::string, 2> fields();

    /// Adds a packet from the robot. Call in the order of arrival; packets may be missing.
    /// timestamp  robot time [s]
    /// states     the values of fields(); NaN if missing
    void add(double timestamp, RuntimeState runtime, const std::array<double, 2>& states);
    void reset() { counts_ = {}; }

    /// True if, according to the newest packet, the running program is a control program at standstill that
    /// has had no client for at least 0.5 s.
    bool isRunning() const;

private:
    /// A register value that increases with robot time.
    struct Count {
        bool active = false;
        double since = 0;     ///< timestamp of the first packet [s]
        double compared = 0;  ///< timestamp of the reference packet [s]
        double newest = 0;    ///< timestamp of the newest packet [s]
        double value = 0;     ///< register value in the reference packet [s]
        double first = 0;     ///< register value in the first packet [s]
    };
    std::array<Count, 2> counts_;
};

}  // namespace tiller::control
