// SPDX-License-Identifier: MIT
#pragma once

// Minimum, maximum and mean of groups of rows. Private to robot/recording.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "robot/recording/recording.h"

namespace tiller::recording {

/// Statistics of some rows of one column; NaN values are ignored.
struct Extent {
    double min = std::numeric_limits<double>::quiet_NaN();
    double max = std::numeric_limits<double>::quiet_NaN();
    double sum = 0;
    std::uint64_t numbers = 0;

    void add(double value) {
        if (std::isnan(value)) {
            return;
        }
        min = numbers == 0 ? value : std::min(min, value);
        max = numbers == 0 ? value : std::max(max, value);
        sum += value;
        ++numbers;
    }
    void add(const Extent& other) {
        if (other.numbers == 0) {
            return;
        }
        min = numbers == 0 ? other.min : std::min(min, other.min);
        max = numbers == 0 ? other.max : std::max(max, other.max);
        sum += other.sum;
        numbers += other.numbers;
    }
    double mean() const {
        return numbers == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(numbers);
    }
};

/// Processes the rows of a column in order, in chunks of any length.
class Summarizer {
public:
    Summarizer(std::uint64_t firstRow, std::uint64_t rowsEach) {
        out_.firstRow = firstRow;
        out_.rowsEach = rowsEach;
    }
    void add(std::span<const double> values) {
        for (const double value : values) {
            extent_.add(value);
            if (++rows_ == out_.rowsEach) {
                close();
            }
        }
    }
    ColumnSummary finish() {
        if (rows_ > 0) {
            close();
        }
        return std::move(out_);
    }

private:
    void close() {
        out_.min.push_back(extent_.min);
        out_.max.push_back(extent_.max);
        out_.mean.push_back(extent_.mean());
        extent_ = {};
        rows_ = 0;
    }
    ColumnSummary out_;
    Extent extent_;
    std::uint64_t rows_ = 0;
};

}  // namespace tiller::recording
