// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/series_buffer.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tiller {

namespace {

constexpr std::int64_t kLeastCapacity = 4096;  // the widest level's entry must fit
constexpr int kMostLevels = 6;

}  // namespace

SeriesBuffer::SeriesBuffer(int signalCount, std::int64_t capacity)
    : mask_(static_cast<std::int64_t>(
                std::bit_ceil(static_cast<std::uint64_t>(std::max(capacity, kLeastCapacity)))) -
            1)
    , levelCount_(0) {
    while (levelCount_ < kMostLevels && (this->capacity() >> (kFanoutBits * (levelCount_ + 1))) >= 2) {
        ++levelCount_;
    }
    // Not written to here: the system hands out the pages as the history grows into them.
    const auto count = static_cast<std::size_t>(this->capacity());
    times_ = std::make_unique_for_overwrite<double[]>(count);
    gaps_ = std::make_unique_for_overwrite<std::uint8_t[]>(count);
    for (int level = 0; level < levelCount_; ++level) {
        gapLevels_.push_back(
            std::make_unique_for_overwrite<std::uint8_t[]>(count >> (kFanoutBits * (level + 1))));
    }
    signals_.resize(static_cast<std::size_t>(std::max(signalCount, 0)));
    for (Signal& signal : signals_) {
        signal.values = std::make_unique_for_overwrite<float[]>(count);
        for (int level = 0; level < levelCount_; ++level) {
            // MinMax has a default, so this level's pages are touched; an eighth of the values at most.
            signal.levels.push_back(std::make_unique<MinMax[]>(count >> (kFanoutBits * (level + 1))));
        }
    }
}

std::size_t SeriesBuffer::memoryBytes() const {
    const auto count = static_cast<std::size_t>(capacity());
    std::size_t entries = 0;
    for (int level = 0; level < levelCount_; ++level) {
        entries += count >> (kFanoutBits * (level + 1));
    }
    return count * (sizeof(double) + 1) + entries +
           signals_.size() * (count * sizeof(float) + entries * sizeof(MinMax));
}

void SeriesBuffer::completeLevels() {
    // An entry is made when its last sample has come; until then, and once its first sample has fallen out,
    // nobody asks for it.
    for (int level = 0; level < levelCount_; ++level) {
        const int bits = kFanoutBits * (level + 1);
        if ((end_ & ((std::int64_t{1} << bits) - 1)) != 0) {
            return;
        }
        const std::int64_t entry = (end_ >> bits) - 1;
        const std::int64_t from = entry << kFanoutBits;
        const std::int64_t to = from + (1 << kFanoutBits);
        const auto index = static_cast<std::size_t>(level);
        std::uint8_t gap = 0;
        for (std::int64_t i = from; i < to; ++i) {
            gap |= level == 0 ? gaps_[slot(i)] : gapLevels_[index - 1][levelSlot(level - 1, i)];
        }
        gapLevels_[index][levelSlot(level, entry)] = gap;
        for (Signal& signal : signals_) {
            MinMax sum;
            for (std::int64_t i = from; i < to; ++i) {
                if (level == 0) {
                    sum.add(signal.values[slot(i)]);
                } else {
                    sum.add(signal.levels[index - 1][levelSlot(level - 1, i)]);
                }
            }
            signal.levels[index][levelSlot(level, entry)] = sum;
        }
    }
}

