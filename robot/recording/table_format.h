// SPDX-License-Identifier: MIT
#pragma once

// Describes how to read a table of numbers that another program may have written.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace tiller::recording {

enum class TimeUnit { Seconds, Milliseconds, Microseconds, Nanoseconds };

/// Seconds per unit.
constexpr double secondsPer(TimeUnit unit) {
    switch (unit) {
        case TimeUnit::Milliseconds:
            return 1e-3;
        case TimeUnit::Microseconds:
            return 1e-6;
        case TimeUnit::Nanoseconds:
            return 1e-9;
        default:
            return 1;
    }
}

/// Members without a value are detected from the file. If they cannot be detected with certainty, opening the
/// file fails with an error that names the members to set. MCAP files need none of the members.
struct TableFormat {
    /// Name of the time column; an empty name: the table has no time column, and `rate` is required. The
    /// column of seconds of a pair such as secs and nsecs selects both columns.
    std::optional<std::string> timeColumn{};
    std::optional<TimeUnit> timeUnit{};
    /// Comma, semicolon, tab, vertical bar, or blank for any number of blanks. Applies only to text files.
    std::optional<char> separator{};
    std::optional<char> decimal{};    ///< point or comma; only for text files
    std::optional<bool> hasHeader{};  ///< only for text files; without a header, columns are "column 1", ...
    double rate = 0;                  ///< rows per second of a table without time [Hz]; 0: unknown

    bool operator==(const TableFormat&) const = default;
};

/// Row times of a table that was read.
struct TimeAxis {
    std::optional<std::size_t> column{};       ///< empty: rows are 1/rate apart
    std::optional<std::size_t> nanoseconds{};  ///< column with the nanoseconds of a time in whole seconds
    double factor = 1;                         ///< seconds per unit of the column
    double rate = 0;                           ///< [Hz]; only without a column
    bool isController = false;                 ///< time stamps of a robot controller, which restart at zero
    std::optional<std::int64_t> startUtcNs{};  ///< time of the first row [ns since 1970]
};

}  // namespace tiller::recording
