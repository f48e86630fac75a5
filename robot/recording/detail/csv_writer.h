// SPDX-License-Identifier: MIT
#pragma once

// Converts samples to lines of text. Private to robot/recording.

#include <cstdint>
#include <string>
#include <vector>

#include "robot/receive/sample.h"

namespace tiller::recording {

/// Threads  one
class CsvWriter {
public:
    /// fields   fields that are not in the layout are omitted; timestamp is added as the first column, and
    ///          the number of lost packets as the last
    /// asGiven  if true, neither timestamp nor the number of lost packets is added
    CsvWriter(const receive::SampleLayout& layout, const std::vector<std::string>& fields,
              bool asGiven = false);

    /// Numbers per row, excluding the last column.
    std::size_t columns() const { return indices_.size(); }
    const std::string& header() const { return header_; }
    /// Units of all columns, including the last one.
    const std::vector<std::string>& units() const { return units_; }
    /// Appends one row including the line end.
    void append(std::string& out, const receive::Sample& sample, std::uint64_t lost) const;

private:
    std::vector<std::size_t> indices_;
    std::string header_;
    std::vector<std::string> units_;
    bool asGiven_ = false;
};

}  // namespace tiller::recording