std::int64_t SeriesBuffer::lowerBound(double time) const {
    std::int64_t low = first();
    std::int64_t high = end_;
    while (low < high) {
        const std::int64_t middle = low + (high - low) / 2;
        if (this->time(middle) < time) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

std::int64_t SeriesBuffer::lowerBoundNear(double time, std::int64_t guess) const {
    const std::int64_t oldest = first();
    std::int64_t low = std::clamp(guess, oldest, end_);
    std::int64_t high = low;
    // Widen until low is known to be before the answer, or the oldest, and high not before it.
    for (std::int64_t step = 1; high < end_ && this->time(high) < time; step *= 2) {
        low = high + 1;
        high = std::min(end_, high + step);
    }
    for (std::int64_t step = 1; low > oldest && !(this->time(low - 1) < time); step *= 2) {
        high = low - 1;
        low = std::max(oldest, low - step);
    }
    while (low < high) {
        const std::int64_t middle = low + (high - low) / 2;
        if (this->time(middle) < time) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

std::int64_t SeriesBuffer::nearest(double time, double tolerance) const {
    if (isEmpty()) {
        return -1;
    }
    std::int64_t at = lowerBound(time);
    if (at == end_ || (at > first() && time - this->time(at - 1) < this->time(at) - time)) {
        --at;
    }
    return std::abs(this->time(at) - time) <= tolerance ? at : -1;
}

void SeriesBuffer::cut(double start, double width, int columns, ColumnGrid& grid) const {
    const auto count = static_cast<std::size_t>(std::max(columns, 0));
    const double shift = (start - grid.start) / width;
    const bool sameRaster = grid.width == width && grid.columns() == columns &&
                            std::abs(shift - std::round(shift)) < 1e-6 &&
                            std::abs(shift) < static_cast<double>(count) && grid.end <= end_;
    const auto by = sameRaster ? static_cast<std::ptrdiff_t>(std::lround(shift)) : 0;
    // An edge stays where it was if it had samples on both sides and still has.
    const auto keeps = [&](std::int64_t edge) {
        return edge > first() && edge > grid.first && edge < grid.end;
    };
    std::vector<std::int64_t> edges(count + 1);
    std::vector<std::uint8_t> gaps(count);
    for (std::size_t i = 0; i <= count; ++i) {
        const std::ptrdiff_t old = static_cast<std::ptrdiff_t>(i) + by;
        const bool known = sameRaster && old >= 0 && old <= static_cast<std::ptrdiff_t>(count) &&
                           keeps(grid.edges[static_cast<std::size_t>(old)]);
        if (known) {
            edges[i] = grid.edges[static_cast<std::size_t>(old)];
        } else if (i == 0) {
            edges[i] = lowerBound(start);
        } else {
            // This column holds about as many samples as the one before.
            const std::int64_t previous = i == 1 ? 0 : edges[i - 1] - edges[i - 2];
            edges[i] = lowerBoundNear(start + static_cast<double>(i) * width, edges[i - 1] + previous);
        }
        if (i > 0) {
            const auto j = static_cast<std::size_t>(std::max<std::ptrdiff_t>(old - 1, 0));
            const bool sameColumn = known && old > 0 && grid.edges[j] == edges[i - 1] && keeps(edges[i - 1]);
            gaps[i - 1] = sameColumn ? grid.gapBefore[j] : (hasGap(edges[i - 1], edges[i]) ? 1 : 0);
        }
    }
    grid.edges.swap(edges);
    grid.gapBefore.swap(gaps);
    grid.start = start;
    grid.width = width;
    grid.first = first();
    grid.end = end_;
}

int SeriesBuffer::widestLevel(std::int64_t at, std::int64_t stop) const {
    int level = 0;
    while (level < levelCount_) {
        const std::int64_t size = std::int64_t{1} << (kFanoutBits * (level + 1));
        if ((at & (size - 1)) != 0 || at + size > stop) {
            break;
        }
        ++level;
    }
    return level;
}

MinMax SeriesBuffer::minMax(int signal, std::int64_t begin, std::int64_t end) const {
    const Signal& s = signals_[static_cast<std::size_t>(signal)];
    MinMax sum;
    std::int64_t at = std::max(begin, first());
    const std::int64_t stop = std::min(end, end_);
    while (at < stop) {
        const int level = widestLevel(at, stop);
        if (level == 0) {
            sum.add(s.values[slot(at)]);
            ++at;
        } else {
            sum.add(s.levels[static_cast<std::size_t>(level - 1)]
                            [levelSlot(level - 1, at >> (kFanoutBits * level))]);
            at += std::int64_t{1} << (kFanoutBits * level);
        }
    }
    return sum;
}

bool SeriesBuffer::hasGap(std::int64_t begin, std::int64_t end) const {
    std::int64_t at = std::max(begin, first());
    const std::int64_t stop = std::min(end, end_);
    while (at < stop) {
        const int level = widestLevel(at, stop);
        const bool gap = level == 0 ? gaps_[slot(at)] != 0
                                    : gapLevels_[static_cast<std::size_t>(level - 1)]
                                                [levelSlot(level - 1, at >> (kFanoutBits * level))] != 0;
        if (gap) {
            return true;
        }
        at += std::int64_t{1} << (kFanoutBits * level);
    }
    return false;
}

void SeriesBuffer::envelope(int signal, const ColumnGrid& grid, std::vector<MinMax>& out) const {
    const auto count = static_cast<std::size_t>(grid.columns());
    out.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = minMax(signal, grid.edges[i], grid.edges[i + 1]);
    }
}

std::vector<MinMax> SeriesBuffer::envelope(int signal, double t0, double t1, int columns) const {
    std::vector<MinMax> out;
    if (columns > 0 && t1 > t0) {
        ColumnGrid grid;
        cut(t0, (t1 - t0) / columns, columns, grid);
        envelope(signal, grid, out);
    }
    return out;
}

}  // namespace tiller
