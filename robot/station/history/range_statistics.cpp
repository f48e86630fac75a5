// SPDX-License-Identifier: MIT
#include "robot/station/history/range_statistics.h"

#include <algorithm>
#include <cmath>

#include "robot/station/history/signal_store.h"

namespace tiller {

namespace {

constexpr std::int64_t kSumRows = SeriesColumn::kBlockRows;
/// Maximum number of blocks in memory that are summed per call. Summing these blocks takes a few
/// milliseconds.
constexpr std::int64_t kBlocksAtOnce = 300;
/// Maximum number of blocks of a file that are read synchronously.
constexpr std::int64_t kFewBlocks = 4;

}  // namespace

void Moments::add(double time, double value) {
    if (std::isnan(value)) {
        return;
    }
    ++count;
    min = std::min(min, value);
    max = std::max(max, value);
    const auto all = static_cast<double>(count);
    const double timeStep = time - meanTime;
    const double step = value - mean;
    meanTime += timeStep / all;
    mean += step / all;
    squares += step * (value - mean);
    timeSquares += timeStep * (time - meanTime);
    products += timeStep * (value - mean);
}

void Moments::add(const Moments& other) {
    if (other.count == 0) {
        return;
    }
    const auto mine = static_cast<double>(count);
    const auto others = static_cast<double>(other.count);
    const double all = mine + others;
    const double step = other.mean - mean;
    const double timeStep = other.meanTime - meanTime;
    squares += other.squares + step * step * mine * others / all;
    timeSquares += other.timeSquares + timeStep * timeStep * mine * others / all;
    products += other.products + timeStep * step * mine * others / all;
    mean += step * others / all;
    meanTime += timeStep * others / all;
    count += other.count;
    min = std::min(min, other.min);
    max = std::max(max, other.max);
}

std::optional<RangeStatistics> Moments::statistics() const {
    if (count == 0) {
        return std::nullopt;
    }
    RangeStatistics all;
    all.count = count;
    all.min = min;
    all.max = max;
    all.mean = mean;
    const double variance = squares / static_cast<double>(count);
    all.rms = std::sqrt(variance + mean * mean);
    all.deviation = std::sqrt(variance);
    all.slope = timeSquares > 0 ? products / timeSquares : 0;
    return all;
}

/// The current job of the worker.
struct RangeStatisticsCache::Reading {
    std::vector<int> of;
    std::int64_t firstBlock = 0;
    std::int64_t endBlock = 0;
    CancelToken cancel;

