// SPDX-License-Identifier: MIT
#pragma once

// Computes summaries of 32, 128, 512 ... rows of all columns during recording. Private to
// robot/recording/mcap.

#include <functional>
#include <span>
#include <vector>

#include "robot/recording/detail/summarize.h"
#include "robot/recording/mcap/ros_messages.h"

namespace tiller::recording::mcap {

inline constexpr std::uint32_t kFinestSummary = 32;
inline constexpr std::uint32_t kCoarserBy = 4;
inline constexpr std::size_t kSummaryLevels = 8;  ///< coarsest: 524 288 rows, 17 minutes at 500 Hz

constexpr std::uint32_t rowsOfLevel(std::size_t level) {
    std::uint32_t rows = kFinestSummary;
    for (std::size_t i = 0; i < level; ++i) {
        rows *= kCoarserBy;
    }
    return rows;
}

/// Threads  one
class SummaryLevels {
public:
    /// sink  called for each complete summary, with its level
    SummaryLevels(std::size_t columns, std::function<void(std::size_t, const SummaryMessage&)> sink)
        : sink_(std::move(sink)), levels_(kSummaryLevels) {
        for (Level& level : levels_) {
            level.extents.resize(columns);
        }
    }
    /// value(i)  value of column i in this row
    template <class Value>
    void addRow(Value value) {
        Level& finest = levels_.front();
        for (std::size_t i = 0; i < finest.extents.size(); ++i) {
            finest.extents[i].add(value(i));
        }
        if (++finest.rows == kFinestSummary) {
            close(0);
        }
    }
    /// Completes the current summary of every level.
    void finish() {
        for (std::size_t level = 0; level < kSummaryLevels; ++level) {
            if (levels_[level].rows > 0) {
                close(level);
            }
        }
    }

private:
    struct Level {
        std::vector<Extent> extents;
        std::uint64_t firstRow = 0;
        std::uint32_t rows = 0;
    };

    void close(std::size_t number) {
        Level& level = levels_[number];
        SummaryMessage message;
        message.firstRow = level.firstRow;
        message.rowsEach = level.rows;
        for (const Extent& extent : level.extents) {
            message.min.push_back(extent.min);
            message.max.push_back(extent.max);
            message.mean.push_back(extent.mean());
        }
        sink_(number, message);
        if (number + 1 < kSummaryLevels) {
            Level& coarser = levels_[number + 1];
            for (std::size_t i = 0; i < level.extents.size(); ++i) {
                coarser.extents[i].add(level.extents[i]);
            }
            coarser.rows += level.rows;
            if (coarser.rows == rowsOfLevel(number + 1)) {
                close(number + 1);
            }
        }
        level.firstRow += level.rows;
        level.rows = 0;
        for (Extent& extent : level.extents) {
            extent = {};
        }
    }

    std::function<void(std::size_t, const SummaryMessage&)> sink_;
    std::vector<Level> levels_;
};

}  // namespace tiller::recording::mcap
