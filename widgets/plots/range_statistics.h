// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the samples of a stretch of time have in common.

#include <cstdint>
#include <optional>

namespace tiller {

class SignalStore;

struct RangeStatistics {
    std::int64_t count = 0;  ///< samples with a value
    double min = 0;
    double max = 0;
    double mean = 0;
    double rms = 0;
    double deviation = 0;  ///< standard deviation, of the samples themselves (divided by count)
    double slope = 0;      ///< of the line that fits best [per s]; 0 for a single moment

    double peakToPeak() const { return max - min; }
};

/// Of the samples with from <= time <= to, whichever of both is earlier; nothing where there is no value.
std::optional<RangeStatistics> rangeStatistics(const SignalStore& store, int signal, double from, double to);

}  // namespace tiller
