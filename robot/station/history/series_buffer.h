// SPDX-License-Identifier: MIT
#pragma once

// The history behind the plots: one time column, and one value column per signal with levels of minima and
// maxima. The cost of a query depends on the number of pixel columns instead of the number of samples. The
// oldest samples are dropped when the age or memory limit is exceeded.
//
// The samples can also be stored in a file. Then, only summaries are in memory, and a block of rows is read
// when one of its rows is requested.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "robot/station/history/min_max.h"
#include "robot/station/history/series_column.h"

namespace tiller {

/// Assignment of samples to pixel columns. Column i holds the samples edges[i] ... edges[i + 1] - 1, which
/// satisfy start + i * width <= time < start + (i + 1) * width. Computed once per frame and shared by all
/// curves.
struct ColumnGrid {
    double start = 0;  ///< time of the left edge of column 0 [s]
    double width = 0;  ///< width of a column [s]
    std::vector<std::int64_t> edges;
    std::vector<std::uint8_t> gapBefore;  ///< samples were lost directly before a sample of this column

    std::int64_t first = 0;  ///< first(), end() and revision() of the history when the grid was computed
    std::int64_t end = 0;
    std::uint64_t revision = 0;

    int columns() const { return static_cast<int>(gapBefore.size()); }
    bool empty() const { return edges.empty() || edges.front() == edges.back(); }
};

/// Limits above which the oldest samples are dropped.
struct HistoryLimits {
    /// Half an hour plus a margin, because whole blocks are dropped.
    double seconds = 30 * 60 + 10;
    std::size_t bytes = std::size_t{1} << 30;
};

/// Source of samples whose values are not in memory.
class SampleFile {
public:
    virtual ~SampleFile() = default;
    /// Sets times and values of a block in the history: SeriesBuffer::setTimes(), setRows().
    virtual void fill(std::int64_t block) = 0;
};

/// Threads  one (GUI)
class SeriesBuffer {
public:
    explicit SeriesBuffer(int columns = 0, const HistoryLimits& limits = {});

    int columnCount() const { return static_cast<int>(columns_.size()); }
    /// Adds a signal, which has no values before the next appended row.
    /// Returns  its column number
    int addColumn(Precision precision = Precision::Single);
    const HistoryLimits& limits() const { return limits_; }
    /// Takes effect at once.
    void setLimits(const HistoryLimits& limits);
    /// Memory used by all samples [bytes].
    std::size_t memoryBytes() const;

    /// Appends one row. NaN or a missing value: the signal has no value at this time.
    /// time       [s], later than that of the previous row
    /// gapBefore  samples between this row and the previous one were lost
    /// Returns    false, without appending, if the time does not increase or is not finite
    bool append(double time, std::span<const float> values, bool gapBefore = false);
    struct Row {
        double time = 0;
        bool gapBefore = false;
    };
    /// Appends many rows by column, which is several times faster. Times must increase, and must be later
    /// than lastTime().
    /// source(column, row)  returns each value
    template <class Source>
    void appendRows(std::span<const Row> rows, Source source) {
        for (const Row& row : rows) {
            addTime(row);
        }
        for (std::size_t c = 0; c < columns_.size(); ++c) {
            columns_[c].add(rows.size(), [&source, c](std::size_t row) { return source(c, row); });
        }
        trim();
    }
    /// Replaces the values of a column for all samples by source(sample).
    template <class Source>
    void fillColumn(int column, Source source) {
        SeriesColumn filled(columns_[static_cast<std::size_t>(column)].precision());
        const std::int64_t oldest = first();
        filled.add(static_cast<std::size_t>(end_ - oldest),
                   [&](std::size_t row) { return source(oldest + static_cast<std::int64_t>(row)); });
        columns_[static_cast<std::size_t>(column)] = std::move(filled);
    }

    // Functions for a history stored in a file. Rows cannot be appended to it, and the limits do not apply.

    /// Approximate time of a sample. setTimes() sets the exact time.
    struct Mark {
        std::int64_t sample = 0;
        double time = 0;  ///< [s]
    };
    /// file   must outlive the history
    /// marks  include the first and the last sample; samples between two marks are assumed to be evenly
    ///        spaced
    /// gaps   samples directly after lost samples, ascending
    void lieIn(SampleFile& file, std::int64_t samples, std::vector<Mark> marks,
               std::vector<std::int64_t> gaps);
    /// Adds a gap before a sample. setTimes() must follow.
    void addGap(std::int64_t sample);
    bool isInFile() const { return file_ != nullptr; }
    /// Incremented when data of a history stored in a file are read.
    std::uint64_t revision() const { return revision_; }
    /// True if all values of these samples are in memory.
    bool hasRows(int column, std::int64_t begin, std::int64_t end) const;
    /// Adds a column whose values are stored in the file, see SeriesColumn.
    int outlineColumn(Precision precision);
    void setExtents(int column, std::int64_t first, std::int64_t rowsEach, std::span<const MinMax> extents);
    std::int64_t resolutionOf(int column, std::int64_t block) const {
        return columns_[static_cast<std::size_t>(column)].resolutionOf(block);
    }
    void setTimes(std::int64_t block, std::span<const double> times);
    void setRows(int column, std::int64_t block, std::span<const double> values);
    /// Releases times and values of a block.
    void forget(std::int64_t block);

