// SPDX-License-Identifier: MIT
#pragma once

// What the benchmark of the backend found: one row a figure, with the limit we hold it to where there is one.

#include <QString>
#include <optional>
#include <vector>

#include "robot/realtime/histogram.h"
#include "tests/benchmarks/machine_watch.h"

namespace tiller::benchmark {

struct Row {
    QString section;
    QString what;
    double value = 0;
    QString unit;
    std::optional<double> limit;  ///< the value must not be above it
    QString remark;               ///< in place of a value that could not be measured
    bool passed() const { return remark.isEmpty() && (!limit || value <= *limit); }
};

/// Durations, and when they were.
/// Threads  one at a time. Real-time: yes (no allocation after construction)
class Spans {
public:
    /// most  so many are kept; overflowed() tells when there were more
    explicit Spans(std::size_t most) { spans_.reserve(most); }
    void add(std::int64_t fromNs, std::int64_t toNs);

    realtime::Histogram all() const;
    /// Only those during which all processors were there.
    realtime::Histogram whileThere(const MachineWatch& watch) const;
    bool overflowed() const { return overflowed_; }

private:
    struct Span {
        std::int64_t fromNs;
        std::int64_t toNs;
    };
    std::vector<Span> spans_;
    bool overflowed_ = false;
};

class Report {
public:
    void begin(const QString& section);
    void add(const QString& what, double value, const QString& unit, std::optional<double> limit = {});
    void cannot(const QString& what, const QString& why);
    /// Percentiles [ms] and how many are above `limitNs`; the same of those the machine is not to blame for,
    /// of which none may be above where it is `required`.
    void add(const QString& what, const Spans& spans, const MachineWatch& watch, std::int64_t limitNs,
             bool required);
    bool passed() const;
    QString table() const;
    QByteArray json() const;

private:
    QString section_;
    std::vector<Row> rows_;
};

/// What the parts are told.
struct Wishes {
    double seconds = 60;
    int roundTrips = 1000;
};

void measureLoops(Report& report, const Wishes& wishes);  ///< circles, round trips, allocations
void measureCosts(Report& report);                        ///< decoding, control tick, receiving
void measurePatience(Report& report);                     ///< deadlines, cancels, ends
bool decodeOnly(int times);                               ///< for callgrind

}  // namespace tiller::benchmark
