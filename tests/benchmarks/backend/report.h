// SPDX-License-Identifier: MIT
#pragma once

// What the benchmark of the backend found: one row a figure, with the limit of the acceptance where there is
// one.

#include <QString>
#include <optional>
#include <vector>

#include "robot/realtime/histogram.h"

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

class Report {
public:
    void begin(const QString& section);
    void add(const QString& what, double value, const QString& unit, std::optional<double> limit = {});
    void cannot(const QString& what, const QString& why);
    /// Percentiles [ms], and how many are above `limitNs`, of which none may be where it is `required`.
    void add(const QString& what, const realtime::Histogram& histogram, std::int64_t limitNs, bool required);
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
