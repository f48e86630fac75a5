// SPDX-License-Identifier: MIT
#pragma once

// Statistics of the samples in a time range. Sums of whole blocks are cached, so moving a cursor over an hour
// is as fast as over a second. For a long recording, a worker reads the file once to compute the sums.

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
    double deviation = 0;  ///< population standard deviation (divided by count)
    double slope = 0;      ///< slope of the least-squares line [per s]; 0 if all samples have the same time

    double peakToPeak() const { return max - min; }
};

/// Sums over samples. Means and central moments are updated incrementally, so that rounding does not hide a
/// small ripple on a large value.
struct Moments {
    std::int64_t count = 0;
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    double mean = 0;
    double meanTime = 0;
    double squares = 0;      ///< sum of squared deviations from the mean
    double timeSquares = 0;  ///< sum of squared deviations from the mean time
    double products = 0;     ///< sum of the products of the two deviations

    /// Adds a sample. NaN is ignored.
    void add(double time, double value);
    void add(const Moments& other);
    std::optional<RangeStatistics> statistics() const;
};

/// Threads  GUI; files are read by a worker
class RangeStatisticsCache : public QObject {
    Q_OBJECT

public:
    /// store  must outlive the cache
    explicit RangeStatisticsCache(const SignalStore& store, QObject* parent = nullptr);
    ~RangeStatisticsCache() override;

    /// Selects the signals and the range of the next queries: the samples between `from` and `to`, in either
    /// order. Computes some of the missing sums immediately and the rest later. Emits known() when results
    /// have changed.
    void want(std::span<const int> wanted, double from, double to);
    /// Fraction of the sums that is available: 0 ... 1.
    double part() const { return part_; }
    /// Why sums are missing or incomplete; empty if they are available or still being computed.
    const QString& problem() const { return problem_; }
    /// Returns no value if there is no sample, or while part() is below 1.
    std::optional<RangeStatistics> statistics(int signal, double from, double to) const;

Q_SIGNALS:
    void known();

private:
    using Blocks = std::vector<std::optional<Moments>>;  ///< indexed by block number
    struct Range {
        std::int64_t begin, end;  ///< sample numbers
        /// Blocks that are completely within this range: first index, and index after the last.
        std::int64_t firstBlock() const;
        std::int64_t endBlock() const;
    };
    struct Reading;
    std::optional<Range> rangeOf(int signal, double from, double to) const;
    Moments sum(int signal, std::int64_t begin, std::int64_t end) const;
    /// Reads blocks first ... end - 1 of these signals from the file. Cancels the current job.
    void read(const QString& recording, const std::vector<int>& wanted, std::int64_t firstBlock,
              std::int64_t endBlock);
    void endReading();
    void take(int signal, std::int64_t block, const Moments& moments);

    const SignalStore& store_;
    std::map<int, Blocks> blocks_;  ///< indexed by signal
    double part_ = 1;
    QString problem_;
    QHash<QString, QString> failed_;    ///< error message by recording
    std::shared_ptr<Reading> reading_;  ///< null: no job
    SerialExecutor worker_;             ///< last member, so that its jobs end before the other members are
                                        ///< destroyed
};

}  // namespace tiller
