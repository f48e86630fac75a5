// SPDX-License-Identifier: MIT
#pragma once

// Results of the backend benchmark: one row per value, with the limit of the value if there is one.

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "tests/benchmarks/machine_watch.h"

namespace tiller::benchmark {

struct Row {
    QString section;
    QString what;
    double value = 0;
    QString unit;
    std::optional<double> limit;  ///< limit of the value
    QString remark;               ///< text that replaces a value that could not be measured
    bool passed() const { return remark.isEmpty() && (!limit || value <= *limit); }
};

/// Sorted durations with exact values, in contrast to the buckets of a histogram.
class Durations {
public:
    explicit Durations(std::vector<std::int64_t> ns);
    std::size_t count() const { return ns_.size(); }
    /// percent  0 ... 100
    /// Returns  0 if empty
    std::int64_t percentileNs(double percent) const;
    std::int64_t maxNs() const { return percentileNs(100); }
    std::size_t countAbove(std::int64_t ns) const;

private:
    std::vector<std::int64_t> ns_;
};

/// Durations with their times. Threads: one at a time. Real-time: yes (no allocation after construction).
class Spans {
public:
    /// most  capacity; overflowed() returns true if the capacity was exceeded
    explicit Spans(std::size_t most) { spans_.reserve(most); }
    void add(std::int64_t fromNs, std::int64_t toNs);

    Durations all() const;
    /// Returns only the durations in the quieter half of all half-second intervals. This excludes
    /// disturbances of the computer that occur a few times per second, but includes effects of the program,
    /// which occur in every interval.
    Durations quieterHalf() const;
    /// Returns only the durations during which all CPUs were available.
    Durations whileThere(const MachineWatch& watch) const;
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
    /// Adds percentiles [ms] and the number of values above `limitNs`. Adds the same for durations without
    /// disturbances of the computer. If `required` is true, none of these may exceed the limit.
    void add(const QString& what, const Spans& spans, const MachineWatch& watch, std::int64_t limitNs,
             bool required);
    bool passed() const;
    QString table() const;
    QByteArray json() const;

private:
    QString section_;
    std::vector<Row> rows_;
};

/// Options of the measurements.
struct Wishes {
    double seconds = 60;
    int roundTrips = 1000;
};

void measureLoops(Report& report, const Wishes& wishes);  ///< measures circles, round trips, allocations
void measureCosts(Report& report);                        ///< measures decoding, control tick, receiving
void measureTimeout(Report& report);                      ///< measures deadlines, cancels, destruction
/// measures the servo loop and reactions of the ur_rtde compatibility layer
void measureUrRtde(Report& report, const Wishes& wishes);
bool decodeOnly(int times);  ///< for runs with callgrind

}  // namespace tiller::benchmark
