// SPDX-License-Identifier: MIT
#pragma once

// A long recording behind a history: hours open at once, because summaries that the file keeps are enough to draw them, and
// the rows themselves are fetched when somebody comes near or asks for a value.

#include <cstdint>
#include <list>
#include <span>
#include <vector>

#include "robot/recording/recording.h"
#include "robot/station/history/recorded_rows.h"
#include "robot/station/history/series_buffer.h"

namespace tiller {

/// Threads  GUI
class HistoryFile : public SampleFile {
public:
    /// A file that is read as a whole sooner than it is looked at piece by piece, or keeps no summaries, is not worth it.
    static bool isWorthIt(const recording::Recording& file);

    /// begin  where the first row stands on the time axis [s]
    /// Errors those of Recording
    static Result<std::unique_ptr<HistoryFile>> make(const recording::Recording& file, SeriesBuffer& history,
                                                     double begin);

    /// Columns of the file become columns of the history.
    /// Returns  their numbers there, in their order
    /// Errors   those of Recording
    Result<std::vector<int>> add(std::span<const std::size_t> fileColumns,
                                 std::span<const Precision> precisions);

    /// A column of what is computed from columns of the file. Nothing is known of it but where rows are fetched, until the
    /// history is given its extents: all rows must be read for that.
    /// Returns  its number there
    int addComputed(const RecordedSignal& signal);

    /// How much sharpen() may take.
    enum class Effort {
        Draft,  ///< what a picture needs: extents of no more samples than four columns have, or the rows of a near one
        Turn,  ///< the next piece of what is still missing
    };
    /// Fetches what is needed to draw these samples in so many pixel columns.
    /// Returns  true when another turn makes it sharper
    bool sharpen(std::int64_t begin, std::int64_t end, int pixelColumns, Effort effort);

    void fill(std::int64_t block) override;
    /// Where the first row stands on the time axis [s].
    double begin() const { return begin_; }
    /// What could not be read, the last one; empty: nothing.
    const QString& problem() const { return problem_; }

private:
    struct Column {
        int column;        ///< of the history
        std::size_t file;  ///< of the file
    };
    struct Computed {
        int column;  ///< of the history
        RecordedRows rows;
    };
    HistoryFile(const recording::Recording& file, SeriesBuffer& history, double begin)
        : file_(file), history_(history), begin_(begin) {}
    std::int64_t blocks() const;
    bool isFilled(std::int64_t block) const;
    /// Blocks get columns that have been added with the next look at them.
    void forgetRows();
    /// The coarsest grain of any column in this block.
    std::int64_t grainOf(std::int64_t block) const;
    /// Brings blocks first ... last to extents of so many rows; at most so many of them at once.
    /// Returns  true when something was read
    bool readExtents(std::int64_t first, std::int64_t last, std::int64_t rowsEach, std::int64_t mostExtents);
    Result<void> readExtents(std::span<const Column> columns, recording::RowRange range,
                             std::int64_t rowsEach);
    /// The same from the rows themselves.
    Result<void> readExtentsOfRows(std::span<const Column> columns, recording::RowRange range,
                                   std::int64_t rowsEach);

    const recording::Recording& file_;
    SeriesBuffer& history_;
    double begin_;
    std::vector<Column> columns_;
    std::vector<Computed> computed_;
    std::vector<std::int64_t> levels_;  ///< rows of an extent the file keeps, the finest first
    std::list<std::int64_t> filled_;    ///< blocks, the last used first
    QString problem_;
};

}  // namespace tiller
