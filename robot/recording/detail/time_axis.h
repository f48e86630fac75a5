// SPDX-License-Identifier: MIT
#pragma once

// The time of the rows of a table: finds the time column and its unit, and converts time stamps to the time
// axis of a recording.

#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/recording/recording.h"
#include "robot/recording/table_format.h"

namespace tiller::recording {

/// A column of dates is in seconds since 1970.
enum class DateKind { None, LocalTime, Utc };

struct TimeSource {
    const std::vector<RecordedColumn>& columns;
    std::span<const DateKind> dates;  ///< one per column
    std::function<Result<std::vector<double>>(std::size_t column)> values;
};

/// Finds the time column and its unit. Only names and values that have one meaning are accepted.
/// path    for errors
/// Errors  InvalidArgument with the members of TableFormat to set; the errors of source.values
Result<TimeAxis> chooseTimeAxis(const QString& path, const TimeSource& source, const TableFormat& format);

/// The times of all rows.
struct TimeLine {
    std::vector<double> seconds{};          ///< since the first row, in ascending order
    double period = 0;                      ///< median interval [s]; 0 if unknown
    std::vector<RecordedEvent> restarts{};  ///< where the time stamps run backwards, at most 100
    std::vector<RecordedGap> breaks{};      ///< one for each segment after a step back; empty for a robot
                                            ///< controller
};

/// stamps, nanoseconds  values of the columns of `axis`; empty for a column that the axis does not have
/// The time continues after a step back.
TimeLine timeLine(const TimeAxis& axis, std::span<const double> stamps, std::span<const double> nanoseconds,
                  std::size_t rows);

/// Converts an ISO 8601 date and time, such as 2026-11-27T11:15:00.25Z, to seconds since 1970. A date without
/// time is midnight.
bool parseDate(std::string_view text, double& seconds, DateKind& kind);

}  // namespace tiller::recording
