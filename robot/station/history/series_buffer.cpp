// SPDX-License-Identifier: MIT
#include "robot/station/history/series_buffer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace tiller {

SeriesBuffer::SeriesBuffer(int columns, const HistoryLimits& limits) : limits_(limits) {
    for (int i = 0; i < columns; ++i) {
        addColumn();
    }
}

int SeriesBuffer::addColumn(Precision precision) {
    columns_.emplace_back(precision, end_ - first_);
    return columnCount() - 1;
}

void SeriesBuffer::setLimits(const HistoryLimits& limits) {
    limits_ = limits;
    trim();
}

std::size_t SeriesBuffer::memoryBytes() const {
    std::size_t bytes = marks_.size() * sizeof(Mark);
    for (const auto& block : times_) {
        bytes += block ? sizeof(TimeBlock) : 0;
    }
    for (const SeriesColumn& column : columns_) {
        bytes += column.bytes();
    }
    return bytes;
}

bool SeriesBuffer::append(double time, std::span<const float> values, bool gapBefore) {
    if (!std::isfinite(time) || (end_ > 0 && time <= lastTime())) {
        return false;
    }
    const Row row{time, gapBefore};
    appendRows(std::span(&row, 1), [&](std::size_t column, std::size_t) {
        return column < values.size() ? values[column] : std::numeric_limits<float>::quiet_NaN();
    });
    return true;
}

void SeriesBuffer::addTime(const Row& row) {
    const auto at = static_cast<std::size_t>((end_ - first_) & kInBlock);
    if (at == 0) {
        times_.push_back(std::make_unique_for_overwrite<TimeBlock>());
        times_.back()->gaps.fill(0);
        times_.back()->gapCount = 0;
    }
    TimeBlock& block = *times_.back();
    block.times[at] = row.time;
    if (row.gapBefore) {
        block.gaps[at / 64] |= std::uint64_t{1} << (at % 64);
        ++block.gapCount;
    }
    ++end_;
}

void SeriesBuffer::trim() {
    if (file_ != nullptr) {
        return;
    }
    while (times_.size() > 1 &&
           (times_.front()->times.back() < lastTime() - limits_.seconds || memoryBytes() > limits_.bytes)) {
        times_.erase(times_.begin());
        for (SeriesColumn& column : columns_) {
            column.dropBlock();
        }
        first_ += SeriesColumn::kBlockRows;
    }
}

