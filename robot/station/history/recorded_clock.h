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
    /// Controller time [s]; empty if the recording does not contain time stamps of a controller.
    std::optional<double> controllerTime(double time) const;
    /// UTC [ns since 1970]; empty if the recording does not contain its start time.
    std::optional<std::int64_t> utcNs(double time) const;

private:
    double begin_;
    std::optional<std::int64_t> startUtcNs_;
    /// Times on the plots' time axis, each with the difference between the axis and the time stamps that
    /// follow [s]. The first entry is the start of the recording; later entries are restarts of the
    /// controller.
    std::vector<std::pair<double, double>> clocks_;
};

}  // namespace tiller
