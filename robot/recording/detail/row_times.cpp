// SPDX-License-Identifier: MIT
#include "robot/recording/detail/row_times.h"

#include <algorithm>
#include <cmath>

namespace tiller::recording {

namespace {

constexpr double kNsPerSecond = 1e9;
constexpr double kMaxDeviationNs = 1e6;  ///< half of a control period

}  // namespace

void RowTimes::add(std::int64_t utcNs, double seconds, bool follows) {
    const Mark row{rows_, utcNs, seconds};
    bool isPredicted = follows && !marks_.empty();
    if (isPredicted) {
        const Mark& mark = marks_.back();
        const double elapsedNs = static_cast<double>(utcNs - mark.utcNs);
        isPredicted = std::abs(elapsedNs - (seconds - mark.seconds) * kNsPerSecond) <= kMaxDeviationNs;
    }
    if (!isPredicted) {
        if (rows_ > 0 && last_.row != marks_.back().row) {
            marks_.push_back(last_);  // end of the constant interval
        }
        marks_.push_back(row);
    }
    last_ = row;
    ++rows_;
}

std::uint64_t RowTimes::rowsBefore(std::int64_t utcNs) const {
    if (rows_ == 0 || utcNs >= last_.utcNs) {
        return rows_;
    }
    const auto next = std::upper_bound(marks_.begin(), marks_.end(), utcNs,
                                       [](std::int64_t time, const Mark& mark) { return time < mark.utcNs; });
    if (next == marks_.begin()) {
        return 0;
    }
    const Mark& from = *(next - 1);
    const Mark& to = next == marks_.end() ? last_ : *next;
    const double share = static_cast<double>(utcNs - from.utcNs) /
                         static_cast<double>(std::max<std::int64_t>(to.utcNs - from.utcNs, 1));
    return from.row + 1 + static_cast<std::uint64_t>(share * static_cast<double>(to.row - from.row));
}

}  // namespace tiller::recording
