// SPDX-License-Identifier: MIT
#include "robot/recording/detail/time_axis.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <string>

#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/detail/restart_note.h"

namespace tiller::recording {

namespace {

// In a table that is not sorted by time, about every second row is earlier than the previous row.
constexpr std::size_t kMaxRestarts = 100;
// Number of intervals used to determine the typical interval.
constexpr std::size_t kStepsForPeriod = 1000;

// Values in this range are a time since 1970 in seconds, milliseconds, microseconds or nanoseconds: the
// ranges do not overlap, and the time since the start of a device is below them for 11 days.
constexpr double kFirstEpoch = 978'307'200;   // 2001
constexpr double kLastEpoch = 4'102'444'800;  // 2100
// With a longer interval, a count of milliseconds could be a count of nanoseconds since the start.
constexpr double kMaxEpochStep = 60;  // [s]

std::string lowered(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return out;
}

std::string_view stripped(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

template <std::size_t N>
bool isOneOf(std::string_view text, const std::array<std::string_view, N>& words) {
    return std::find(words.begin(), words.end(), text) != words.end();
}

std::optional<double> factorOf(std::string_view unit) {
    constexpr std::array<std::string_view, 6> kSeconds{"s", "sec", "secs", "second", "seconds", "sekunden"};
    constexpr std::array<std::string_view, 6> kMilli{"ms",     "msec",        "msecs",
                                                     "millis", "millisecond", "milliseconds"};
    // With the micro sign, and with the Greek letter mu.
    constexpr std::array<std::string_view, 8> kMicro{"us",    "\xC2\xB5s", "\xCE\xBCs",   "usec",
                                                     "usecs", "micros",    "microsecond", "microseconds"};
    constexpr std::array<std::string_view, 8> kNano{"ns",      "nsec",     "nsecs",      "nanos",
                                                    "nanosec", "nanosecs", "nanosecond", "nanoseconds"};
    return isOneOf(unit, kSeconds) ? std::optional(1.0)
           : isOneOf(unit, kMilli) ? std::optional(1e-3)
           : isOneOf(unit, kMicro) ? std::optional(1e-6)
           : isOneOf(unit, kNano)  ? std::optional(1e-9)
                                   : std::nullopt;
}

bool isTimeName(std::string_view name) {
    constexpr std::array<std::string_view, 31> kNames{"time",
                                                      "t",
                                                      "timestamp",
                                                      "time_stamp",
                                                      "time stamp",
                                                      "stamp",
                                                      "ts",
                                                      "elapsed",
                                                      "elapsed_time",
                                                      "elapsed time",
                                                      "time since start",
                                                      "datetime",
                                                      "date_time",
                                                      "date time",
                                                      "clock",
                                                      "epoch",
                                                      "epoch_time",
                                                      "unix_time",
                                                      "utc",
                                                      "log_time",
                                                      "publish_time",
                                                      "sim_time",
                                                      "ros_time",
                                                      "host_time",
                                                      "system_time",
                                                      "zeit",
                                                      "zeitstempel",
                                                      "temps",
                                                      "tiempo",
                                                      "\xE6\x97\xB6\xE9\x97\xB4",
                                                      "\xE6\x99\x82\xE9\x96\x93"};
    return isOneOf(name, kNames);
}

/// Name of the time column that PlotJuggler ("__time") or ROS ("%time") writes.
bool isReservedName(std::string_view name) {
    return name == "__time" || name == "%time";
}

struct Heading {
    bool isTime = false;
    std::optional<double> factor{};
    std::string unknownUnit{};
};

Heading headingOf(const RecordedColumn& column) {
    const std::string lower = lowered(column.name);
    std::string_view name = stripped(lower);
    std::string unit = lowered(column.unit);
    if (unit.empty() && !name.empty() && (name.back() == ')' || name.back() == ']')) {
        if (const std::size_t open = name.rfind(name.back() == ')' ? '(' : '[');
            open != std::string_view::npos) {
            unit = std::string(stripped(name.substr(open + 1, name.size() - open - 2)));
            name = stripped(name.substr(0, open));
        }
    } else if (const std::size_t slash = name.rfind(" / "); unit.empty() && slash != std::string_view::npos) {
        unit = std::string(stripped(name.substr(slash + 3)));
        name = stripped(name.substr(0, slash));
    }
    // Use only the last part of a path such as /joint_states/header/stamp.
    name = name.substr(std::min(name.find_last_of("/.") + 1, name.size()));
    Heading heading;
    heading.isTime = isTimeName(name) || isReservedName(name);
    if (const std::size_t bar = name.find_last_of("_ ");
        !heading.isTime && unit.empty() && bar != std::string_view::npos && factorOf(name.substr(bar + 1))) {
        unit = std::string(name.substr(bar + 1));
        heading.isTime = isTimeName(name.substr(0, bar));
    }
    if (!heading.isTime && name.size() >= 3 && factorOf(name)) {  // a column "seconds"
        heading.isTime = unit.empty() || unit == name;
        unit = std::string(name);
    }
    heading.factor = factorOf(unit);
    heading.unknownUnit = heading.factor ? std::string() : unit;
    return heading;
}

/// The column of nanoseconds that belongs to a column of whole seconds; empty if there is none.
std::optional<std::size_t> nanosecondsOf(const std::vector<RecordedColumn>& columns, std::size_t seconds) {
    const std::string name = lowered(columns[seconds].name);
    for (const std::string_view ending : {"secs", "sec"}) {
        if (!name.ends_with(ending)) {
            continue;
        }
        const std::string prefix = name.substr(0, name.size() - ending.size());
        if (!prefix.empty() && std::string_view("_./ ").find(prefix.back()) == std::string_view::npos) {
            continue;
        }
        for (const char* rest : {"nsecs", "nsec", "nanosec", "nanosecs"}) {
            const auto found = std::find_if(columns.begin(), columns.end(), [&](const RecordedColumn& each) {
                return lowered(each.name) == prefix + rest;
            });
            if (found != columns.end()) {
                return static_cast<std::size_t>(found - columns.begin());
            }
        }
    }
    return std::nullopt;
}

QString listed(const std::vector<RecordedColumn>& columns, const std::vector<std::size_t>& which) {
    constexpr std::size_t kMax = 12;
    QStringList names;
    for (std::size_t i = 0; i < which.size() && i < kMax; ++i) {
        names << QLatin1Char('"') + QString::fromStdString(columns[which[i]].name) + QLatin1Char('"');
    }
    return names.join(QLatin1String(", ")) +
           (which.size() > kMax ? QStringLiteral(" and %1 more").arg(which.size() - kMax) : QString());
}

QString listed(const std::vector<RecordedColumn>& columns) {
    std::vector<std::size_t> all(columns.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = i;
    }
    return listed(columns, all);
}

/// Median of the positive intervals; 0 if there are none.
double medianStep(std::span<const double> times) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size() && steps.size() < kStepsForPeriod; ++i) {
        if (times[i] > times[i - 1] && std::isfinite(times[i] - times[i - 1])) {
            steps.push_back(times[i] - times[i - 1]);
        }
    }
    if (steps.empty()) {
        return 0;
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

struct StampExtent {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    std::size_t count = 0;
    double first = 0;
    bool isWhole = true;
};

StampExtent extentOf(std::span<const double> values) {
    StampExtent extent;
    for (const double value : values) {
        if (std::isfinite(value)) {
            extent.first = extent.count == 0 ? value : extent.first;
            extent.min = std::min(extent.min, value);
            extent.max = std::max(extent.max, value);
            extent.isWhole = extent.isWhole && value == std::trunc(value);
            ++extent.count;
        }
    }
    return extent;
}

bool isEpoch(const StampExtent& extent, double factor) {
    return extent.count > 0 && extent.min * factor >= kFirstEpoch && extent.max * factor < kLastEpoch;
}

class Chooser {
public:
    Chooser(const QString& path, const TimeSource& source, const TableFormat& format)
        : path_(path), source_(source), format_(format) {}

    Result<TimeAxis> run() {
        if (!std::isfinite(format_.rate) || format_.rate < 0) {
            return undecided(QStringLiteral("the rate must be a positive number of rows per second"));
        }
        const auto column = findColumn();
        if (!column) {
            return column.error();
        }
        if (!*column) {
            axis_.rate = format_.rate;
            return axis_;
        }
        if (format_.rate > 0) {
            return undecided(
                QStringLiteral("the rate applies only to tables without a time column, and \"%1\" is a time "
                               "column. Specify --time-column none, or omit --table-rate")
                    .arg(QString::fromStdString(source_.columns[**column].name)));
        }
        axis_.column = *column;
        axis_.nanoseconds = nanosecondsOf(source_.columns, **column);
        return findUnit();
    }

private:
    Error undecided(const QString& what) const { return {ErrorCode::InvalidArgument, path_, what}; }

    /// Empty: the table has no time column.
    Result<std::optional<std::size_t>> findColumn() const {
        using Found = std::optional<std::size_t>;
        const std::vector<RecordedColumn>& columns = source_.columns;
        if (format_.timeColumn && format_.timeColumn->empty()) {
            return format_.rate > 0
                       ? Result<Found>(Found())
                       : undecided(QStringLiteral("a table without a time column requires the number of rows "
                                                  "per second. Specify --table-rate HZ"));
        }
        if (format_.timeColumn) {
            const auto named = std::find_if(columns.begin(), columns.end(), [&](const RecordedColumn& each) {
                return each.name == *format_.timeColumn;
            });
            if (named == columns.end()) {
                return undecided(QStringLiteral("there is no column \"%1\"; the columns are %2")
                                     .arg(QString::fromStdString(*format_.timeColumn), listed(columns)));
            }
            return Found(named - columns.begin());
        }
        std::vector<std::size_t> candidates;
        std::vector<std::size_t> dates;
        bool hasRobot = false;
        Found stamp;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            hasRobot = hasRobot || isOfRobot(columns[i]);
            if (columns[i].name == "timestamp" && !stamp) {
                stamp = i;
            }
            if (isReservedName(lowered(columns[i].name))) {
                return Found(i);
            }
            if (source_.dates[i] != DateKind::None) {
                dates.push_back(i);
            }
            if (headingOf(columns[i]).isTime) {
                const bool isRest =
                    std::any_of(columns.begin(), columns.end(), [&](const RecordedColumn& each) {
                        return nanosecondsOf(columns, static_cast<std::size_t>(&each - columns.data())) == i;
                    });
                if (!isRest) {
                    candidates.push_back(i);
                }
            } else if (nanosecondsOf(columns, i)) {
                candidates.push_back(i);
            }
        }
        if (hasRobot && stamp) {
            return stamp;
        }
        if (candidates.empty()) {
            candidates = dates;
        }
        if (candidates.size() > 1) {
            return undecided(QStringLiteral("several columns may be the time: %1. Specify --time-column NAME")
                                 .arg(listed(columns, candidates)));
        }
        if (candidates.empty() && format_.rate > 0) {
            return Found();
        }
        if (candidates.empty()) {
            return undecided(QStringLiteral("none of the columns is recognized as time: %1. Specify "
                                            "--time-column NAME, or --time-column none and --table-rate HZ")
                                 .arg(listed(columns)));
        }
        return Found(candidates.front());
    }

    Result<TimeAxis> findUnit() {
        const std::size_t column = *axis_.column;
        const RecordedColumn& described = source_.columns[column];
        const auto values = source_.values(column);
        if (!values) {
            return values.error();
        }
        const StampExtent extent = extentOf(*values);
        if (extent.count == 0 && !values->empty()) {
            return undecided(
                QStringLiteral("the time column \"%1\" contains no numbers or ISO 8601 dates. Specify "
                               "--time-column NAME, or --time-column none and --table-rate HZ")
                    .arg(QString::fromStdString(described.name)));
        }
        const Heading heading = headingOf(described);
        const bool isDate = source_.dates[column] != DateKind::None;
        const double step = medianStep(*values);
        axis_.isController = described.name == "timestamp" && !isDate &&
                             std::any_of(source_.columns.begin(), source_.columns.end(), isOfRobot);
        std::optional<double> factor;
        if (isDate || axis_.nanoseconds) {
            factor = 1;
        } else if (format_.timeUnit) {
            factor = secondsPer(*format_.timeUnit);
        } else if (heading.factor) {
            factor = heading.factor;
        } else if (!heading.unknownUnit.empty()) {
            return undecided(QStringLiteral("the unit \"%1\" of the time column \"%2\" is not known. Specify "
                                            "--time-unit s, ms, us or ns")
                                 .arg(QString::fromStdString(heading.unknownUnit),
                                      QString::fromStdString(described.name)));
        } else {
            for (const double each : {1.0, 1e-3, 1e-6, 1e-9}) {
                if (isEpoch(extent, each) && step * each <= kMaxEpochStep) {
                    factor = each;
                }
            }
        }
        const bool hasFractions = !extent.isWhole && step < 1;
        if (!factor && (axis_.isController || extent.count < 2 || hasFractions)) {
            factor = 1;
        }
        if (!factor) {
            QStringList first;
            for (std::size_t i = 0; i < values->size() && first.size() < 3; ++i) {
                first << QString::number((*values)[i], 'g', 15);
            }
            return undecided(
                QStringLiteral("the unit of the time column \"%1\" with the values %2 is not known. Specify "
                               "--time-unit s, ms, us or ns")
                    .arg(QString::fromStdString(described.name), first.join(QLatin1String(", "))));
        }
        axis_.factor = *factor;
        if (isEpoch(extent, *factor) && source_.dates[column] != DateKind::LocalTime) {
            constexpr double kNanoPerSecond = 1e9;
            double start = extent.first * *factor * kNanoPerSecond;
            if (axis_.nanoseconds) {
                const auto rest = source_.values(*axis_.nanoseconds);
                if (!rest) {
                    return rest.error();
                }
                const double first = rest->empty() || !std::isfinite(rest->front()) ? 0 : rest->front();
                start += std::clamp(first, 0.0, kNanoPerSecond);
            }
            axis_.startUtcNs = std::llround(start);
        }
        return axis_;
    }

    const QString& path_;
    const TimeSource& source_;
    const TableFormat& format_;
    TimeAxis axis_;
};

}  // namespace

Result<TimeAxis> chooseTimeAxis(const QString& path, const TimeSource& source, const TableFormat& format) {
    return Chooser(path, source, format).run();
}

TimeLine timeLine(const TimeAxis& axis, std::span<const double> stamps, std::span<const double> nanoseconds,
                  std::size_t rows) {
    TimeLine line;
    line.seconds.resize(rows);
    if (!axis.column) {
        line.period = axis.rate > 0 && rows > 1 ? 1 / axis.rate : 0;
        for (std::size_t i = 0; i < rows; ++i) {
            line.seconds[i] = axis.rate > 0 ? static_cast<double>(i) / axis.rate : 0;
        }
        return line;
    }
    const auto first =
        std::find_if(stamps.begin(), stamps.end(), [](double each) { return std::isfinite(each); });
    const double origin = first == stamps.end() ? 0 : *first;
    const double originRest = nanoseconds.empty() || first == stamps.end()
                                  ? 0
                                  : nanoseconds[static_cast<std::size_t>(first - stamps.begin())];
    // The difference of two large numbers is exact, but their product with a factor is not.
    const auto at = [&](std::size_t i) {
        const double rest = nanoseconds.empty() ? 0 : (nanoseconds[i] - originRest) * 1e-9;
        return (axis.factor == 1e-3   ? (stamps[i] - origin) / 1e3
                : axis.factor == 1e-6 ? (stamps[i] - origin) / 1e6
                : axis.factor == 1e-9 ? (stamps[i] - origin) / 1e9
                                      : (stamps[i] - origin) * axis.factor) +
               rest;
    };
    for (std::size_t i = 0; i < rows; ++i) {
        line.seconds[i] = at(i);
    }
    line.period = medianStep(line.seconds);
    double shift = 0;
    double previous = 0;
    double last = 0;  // time stamp before the step back, since the first row
    for (std::size_t i = 0; i < rows; ++i) {
        double time = previous;
        if (const double stamp = line.seconds[i]; std::isfinite(stamp)) {
            if (stamp + shift < previous) {
                shift = previous + line.period - stamp;
                if (line.restarts.size() < kMaxRestarts) {
                    const double begin = origin * axis.factor;
                    line.restarts.push_back({previous + line.period, kRestartLevel,
                                             QLatin1String(kRestartSource),
                                             axis.isController ? restartText(begin + last, begin + stamp)
                                                               : stepBackText(begin + last, begin + stamp)});
                }
                if (!axis.isController) {
                    line.breaks.push_back({i, 0, line.period});
                }
            }
            time = stamp + shift;
            last = stamp;
        }
        line.seconds[i] = time;
        previous = time;
    }
    return line;
}

bool parseDate(std::string_view text, double& seconds, DateKind& kind) {
    const auto number = [&text](std::size_t from, std::size_t digits, int& value) {
        if (from + digits > text.size()) {
            return false;
        }
        const char* const end = text.data() + from + digits;
        return text[from] != '-' && std::from_chars(text.data() + from, end, value).ptr == end;
    };
    int year = 0;
    int month = 0;
    int day = 0;
    if (text.size() < 10 || text[4] != '-' || text[7] != '-' || !number(0, 4, year) || !number(5, 2, month) ||
        !number(8, 2, day)) {
        return false;
    }
    const std::chrono::year_month_day date{std::chrono::year(year),
                                           std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok()) {
        return false;
    }
    seconds = static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count()) * 86'400;
    kind = DateKind::LocalTime;
    if (text.size() == 10) {
        return true;
    }
    int hour = 0;
    int minute = 0;
    int second = 0;
    if ((text[10] != 'T' && text[10] != 't' && text[10] != ' ') || text.size() < 16 || text[13] != ':' ||
        !number(11, 2, hour) || !number(14, 2, minute) || hour > 24 || minute > 59) {
        return false;
    }
    std::size_t end = 16;
    double fraction = 0;
    if (end < text.size() && text[end] == ':') {
        if (!number(17, 2, second) || second > 60) {
            return false;
        }
        end = 19;
        if (end < text.size() && (text[end] == '.' || text[end] == ',')) {
            double scale = 0.1;
            for (++end; end < text.size() && text[end] >= '0' && text[end] <= '9'; ++end, scale /= 10) {
                fraction += scale * (text[end] - '0');
            }
        }
    }
    int offset = 0;  // [min]
    if (std::string_view zone = text.substr(end); !zone.empty()) {
        kind = DateKind::Utc;
        if (zone.front() == ' ') {
            zone.remove_prefix(1);
            ++end;
        }
        if (zone != "Z" && zone != "z" && zone != "UTC") {
            int hours = 0;
            int minutes = 0;
            const bool hasColon = zone.size() == 6 && zone[3] == ':';
            if ((zone.front() != '+' && zone.front() != '-') || !number(end + 1, 2, hours) ||
                (zone.size() != 3 && !(hasColon && number(end + 4, 2, minutes)) &&
                 !(zone.size() == 5 && number(end + 3, 2, minutes)))) {
                return false;
            }
            offset = (zone.front() == '-' ? -1 : 1) * (hours * 60 + minutes);
        }
    }
    seconds += (hour * 60 + minute - offset) * 60 + second + fraction;
    return true;
}

}  // namespace tiller::recording
