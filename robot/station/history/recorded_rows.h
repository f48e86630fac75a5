// SPDX-License-Identifier: MIT
#pragma once

// The values of some signals of a recording, row by row, for whoever goes through many of them: as the file has them, a bit
// of them, or computed from them. What it takes to read them can be given to a worker, which opens the file for itself.

#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "robot/core/deadline.h"
#include "robot/recording/recording.h"
#include "robot/station/history/derived_signal.h"
#include "robot/station/history/series_buffer.h"

namespace tiller {

/// A signal, as what it is made from in the file.
struct RecordedSignal {
    std::vector<std::size_t> columns;  ///< of the file; of what is computed the inputs, in their order
    int bit = -1;                      ///< of the only column; -1: all of it
    QString derivation{};              ///< the text of what is computed; empty: nothing is
};

/// Times of rows as they stand on the plots' axis: never back, neither for a clock that was set back nor for what could not
/// be read.
/// seconds  of the recording's own axis; rows that lack follow the last one
std::vector<double> axisOf(std::vector<double> seconds, double begin, std::uint64_t rows);

/// Threads  one at a time; a recording of its own for each
class RecordedRows {
public:
    /// file     must outlive it
    /// begin    where its first row stands on the plots' time axis [s]
    RecordedRows(const recording::Recording& file, double begin, std::vector<RecordedSignal> wanted);

    struct Rows {
        std::vector<double> times;                ///< on the plots' time axis [s]
        std::vector<std::vector<double>> values;  ///< one vector for each signal; NaN: no value
    };
    /// Errors  those of Recording
    Result<Rows> read(recording::RowRange range);

    /// Reads rows in the order they lie in, some at a time.
    /// each    takes them, with the number of the first one; false: enough
    /// Errors  those of Recording; Cancelled
    Result<void> readAll(recording::RowRange range, const CancelToken& cancel,
                         const std::function<bool(std::uint64_t first, const Rows& rows)>& each);

private:
    std::vector<double> computed(std::size_t signal, const Rows& inputs, std::uint64_t first) const;

    const recording::Recording& file_;
    double begin_;
    std::vector<RecordedSignal> signals_;
    std::vector<std::shared_ptr<DerivedSignal>> derivations_;  ///< null: it is not computed
    std::vector<std::size_t> columns_;                         ///< of the file, each once
    std::vector<std::vector<std::size_t>> places_;             ///< of each signal's columns in those
    double lookBack_ = -1;                                     ///< [s]; negative: nothing is computed
};

/// What a worker needs to read signals of a recording.
struct RecordedStretch {
    QString path;
    double begin = 0;  ///< where the first row stands on the plots' time axis [s]
    recording::RowRange rows;
    std::optional<std::int64_t>
        startUtcNs;  ///< and columns: of the file that is meant, not of one that took its place
    std::size_t columns = 0;
    std::vector<RecordedSignal> wanted;

    /// As RecordedRows::readAll(); opens the file. Rows that cannot be read have no values, and are told in the end.
    /// Errors   FileCorrupt, FileNotReadable, Cancelled
    /// Threads  any
    Result<void> readAll(
        const CancelToken& cancel,
        const std::function<bool(std::uint64_t first, const RecordedRows::Rows& rows)>& each) const;
};

}  // namespace tiller
