// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "robot/recording/recording.h"

namespace tiller::recording {

/// Limits a range to the existing rows.
inline RowRange within(RowRange range, std::uint64_t rows) {
    const std::uint64_t first = std::min(range.first, rows);
    return {first, std::min(range.count, rows - first)};
}

}  // namespace tiller::recording
