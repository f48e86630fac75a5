// SPDX-License-Identifier: MIT
#pragma once

// Minimum and maximum of a signal over a range of samples.

#include <limits>

namespace tiller {

/// Without a value, min > max.
struct MinMax {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();

    bool isEmpty() const { return !(min <= max); }
    void add(const MinMax& other) {
        min = other.min < min ? other.min : min;
        max = other.max > max ? other.max : max;
    }
    /// Adds a value. NaN is ignored.
    void add(double value) {
        min = value < min ? value : min;
        max = value > max ? value : max;
    }
    friend bool operator==(const MinMax&, const MinMax&) = default;
};

}  // namespace tiller
