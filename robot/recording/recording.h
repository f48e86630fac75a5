// SPDX-License-Identifier: MIT
#pragma once

// A recording in a file of any format, with columns of numbers over a common time axis. Data are loaded on
// demand, so that long recordings open at once. Summaries of many rows are read from the file if available.

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace tiller::recording {

struct RecordedColumn {
    std::string name;  ///< as in the header of a CSV recording, e.g. "actual_q_0", "robot_mode"
    std::string unit;  ///< e.g. "rad"; empty: no unit, or unknown
    /// True for counts, bit fields and enumerations: exact integers whose mean is not meaningful.
    bool whole = false;
};

/// Consecutive rows, counted from 0.
struct RowRange {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

/// Packets missing before a row.
struct RecordedGap {
    std::uint64_t row = 0;      ///< first row after the gap
    std::uint64_t packets = 0;  ///< number of packets; 0 if unknown
    double seconds = 0;         ///< duration from the previous row to this one
};

/// A log line, a note, or a message of the recorder.
struct RecordedEvent {
    double seconds = 0;  ///< on the time axis of the recording; negative: before the first row
    int level = 20;      ///< as in rcl_interfaces/Log: 10 debug, 20 info, 30 warning, 40 error, 50 fatal
    QString source{};    ///< origin, e.g. "operator", "controller"; "note" for an operator's note
    QString text{};
};

/// Minimum, maximum and mean of groups of `rowsEach` consecutive rows; NaN if all values are NaN.
struct ColumnSummary {
    std::uint64_t firstRow = 0;
    std::uint64_t rowsEach = 1;  ///< the last group may be smaller
    std::vector<double> min{};
    std::vector<double> max{};
    std::vector<double> mean{};
};

/// The time of a row on the time axis.
struct TimeMark {
    std::uint64_t row = 0;
    double seconds = 0;  ///< since the first row
};

/// Threads  one at a time
/// Errors   of all calls that read data: FileNotReadable, FileCorrupt
class Recording {
public:
    virtual ~Recording() = default;

    virtual const QString& path() const = 0;
    virtual QString format() const = 0;                                 ///< "CSV", "MCAP", "HDF5"
    virtual const std::vector<RecordedColumn>& columns() const = 0;     ///< In file order.
    std::optional<std::size_t> indexOf(std::string_view column) const;  ///< Index of a column by its name.
    /// Column with the time stamps; empty if times() are not from a column.
    virtual std::optional<std::size_t> timeColumn() const;
    virtual std::uint64_t rows() const = 0;                    ///< Number of rows, without headers.
    virtual const std::vector<RecordedGap>& gaps() const = 0;  ///< In row order.
    virtual const std::vector<RecordedEvent>& events() const;  ///< In time order.
    /// Typical interval between rows [s]; 0 if unknown.
    virtual double period() const = 0;
    /// Time of the first row [ns since 1970, UTC]; empty if not in the file.
    virtual std::optional<std::int64_t> startUtcNs() const;
    /// Metadata: "model", "serial_number", "software" ...
    virtual const std::map<std::string, std::string>& facts() const;
    virtual QStringList attachments() const;
    virtual Result<QByteArray> attachment(const QString& name) const;  ///< Content of an attached file.
    /// One sentence for each part that could not be read, with the reason; empty: no problems.
    /// Reading rows may add further problems.
    virtual const QStringList& problems() const = 0;

    /// Times of these rows since the first row [s], in ascending order.
    virtual Result<std::vector<double>> times(RowRange rows) const = 0;
    /// One vector per requested column. NaN: not sent by the robot, or an empty cell.
    virtual Result<std::vector<std::vector<double>>> read(std::span<const std::size_t> columns,
                                                          RowRange rows) const = 0;
    /// Returns at least `blocks` blocks if there are enough rows, and at most sixteen times as many. The
    /// first block may begin before the range, and the last block may end after it.
    virtual Result<std::vector<ColumnSummary>> summaries(std::span<const std::size_t> columns, RowRange rows,
                                                         std::uint64_t blocks) const;
    /// Number of rows per summary for each level stored for all or most rows, finest first. Empty:
    /// summaries() reads the rows.
    virtual std::vector<std::uint64_t> summaryRows() const { return {}; }
    /// Times of some rows, including the first and the last, without reading the rows. Accurate to a few
    /// milliseconds. Rows between two marks are evenly spaced unless packets are missing.
    virtual Result<std::vector<TimeMark>> timeMarks() const;
    /// The last row at or before this time; 0 before the first row.
    virtual Result<std::uint64_t> rowAt(double seconds) const;
    /// Rows whose values and times could not be read because the file is damaged. Reading rows may add
    /// further ranges.
    virtual const std::vector<RowRange>& unreadable() const;
};

}  // namespace tiller::recording
