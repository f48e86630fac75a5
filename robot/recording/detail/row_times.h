// SPDX-License-Identifier: MIT
#pragma once

// The reception times of the rows of a recording, compressed, to find the row of a note.

#include <cstdint>
#include <vector>

namespace tiller::recording {

class RowTimes {
public:
    /// Adds a row.
    /// seconds  time stamp of the controller; not a number if unknown
    /// follows  false if packets are missing before the row
    void add(std::int64_t utcNs, double seconds, bool follows);
    /// Number of rows that were received before this time.
    std::uint64_t rowsBefore(std::int64_t utcNs) const;

private:
    /// A row whose time does not follow from the mark before it. Between two marks, the interval of the rows
    /// is constant.
    struct Mark {
        std::uint64_t row;
        std::int64_t utcNs;
        double seconds;
    };
    std::vector<Mark> marks_;
    Mark last_{};  ///< the last row
    std::uint64_t rows_ = 0;
};

}  // namespace tiller::recording
