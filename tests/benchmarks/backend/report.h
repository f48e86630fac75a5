// SPDX-License-Identifier: MIT
#pragma once

// What the benchmark of the backend found: one row a figure, with the limit we hold it to where there is one.

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
    std::optional<double> limit;  ///< the value must not be above it
    QString remark;               ///< in place of a value that could not be measured
    bool passed() const { return remark.isEmpty() && (!limit || value <= *limit); }
};

/// Durations in order of length: exact where a histogram's buckets would be wider than what is compared.
class Durations {
public:
    explicit Durations(std::vector<std::int64_t> ns);
    std::size_t count() const { return ns_.size(); }
    /// percent  0 ... 100. Returns  0 when there are none
    std::int64_t percentileNs(double percent) const;
    std::int64_t maxNs() const { return percentileNs(100); }
    std::size_t countAbove(std::int64_t ns) const;

private:
    std::vector<std::int64_t> ns_;
};

/// Durations, and when they were.
/// Threads  one at a time. Real-time: yes (no allocation after construction)
class Spans {
public:
    /// most  so many are kept; overflowed() tells when there were more
    explicit Spans(std::size_t most) { spans_.reserve(most); }
    void add(std::int64_t fromNs, std::int64_t toNs);

    Durations all() const;
    /// Only those of the quieter half of all half seconds: what befalls the machine a few times a second is
    /// in the other half, what the program itself does is in both.
    Durations quieterHalf() const;
    /// Only those during which all processors were there.
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
void measureFace(Report& report, const Wishes& wishes);   ///< servo loop and reactions of the ur_rtde face
bool decodeOnly(int times);                               ///< for callgrind

}  // namespace tiller::benchmark