    bool covers(const std::vector<int>& wanted, std::int64_t first, std::int64_t end) const {
        return firstBlock <= first && end <= endBlock &&
               std::all_of(wanted.begin(), wanted.end(), [this](int signal) {
                   return std::find(of.begin(), of.end(), signal) != of.end();
               });
    }
};

std::int64_t RangeStatisticsCache::Range::firstBlock() const {
    return (begin + kSumRows - 1) / kSumRows;
}

std::int64_t RangeStatisticsCache::Range::endBlock() const {
    return std::max(end / kSumRows, firstBlock());
}

RangeStatisticsCache::RangeStatisticsCache(const SignalStore& store, QObject* parent)
    : QObject(parent), store_(store) {
    connect(&store_, &SignalStore::signalAdded, this, [this](int signal) {
        if (signal < 0) {  // the recordings have been closed
            endReading();
            failed_.clear();
        }
    });
}

RangeStatisticsCache::~RangeStatisticsCache() {
    endReading();
}

void RangeStatisticsCache::endReading() {
    if (reading_) {
        reading_->cancel.cancel();
        reading_.reset();
        worker_.cancelAll();
    }
}

std::optional<RangeStatisticsCache::Range> RangeStatisticsCache::rangeOf(int signal, double from,
                                                                         double to) const {
    const SeriesBuffer* history = store_.buffer(signal);
    if (history == nullptr || history->isEmpty()) {
        return std::nullopt;
    }
    const Range range{history->lowerBound(std::min(from, to)), history->lastBefore(std::max(from, to)) + 1};
    return range.begin < range.end ? std::optional(range) : std::nullopt;
}

Moments RangeStatisticsCache::sum(int signal, std::int64_t begin, std::int64_t end) const {
    const SeriesBuffer& history = *store_.buffer(signal);
    Moments all;
    for (std::int64_t i = begin; i < end; ++i) {
        all.add(history.time(i), store_.value(signal, i));
    }
    return all;
}

void RangeStatisticsCache::take(int signal, std::int64_t block, const Moments& moments) {
    Blocks& blocks = blocks_[signal];
    if (static_cast<std::size_t>(block) >= blocks.size()) {
        blocks.resize(static_cast<std::size_t>(block) + 1);
    }
    blocks[static_cast<std::size_t>(block)] = moments;
}

void RangeStatisticsCache::want(std::span<const int> wanted, double from, double to) {
    struct Missing {
        std::vector<int> of;
        std::int64_t first = std::numeric_limits<std::int64_t>::max();
        std::int64_t end = 0;
    };
    std::map<QString, Missing> files;  // grouped by recording name
    std::int64_t asked = 0;
    std::int64_t missing = 0;
    bool isMemoryMissing = false;
    problem_.clear();
    std::int64_t atOnce = kBlocksAtOnce;
    for (const int signal : wanted) {
        const auto range = rangeOf(signal, from, to);
        if (!range) {
            continue;
        }
        if (store_.mixesRobots(signal, from, to)) {
            problem_ =
                tr("The range contains samples from different robots. Place cursors A and B around data from "
                   "one robot.");
            continue;
        }
        if (const auto failed = failed_.constFind(store_.recordingOf(signal)); failed != failed_.constEnd()) {
            problem_ = *failed;
        }
        std::vector<std::int64_t> unknown;
        const Blocks& blocks = blocks_[signal];
        for (std::int64_t block = range->firstBlock(); block < range->endBlock(); ++block) {
            if (static_cast<std::size_t>(block) >= blocks.size() ||
                !blocks[static_cast<std::size_t>(block)]) {
                unknown.push_back(block);
            }
        }
        asked += range->endBlock() - range->firstBlock();
        const bool isFar =
            store_.buffer(signal)->isInFile() && static_cast<std::int64_t>(unknown.size()) > kFewBlocks;
        if (isFar) {
            missing += static_cast<std::int64_t>(unknown.size());
            const QString recording = store_.recordingOf(signal);
            if (failed_.contains(recording)) {
                continue;
            }
            Missing& file = files[recording];
            file.of.push_back(signal);
            file.first = std::min(file.first, unknown.front());
            file.end = std::max(file.end, unknown.back() + 1);
            continue;
        }
        for (const std::int64_t block : unknown) {
            if (atOnce > 0) {
                take(signal, block, sum(signal, block * kSumRows, (block + 1) * kSumRows));
                --atOnce;
            } else {
                ++missing;
                isMemoryMissing = true;
            }
        }
    }
    part_ = asked == 0 ? 1 : 1 - static_cast<double>(missing) / static_cast<double>(asked);
    if (isMemoryMissing) {
        QMetaObject::invokeMethod(this, &RangeStatisticsCache::known, Qt::QueuedConnection);
    }
    if (!files.empty()) {
        // Only one file is read at a time.
        const auto& [recording, next] = *files.begin();
        if (!reading_ || !reading_->covers(next.of, next.first, next.end)) {
            read(recording, next.of, next.first, next.end);
        }
    }
}

void RangeStatisticsCache::read(const QString& recording, const std::vector<int>& wanted,
                                std::int64_t firstBlock, std::int64_t endBlock) {
    endReading();
    const auto stretch = store_.stretchOf(wanted, firstBlock * kSumRows, endBlock * kSumRows);
    if (!stretch) {
        return;
    }
    reading_ = std::make_shared<Reading>(Reading{wanted, firstBlock, endBlock, {}});
    worker_.post(this, [this, recording, stretch = *stretch, reading = reading_](const CancelToken& ending) {
        const auto done = stretch.readAll(ending, [&](std::uint64_t first, const RecordedRows::Rows& rows) {
            std::vector<std::vector<Moments>> sums(rows.values.size());
            for (std::size_t i = 0; i < rows.values.size(); ++i) {
                sums[i].resize(rows.times.size() / static_cast<std::size_t>(kSumRows));
                for (std::size_t row = 0; row < sums[i].size() * static_cast<std::size_t>(kSumRows); ++row) {
                    sums[i][row / static_cast<std::size_t>(kSumRows)].add(rows.times[row],
                                                                          rows.values[i][row]);
                }
            }
            QMetaObject::invokeMethod(
                this,
                [this, reading, block = static_cast<std::int64_t>(first) / kSumRows, sums = std::move(sums)] {
                    if (reading->cancel.isCancelled()) {
                        return;
                    }
                    for (std::size_t i = 0; i < sums.size(); ++i) {
                        for (std::size_t k = 0; k < sums[i].size(); ++k) {
                            take(reading->of[i], block + static_cast<std::int64_t>(k), sums[i][k]);
                        }
                    }
                    Q_EMIT known();
                },
                Qt::QueuedConnection);
            return !reading->cancel.isCancelled();
        });
        return std::function<void()>([this, recording, reading, done] {
            if (reading->cancel.isCancelled()) {
                return;
            }
            reading_.reset();
            if (!done) {
                failed_.insert(recording, done.error().toString());
            }
            Q_EMIT known();
        });
    });
}

std::optional<RangeStatistics> RangeStatisticsCache::statistics(int signal, double from, double to) const {
    const auto range = rangeOf(signal, from, to);
    if (!range || store_.mixesRobots(signal, from, to)) {
        return std::nullopt;
    }
    const std::int64_t first = range->firstBlock();
    const std::int64_t end = range->endBlock();
    if (first >= end) {
        return sum(signal, range->begin, range->end).statistics();
    }
    const auto blocks = blocks_.find(signal);
    Moments all = sum(signal, range->begin, first * kSumRows);
    for (std::int64_t block = first; block < end; ++block) {
        if (blocks == blocks_.end() || static_cast<std::size_t>(block) >= blocks->second.size() ||
            !blocks->second[static_cast<std::size_t>(block)]) {
            return std::nullopt;
        }
        all.add(*blocks->second[static_cast<std::size_t>(block)]);
    }
    all.add(sum(signal, end * kSumRows, range->end));
    return all.statistics();
}

}  // namespace tiller

#include "moc_range_statistics.cpp"
