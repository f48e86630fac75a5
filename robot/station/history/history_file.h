// SPDX-License-Identifier: MIT
#pragma once

// A history backed by a long recording. Several hours of data open at once, because the summaries in the file
// are sufficient for drawing. Rows are read only when the user zooms in or when a value is requested.

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
    /// False for files without summaries and for short files, which are read faster as a whole.
    static bool benefitsFromSummaries(const recording::Recording& file);

    /// begin   time of the first row on the time axis [s]
    /// Errors  those of Recording
    static Result<std::unique_ptr<HistoryFile>> make(const recording::Recording& file, SeriesBuffer& history,
                                                     double begin);

    /// Adds columns of the file as columns of the history.
    /// Returns  their column numbers in the history, in the same order
    /// Errors   those of Recording
    Result<std::vector<int>> add(std::span<const std::size_t> fileColumns,
                                 std::span<const Precision> precisions);

    /// Adds a column computed from columns of the file. Its values are available only for rows that have been
    /// read. For all other rows, the caller must set its extents in the history, which requires reading all
    /// rows.
    /// Returns  its column number in the history
    int addComputed(const RecordedSignal& signal);

    /// Amount of work per call of sharpen().
    enum class Effort {
        Draft,  ///< reads extents of up to four pixel columns, or rows if zoomed in
        Turn,   ///< reads the next part of the missing data
    };
    /// Reads the data needed to draw these samples with this number of pixel columns.
    /// Returns  true if another call would improve the resolution
    bool sharpen(std::int64_t begin, std::int64_t end, int pixelColumns, Effort effort);

    void fill(std::int64_t block) override;
    /// Time of the first row on the time axis [s].
    double begin() const { return begin_; }
    /// The last read error; empty without an error.
    const QString& problem() const { return problem_; }

private:
    struct Column {
        int column;        ///< column of the history
        std::size_t file;  ///< column of the file
    };
    struct Computed {
        int column;  ///< column of the history
        RecordedRows rows;
    };
    HistoryFile(const recording::Recording& file, SeriesBuffer& history, double begin)
        : file_(file), history_(history), begin_(begin) {}
    std::int64_t blocks() const;
    bool isFilled(std::int64_t block) const;
    /// Releases the rows in memory. Blocks are read again, with all columns, at the next access.
    void forgetRows();
    /// The coarsest resolution of any column in this block [rows].
    std::int64_t resolutionOf(std::int64_t block) const;
    /// Reads extents of `rowsEach` rows for the blocks first ... last, up to `mostExtents` extents.
    /// Returns  true if any data were read
    bool readExtents(std::int64_t first, std::int64_t last, std::int64_t rowsEach, std::int64_t mostExtents);
    Result<void> readExtents(std::span<const Column> columns, recording::RowRange range,
                             std::int64_t rowsEach);
    Result<void> readExtentsOfRows(std::span<const Column> columns, recording::RowRange range,
                                   std::int64_t rowsEach);

    const recording::Recording& file_;
    SeriesBuffer& history_;
    double begin_;
    std::vector<Column> columns_;
    std::vector<Computed> computed_;
    std::vector<std::int64_t> levels_;  ///< available extent sizes in the file [rows], finest first
    std::list<std::int64_t> filled_;    ///< most recently used block first
    QString problem_;
};

}  // namespace tiller
