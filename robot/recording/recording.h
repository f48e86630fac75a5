// SPDX-License-Identifier: MIT
#pragma once

// A recording that lies in a file, whatever its format: columns of numbers over one time axis. What is looked at is
// fetched when it is asked for, so hours open at once; summaries of many rows come from the file where it keeps
// them.

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
    std::string name;  ///< "actual_q_0", "robot_mode", as in the heading of a CSV recording
    std::string unit;  ///< "rad"; empty: none, or not known
    /// Counts, bits and enumerations: exact whole numbers, of which a mean says nothing.
    bool whole = false;
};

/// Neighbouring rows, counted from 0.
struct RowRange {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

/// Packages that are missing just before a row.
struct RecordedGap {
    std::uint64_t row = 0;      ///< the first one after it
    std::uint64_t packets = 0;  ///< how many; 0 where the file does not say
    double seconds = 0;         ///< from the row before to this one
};

/// A line of the log, a note, or what the recorder has to say.
struct RecordedEvent {
    double seconds = 0;  ///< on the time axis of the recording; negative: before its first row
    int level = 20;      ///< as in rcl_interfaces/Log: 10 debug, 20 info, 30 warning, 40 error, 50 fatal
    QString source{};    ///< who said it: "operator", "controller" ...
    QString text{};
};

/// Least, greatest and mean value of each `rowsEach` neighbouring rows; NaN where all of them are.
struct ColumnSummary {
    std::uint64_t firstRow = 0;
    std::uint64_t rowsEach = 1;  ///< the last one may be of fewer
    std::vector<double> min{};
    std::vector<double> max{};
    std::vector<double> mean{};
};

/// When a row was sent.
struct TimeMark {
    std::uint64_t row = 0;
    double seconds = 0;  ///< from the first row
};

/// Threads  one at a time. Errors of every call that reads: FileNotReadable, FileCorrupt
class Recording {
public:
    virtual ~Recording() = default;

    virtual const QString& path() const = 0;                            ///< Of the file.
    virtual QString format() const = 0;                                 ///< "CSV", "MCAP", "HDF5"
    virtual const std::vector<RecordedColumn>& columns() const = 0;     ///< In the order of the file.
    std::optional<std::size_t> indexOf(std::string_view column) const;  ///< Of a column by its name.
    virtual std::uint64_t rows() const = 0;                             ///< Without headings.
    virtual const std::vector<RecordedGap>& gaps() const = 0;           ///< In the order of their rows.
    virtual const std::vector<RecordedEvent>& events() const;           ///< In the order of time.
    /// Between neighbouring rows as a rule [s]; 0 when not known.
    virtual double period() const = 0;
    /// When the first row was sent [ns since 1970, UTC]; nothing where the file does not say.
    virtual std::optional<std::int64_t> startUtcNs() const;
    /// What was written about it: "model", "serial_number", "software" ...
    virtual const std::map<std::string, std::string>& facts() const;
    virtual QStringList attachments() const;                           ///< Names of the files inside it.
    virtual Result<QByteArray> attachment(const QString& name) const;  ///< What is in one of them.
    /// What could not be read, and why, a sentence each; empty: all of it was.
    virtual const QStringList& problems() const = 0;

    /// Seconds from the first row, which never run backwards, of rows that exist.
    virtual Result<std::vector<double>> times(RowRange rows) const = 0;
    /// One vector for each column asked for. NaN: the robot did not send it, or the cell is empty.
    virtual Result<std::vector<std::vector<double>>> read(std::span<const std::size_t> columns,
                                                          RowRange rows) const = 0;
    /// At least `blocks` blocks if there are so many rows, and not more than sixteen times as many. The first may begin
    /// before the range and the last end after it, where the file has them so.
    virtual Result<std::vector<ColumnSummary>> summaries(std::span<const std::size_t> columns, RowRange rows,
                                                         std::uint64_t blocks) const;
    /// How many rows each summary has that the file keeps of all or most rows, the finest first; empty: summaries() reads
    /// the rows.
    virtual std::vector<std::uint64_t> summaryRows() const { return {}; }
    /// When some of the rows were sent, the first and the last among them, as the file knows it without being read: to a
    /// few milliseconds. Between two of them rows come evenly, unless some are missing.
    virtual Result<std::vector<TimeMark>> timeMarks() const;
    /// The last row at or before a moment of the time axis; 0 before the first row.
    virtual Result<std::uint64_t> rowAt(double seconds) const;
};

}  // namespace tiller::recording
