// SPDX-License-Identifier: MIT
#pragma once

// Results of the backend benchmark: one row per value, with its limit if there is one.

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
    std::optional<double> limit;  ///< maximum of the value
    QString remark;               ///< replaces a value that could not be measured
    bool passed() const { return remark.isEmpty() && (!limit || value <= *limit); }
};

/// Sorted durations: exact, unlike the buckets of a histogram.
class Durations {
public:
    explicit Durations(std::vector<std::int64_t> ns);
    std::size_t count() const { return ns_.size(); }
    /// `percent`: 0 ... 100. Returns 0 if empty.
    std::int64_t percentileNs(double percent) const;
    std::int64_t maxNs() const { return percentileNs(100); }
    std::size_t countAbove(std::int64_t ns) const;

private:
    std::vector<std::int64_t> ns_;
};

/// Durations with their times.
/// Threads: one at a time. Real-time: yes (no allocation after construction).
class Spans {
public:
    /// `most`: capacity; overflowed() is true if it was exceeded.
    explicit Spans(std::size_t most) { spans_.reserve(most); }
    void add(std::int64_t fromNs, std::int64_t toNs);

    Durations all() const;
    /// Only the durations in the quieter half of all half seconds: disturbances of the machine that occur a few
    /// times per second are in the other half, effects of the program are in both.
    Durations quieterHalf() const;
    /// Only the durations during which all CPUs were available.
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
    /// Adds percentiles [ms] and the number above `limitNs`; the same for durations without disturbances of the
    /// machine, of which none may exceed the limit if `required`.
    void add(const QString& what, const Spans& spans, const MachineWatch& watch, std::int64_t limitNs,
             bool required);
    bool passed() const;
    QString table() const;
    QByteArray json() const;

private:
    QString section_;
    std::vector<Row> rows_;
};

/// Options of the parts.
struct Wishes {
    double seconds = 60;
    int roundTrips = 1000;
};

void measureLoops(Report& report, const Wishes& wishes);  ///< circles, round trips, allocations
void measureCosts(Report& report);                        ///< decoding, control tick, receiving
void measurePatience(Report& report);                     ///< deadlines, cancels, destruction
/// servo loop and reactions of the ur_rtde compatibility layer
void measureFace(Report& report, const Wishes& wishes);
bool decodeOnly(int times);  ///< for callgrind

}  // namespace tiller::benchmark