std::int64_t SeriesBuffer::lowerBoundBetween(double time, std::int64_t low, std::int64_t high) const {
    while (low < high) {
        const std::int64_t middle = low + (high - low) / 2;
        if (roughTime(middle) < time) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

std::int64_t SeriesBuffer::lowerBound(double time) const {
    const std::int64_t rough = lowerBoundBetween(time, first_, end_);
    if (file_ == nullptr) {
        return rough;
    }
    // Load the blocks around the sample. Repeat once, because the exact times may move the result to another
    // block.
    std::int64_t found = rough;
    for (int turn = 0; turn < 2; ++turn) {
        for (const std::int64_t sample : {found - 1, found}) {
            if (sample >= first_ && sample < end_) {
                static_cast<void>(this->time(sample));
            }
        }
        found = lowerBoundNear(time, found);
    }
    return found;
}

void SeriesBuffer::lieIn(SampleFile& file, std::int64_t samples, std::vector<Mark> marks,
                         std::vector<std::int64_t> gaps) {
    file_ = &file;
    marks_ = std::move(marks);
    gaps_ = std::move(gaps);
    end_ = samples;
    limits_ = {std::numeric_limits<double>::max(), std::numeric_limits<std::size_t>::max()};
    times_.resize(static_cast<std::size_t>((samples + kInBlock) >> SeriesColumn::kBlockBits));
}

void SeriesBuffer::addGap(std::int64_t sample) {
    const auto next = std::lower_bound(gaps_.begin(), gaps_.end(), sample);
    if (next == gaps_.end() || *next != sample) {
        gaps_.insert(next, sample);
    }
}

bool SeriesBuffer::hasRows(int column, std::int64_t begin, std::int64_t end) const {
    if (file_ == nullptr) {
        return true;
    }
    const SeriesColumn& values = columns_[static_cast<std::size_t>(column)];
    for (std::int64_t block = begin >> SeriesColumn::kBlockBits;
         block <= (end - 1) >> SeriesColumn::kBlockBits; ++block) {
        if (values.resolutionOf(block) != 1) {
            return false;
        }
    }
    return true;
}

int SeriesBuffer::outlineColumn(Precision precision) {
    columns_.emplace_back(precision).outline(end_);
    return columnCount() - 1;
}

void SeriesBuffer::setExtents(int column, std::int64_t first, std::int64_t rowsEach,
                              std::span<const MinMax> extents) {
    columns_[static_cast<std::size_t>(column)].setExtents(first, rowsEach, extents);
    ++revision_;
}

void SeriesBuffer::setTimes(std::int64_t block, std::span<const double> times) {
    auto& into = times_[static_cast<std::size_t>(block)];
    if (!into) {
        into = std::make_unique<TimeBlock>();
    }
    std::copy_n(times.begin(), std::min(times.size(), into->times.size()), into->times.begin());
    ++revision_;
}

void SeriesBuffer::setRows(int column, std::int64_t block, std::span<const double> values) {
    columns_[static_cast<std::size_t>(column)].setRows(block, values);
    ++revision_;
}

void SeriesBuffer::forget(std::int64_t block) {
    times_[static_cast<std::size_t>(block)].reset();
    for (SeriesColumn& column : columns_) {
        column.forgetRows(block);
    }
    ++revision_;
}

void SeriesBuffer::fetch(std::int64_t row) const {
    file_->fill(row >> SeriesColumn::kBlockBits);
}

double SeriesBuffer::timeByMarks(std::int64_t row) const {
    const auto next = std::upper_bound(marks_.begin(), marks_.end(), row,
                                       [](std::int64_t at, const Mark& mark) { return at < mark.sample; });
    if (next == marks_.begin() || next == marks_.end()) {
        return next == marks_.end() ? marks_.back().time : next->time;
    }
    const Mark& before = *(next - 1);
    return before.time + (next->time - before.time) * static_cast<double>(row - before.sample) /
                             static_cast<double>(next->sample - before.sample);
}

std::int64_t SeriesBuffer::lowerBoundNear(double time, std::int64_t guess) const {
    const std::int64_t oldest = first();
    std::int64_t low = std::clamp(guess, oldest, end_);
    std::int64_t high = low;
    // Extend the range until `low` is before the result or at the oldest sample, and `high` is at or after
    // the result.
    for (std::int64_t step = 1; high < end_ && roughTime(high) < time; step *= 2) {
        low = high + 1;
        high = std::min(end_, high + step);
    }
    for (std::int64_t step = 1; low > oldest && !(roughTime(low - 1) < time); step *= 2) {
        high = low - 1;
        low = std::max(oldest, low - step);
    }
    return lowerBoundBetween(time, low, high);
}

std::int64_t SeriesBuffer::lastBefore(double time) const {
    const std::int64_t at = lowerBound(time);
    if (at < end_ && this->time(at) == time) {
        return at;
    }
    return at > first_ ? at - 1 : -1;
}

void SeriesBuffer::cut(double start, double width, int columns, ColumnGrid& grid) const {
    const auto count = static_cast<std::size_t>(std::max(columns, 0));
    const double shift = (start - grid.start) / width;
    const bool sameRaster =
        grid.width == width && grid.columns() == columns && std::abs(shift - std::round(shift)) < 1e-6 &&
        std::abs(shift) < static_cast<double>(count) && grid.end <= end_ && grid.revision == revision_;
    const auto by = sameRaster ? static_cast<std::ptrdiff_t>(std::lround(shift)) : 0;
    // An edge remains valid if it had and still has samples on both sides.
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
            edges[i] = lowerBoundBetween(start, first_, end_);
        } else {
            // Estimate: this column has as many samples as the previous column.
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
    grid.revision = revision_;
}

bool SeriesBuffer::hasGap(std::int64_t begin, std::int64_t end) const {
    if (file_ != nullptr) {
        const auto next = std::lower_bound(gaps_.begin(), gaps_.end(), begin);
        return next != gaps_.end() && *next < end;
    }
    std::int64_t row = std::max(begin, first_) - first_;
    const std::int64_t stop = std::min(end, end_) - first_;
    while (row < stop) {
        const TimeBlock& block = *times_[static_cast<std::size_t>(row >> SeriesColumn::kBlockBits)];
        const std::int64_t blockEnd = (row | kInBlock) + 1;
        if (block.gapCount == 0) {
            row = blockEnd;
            continue;
        }
        const auto at = static_cast<std::size_t>(row & kInBlock);
        const std::int64_t wordEnd = (row | 63) + 1;
        std::uint64_t word = block.gaps[at / 64] >> (at % 64);
        if (stop < wordEnd) {
            word &= (std::uint64_t{1} << (stop - row)) - 1;
        }
        if (word != 0) {
            return true;
        }
        row = wordEnd;
    }
    return false;
}

void SeriesBuffer::envelope(int column, const ColumnGrid& grid, std::vector<MinMax>& out) const {
    const auto count = static_cast<std::size_t>(grid.columns());
    out.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = minMax(column, grid.edges[i], grid.edges[i + 1]);
    }
}

std::vector<MinMax> SeriesBuffer::envelope(int column, double t0, double t1, int columns) const {
    std::vector<MinMax> out;
    if (columns > 0 && t1 > t0) {
        ColumnGrid grid;
        cut(t0, (t1 - t0) / columns, columns, grid);
        envelope(column, grid, out);
    }
    return out;
}

}  // namespace tiller