    /// Samples are numbered from the first sample ever appended. first() is the oldest sample kept, end() is
    /// one past the newest.
    std::int64_t first() const { return first_; }
    std::int64_t end() const { return end_; }
    bool isEmpty() const { return end_ == 0; }
    double firstTime() const { return isEmpty() ? 0 : roughTime(first_); }
    double lastTime() const { return isEmpty() ? 0 : roughTime(end_ - 1); }

    double time(std::int64_t sample) const {
        const std::int64_t row = sample - first_;
        const auto& block = times_[static_cast<std::size_t>(row >> SeriesColumn::kBlockBits)];
        if (!block) {
            fetch(row);
        }
        return block->times[static_cast<std::size_t>(row & kInBlock)];
    }
    double value(int column, std::int64_t sample) const {
        const std::int64_t row = sample - first_;
        const SeriesColumn& values = columns_[static_cast<std::size_t>(column)];
        if (file_ != nullptr && values.resolutionOf(row >> SeriesColumn::kBlockBits) != 1) {
            fetch(row);
        }
        return values.value(row);
    }
    bool gapBefore(std::int64_t sample) const {
        if (file_ != nullptr) {
            return hasGap(sample, sample + 1);
        }
        const std::int64_t row = sample - first_;
        const auto at = static_cast<std::size_t>(row & kInBlock);
        return (times_[static_cast<std::size_t>(row >> SeriesColumn::kBlockBits)]->gaps[at / 64] >>
                    (at % 64) &
                1) != 0;
    }
    /// The first sample at or after this time, or end().
    std::int64_t lowerBound(double time) const;
    /// The last sample at or before this time, or -1.
    std::int64_t lastBefore(double time) const;

    /// Divides start ... start + columns * width into columns. If the grid already belongs to this history
    /// and has the same time raster, unchanged columns are kept, so that a scrolling view computes only the
    /// new columns.
    void cut(double start, double width, int columns, ColumnGrid& grid) const;
    /// Computes the exact minimum and maximum for each column of the grid.
    void envelope(int column, const ColumnGrid& grid, std::vector<MinMax>& out) const;
    std::vector<MinMax> envelope(int column, double t0, double t1, int columns) const;
    /// Minimum and maximum of the samples begin ... end - 1.
    MinMax minMax(int column, std::int64_t begin, std::int64_t end) const {
        return columns_[static_cast<std::size_t>(column)].minMax(begin - first_, end - first_);
    }
    /// See SeriesColumn::fetchAhead().
    void fetchAhead(int column, std::int64_t sample) const {
        columns_[static_cast<std::size_t>(column)].fetchAhead(sample - first_);
    }
    /// True if samples were lost directly before one of the samples begin ... end - 1.
    bool hasGap(std::int64_t begin, std::int64_t end) const;

private:
    static constexpr std::int64_t kInBlock = SeriesColumn::kBlockRows - 1;

    struct TimeBlock {
        std::array<double, std::size_t(SeriesColumn::kBlockRows)> times;
        std::array<std::uint64_t, std::size_t(SeriesColumn::kBlockRows) / 64> gaps;
        int gapCount;
    };

    void addTime(const Row& row);
    void trim();
    /// Approximate time of a sample from data in memory, without reading the file.
    double roughTime(std::int64_t sample) const {
        const std::int64_t row = sample - first_;
        const auto& block = times_[static_cast<std::size_t>(row >> SeriesColumn::kBlockBits)];
        return block ? block->times[static_cast<std::size_t>(row & kInBlock)] : timeByMarks(row);
    }
    double timeByMarks(std::int64_t row) const;
    void fetch(std::int64_t row) const;
    /// First sample whose approximate time is >= time, searched outwards from the guess.
    std::int64_t lowerBoundNear(double time, std::int64_t guess) const;
    std::int64_t lowerBoundBetween(double time, std::int64_t low, std::int64_t high) const;

    HistoryLimits limits_;
    std::int64_t first_ = 0;
    std::int64_t end_ = 0;
    std::vector<std::unique_ptr<TimeBlock>> times_;
    std::vector<SeriesColumn> columns_;

    SampleFile* file_ = nullptr;
    std::vector<Mark> marks_;
    std::vector<std::int64_t> gaps_;  ///< samples after gaps, for a history stored in a file
    std::uint64_t revision_ = 0;
};

}  // namespace tiller
