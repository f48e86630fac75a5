// SPDX-License-Identifier: MIT
#pragma once

// Reads the values of selected signals of a recording row by row: stored columns, single bits, or computed
// signals. RecordedStretch describes a read for a worker that opens the file itself.

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

/// A signal, given by its source columns in the file.
struct RecordedSignal {
    std::vector<std::size_t> columns;  ///< columns of the file; for a computed signal its inputs, in order
    int bit = -1;                      ///< bit of the only column; -1: the whole value
    QString derivation{};              ///< expression of a computed signal; empty otherwise
};

/// Row times on the plots' time axis. They never decrease, even if a clock was set back or rows could not be
/// read.
/// seconds  times on the recording's own axis; missing rows repeat the last value
std::vector<double> axisOf(std::vector<double> seconds, double begin, std::uint64_t rows);

/// Threads  one at a time; each thread needs its own recording object
class RecordedRows {
public:
    /// file     must outlive this object
    /// begin    time of its first row on the plots' time axis [s]
    RecordedRows(const recording::Recording& file, double begin, std::vector<RecordedSignal> wanted);

    struct Rows {
        std::vector<double> times;                ///< on the plots' time axis [s]
        std::vector<std::vector<double>> values;  ///< one vector for each signal; NaN: no value
    };
    /// Errors  as for Recording
    Result<Rows> read(recording::RowRange range);

    /// Reads the rows in file order, in several steps.
    /// each    receives the rows and the number of the first row; returns false to stop
    /// Errors  as for Recording; Cancelled
    Result<void> readAll(recording::RowRange range, const CancelToken& cancel,
                         const std::function<bool(std::uint64_t first, const Rows& rows)>& each);

private:
    std::vector<double> computed(std::size_t signal, const Rows& inputs, std::uint64_t first) const;

    const recording::Recording& file_;
    double begin_;
    std::vector<RecordedSignal> signals_;
    std::vector<std::shared_ptr<DerivedSignal>> derivations_;  ///< null for signals that are not computed
    std::vector<std::size_t> columns_;                         ///< columns of the file, without duplicates
    std::vector<std::vector<std::size_t>> places_;             ///< index of each signal's columns in columns_
    double lookBack_ = -1;                                     ///< [s]; negative without computed signals
};

/// Describes a read of some signals of a recording, for a worker.
struct RecordedStretch {
    QString path;
    double begin = 0;  ///< time of the first row on the plots' time axis [s]
    recording::RowRange rows;
    std::optional<std::int64_t> startUtcNs;  ///< start of the recording; detects a replaced file
    std::size_t columns = 0;
    std::vector<RecordedSignal> wanted;

    /// Like RecordedRows::readAll(), but opens the file. Rows that cannot be read have no values, and the
    /// error is returned at the end.
    /// Errors   FileCorrupt, FileNotReadable, Cancelled
    /// Threads  any
    Result<void> readAll(
        const CancelToken& cancel,
        const std::function<bool(std::uint64_t first, const RecordedRows::Rows& rows)>& each) const;
};

}  // namespace tiller
