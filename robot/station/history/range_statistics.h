// SPDX-License-Identifier: MIT
#pragma once

// What the samples of a stretch of time have in common. Sums of whole blocks are kept, so that a cursor that moves over an
// hour costs no more than one that moves over a second; those of a long recording are made by a worker, which reads the file
// for them once.

#include <QHash>
#include <QObject>
#include <QString>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "robot/core/deadline.h"
#include "robot/station/executor/serial_executor.h"

namespace tiller {

class SeriesBuffer;
class SignalStore;

struct RangeStatistics {
    std::int64_t count = 0;  ///< samples with a value
    double min = 0;
    double max = 0;
    double mean = 0;
    double rms = 0;
    double deviation = 0;  ///< standard deviation, of the samples themselves (divided by count)
    double slope = 0;      ///< of the line that fits best [per s]; 0 for a single moment

    double peakToPeak() const { return max - min; }
};

/// Sums over samples. Means and moments about them are carried along, so that a small ripple on a large value is not lost in
/// rounding.
struct Moments {
    std::int64_t count = 0;
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    double mean = 0;
    double meanTime = 0;
    double squares = 0;      ///< about the mean
    double timeSquares = 0;  ///< about the mean
    double products = 0;     ///< about both means

    /// NaN is no value.
    void add(double time, double value);
    /// Those of other samples.
    void add(const Moments& other);
    std::optional<RangeStatistics> statistics() const;
};

/// Threads  GUI; files are read by a worker
class RangeStatisticsCache : public QObject {
    Q_OBJECT

public:
    /// store  must outlive it
    explicit RangeStatisticsCache(const SignalStore& store, QObject* parent = nullptr);
    ~RangeStatisticsCache() override;

    /// These signals are asked about next, in the samples with from <= time <= to, whichever of both is earlier. Computes
    /// some of what is missing and has the rest computed: known() says when to ask again.
    void want(std::span<const int> wanted, double from, double to);
    /// What of it is known: 0 ... 1.
    double part() const { return part_; }
    /// Why some of it is not known, or not of all rows; empty: it is, or will be.
    const QString& problem() const { return problem_; }
    /// Nothing where there is no value, or while part() is below 1.
    std::optional<RangeStatistics> statistics(int signal, double from, double to) const;

Q_SIGNALS:
    void known();

private:
    using Blocks = std::vector<std::optional<Moments>>;  ///< by their numbers
    struct Range {
        std::int64_t begin, end;  ///< samples
        /// Whole blocks of it.
        std::int64_t firstBlock() const;
        std::int64_t endBlock() const;
    };
    struct Reading;
    std::optional<Range> rangeOf(int signal, double from, double to) const;
    Moments sum(int signal, std::int64_t begin, std::int64_t end) const;
    /// Blocks first ... end - 1 of these signals in the file; takes the place of what was being read.
    void read(const QString& recording, const std::vector<int>& wanted, std::int64_t firstBlock,
              std::int64_t endBlock);
    void endReading();
    void take(int signal, std::int64_t block, const Moments& moments);

    const SignalStore& store_;
    std::map<int, Blocks> blocks_;  ///< by signal
    double part_ = 1;
    QString problem_;
    QHash<QString, QString> failed_;    ///< of these recordings, why
    std::shared_ptr<Reading> reading_;  ///< null: nothing is being read
    SerialExecutor worker_;             ///< last: its jobs end before the rest
};

}  // namespace tiller
