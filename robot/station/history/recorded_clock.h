// SPDX-License-Identifier: MIT
#pragma once

// The clocks of an opened recording: time since its first row, controller time and UTC.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "robot/recording/recording.h"

namespace tiller {

class RecordedClock {
public:
    /// begin   time of the first row on the plots' time axis [s]
    /// Blocks  reads a few rows
    RecordedClock(const recording::Recording& file, double begin);

    // Times on the plots' time axis [s].
    double begin() const { return begin_; }
    /// Controller time at this time; empty if the recording does not contain time stamps of a controller.
    std::optional<double> controllerTime(double time) const;
    /// UTC at this time [ns since 1970]; empty if the recording does not contain its start.
    std::optional<std::int64_t> utcNs(double time) const;

private:
    double begin_;
    std::optional<std::int64_t> startUtcNs_;
    /// Each entry is a time on the plots' time axis and the difference between this axis and the time stamps
    /// from that time on [s]. The first entry is for the start, the others are for restarts of the
    /// controller.
    std::vector<std::pair<double, double>> clocks_;
};

}  // namespace tiller
