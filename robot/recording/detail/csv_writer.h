// SPDX-License-Identifier: MIT
#pragma once

// Turns samples into lines of text. Private to this room.

#include <cstdint>
#include <string>
#include <vector>

#include "robot/receive/sample.h"

namespace tiller::recording {

/// Threads  one
class CsvWriter {
public:
    /// fields  those the layout does not have are left out; timestamp is put first, the packages lost last
    /// asGiven  neither of the two is added
    CsvWriter(const receive::SampleLayout& layout, const std::vector<std::string>& fields,
              bool asGiven = false);

    /// Numbers per row without the last column.
    std::size_t columns() const { return indices_.size(); }
    const std::string& header() const { return header_; }
    /// Appends one row with its line end.
    void append(std::string& out, const receive::Sample& sample, std::uint64_t lost) const;

private:
    std::vector<std::size_t> indices_;
    std::string header_;
    bool asGiven_ = false;
};

}  // namespace tiller::recording
