// SPDX-License-Identifier: MIT
#include "robot/station/history/series_column.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif
#include <algorithm>
#include <cstring>
#include <limits>
#include <new>

namespace tiller {

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void* SeriesColumn::OnCacheLine::operator new(std::size_t size, std::align_val_t) {
    static_assert(__STDCPP_DEFAULT_NEW_ALIGNMENT__ >= sizeof(void*));
    auto* const given = static_cast<std::byte*>(::operator new(size + kCacheLine));
    std::byte* const line = given + (kCacheLine - reinterpret_cast<std::uintptr_t>(given) % kCacheLine);
    std::memcpy(line - sizeof given, &given, sizeof given);  // stored for operator delete
    return line;
}

void SeriesColumn::OnCacheLine::operator delete(void* at, std::align_val_t) {
    std::byte* given = nullptr;
    std::memcpy(&given, static_cast<std::byte*>(at) - sizeof given, sizeof given);
    ::operator delete(given);
}

/// Comparisons with NaN are false, so NaN is ignored.
template <class Value>
struct SeriesColumn::RunningExtent {
    Value min = std::numeric_limits<Value>::infinity();
    Value max = -std::numeric_limits<Value>::infinity();

    void add(Value low, Value high) {
        min = low < min ? low : min;
        max = high > max ? high : max;
    }
    void add(const Extent<Value>* entries, std::size_t count) {
#ifdef __SSE2__
        if constexpr (sizeof(Value) == sizeof(float)) {
            addFloats(entries, count);
            return;
        }
#endif
        for (std::size_t i = 0; i < count; ++i) {
            add(entries[i].min, entries[i].max);
        }
    }
    /// Four independent accumulators shorten the dependency chain.
    static RunningExtent of(const Value* rows, std::size_t count) {
#ifdef __SSE2__
        if constexpr (sizeof(Value) == sizeof(float)) {
            return ofFloats(rows, count);
        }
#endif
        std::array<RunningExtent, 4> strands;
        const std::size_t whole = count - count % strands.size();
        for (std::size_t i = 0; i < whole; i += strands.size()) {
            for (std::size_t k = 0; k < strands.size(); ++k) {
                strands[k].add(rows[i + k], rows[i + k]);
            }
        }
        for (std::size_t i = whole; i < count; ++i) {
            strands[0].add(rows[i], rows[i]);
        }
        for (std::size_t k = 1; k < strands.size(); ++k) {
            strands[0].add(strands[k].min, strands[k].max);
        }
        return strands[0];
    }

#ifdef __SSE2__
private:
    /// Processes two entries per iteration.
    void addFloats(const Extent<float>* entries, std::size_t count) {
        __m128 low = _mm_set1_ps(min);
        __m128 high = _mm_set1_ps(max);
        for (std::size_t i = 0; i + 1 < count; i += 2) {
            const __m128 two = _mm_loadu_ps(&entries[i].min);
            low = _mm_min_ps(two, low);
            high = _mm_max_ps(two, high);
        }
        low = _mm_min_ps(low, _mm_movehl_ps(low, low));
        high = _mm_max_ps(high, _mm_movehl_ps(high, high));
        min = _mm_cvtss_f32(low);
        max = _mm_cvtss_f32(_mm_shuffle_ps(high, high, 1));
        if (count % 2 != 0) {
            add(entries[count - 1].min, entries[count - 1].max);
        }
    }
    /// Processes eight values per iteration. If an operand is NaN, min and max return the second operand. The
    /// values are the first operand, so NaN is ignored.
    static RunningExtent ofFloats(const float* rows, std::size_t count) {
        const RunningExtent none;
        __m128 min[2] = {_mm_set1_ps(none.min), _mm_set1_ps(none.min)};
        __m128 max[2] = {_mm_set1_ps(none.max), _mm_set1_ps(none.max)};
        const std::size_t whole = count - count % 8;
        for (std::size_t i = 0; i < whole; i += 8) {
            for (std::size_t k = 0; k < 2; ++k) {
                const __m128 four = _mm_loadu_ps(rows + i + 4 * k);
                min[k] = _mm_min_ps(four, min[k]);
                max[k] = _mm_max_ps(four, max[k]);
            }
        }
        alignas(16) std::array<float, 4> low{};
        alignas(16) std::array<float, 4> high{};
        _mm_store_ps(low.data(), _mm_min_ps(min[0], min[1]));
        _mm_store_ps(high.data(), _mm_max_ps(max[0], max[1]));
        RunningExtent sum;
        for (std::size_t k = 0; k < low.size(); ++k) {
            sum.add(low[k], high[k]);
        }
        for (std::size_t i = whole; i < count; ++i) {
            sum.add(rows[i], rows[i]);
        }
        return sum;
    }
#endif
};

SeriesColumn::SeriesColumn(Precision precision, std::int64_t rowsBefore) : precision_(precision) {
    add(static_cast<std::size_t>(std::max<std::int64_t>(rowsBefore, 0)),
        [](std::size_t) { return kNoValue; });
}

void SeriesColumn::beginBlock() {
    blocks_.emplace_back();
    bytes_ += sizeof(Block);
}

void SeriesColumn::dropBlock() {
    const Block& oldest = blocks_.front();
    bytes_ -= sizeof(Block) + (oldest.single ? sizeof(*oldest.single) : 0) +
              (oldest.exact ? sizeof(*oldest.exact) : 0);
    blocks_.erase(blocks_.begin());
    rows_ -= kBlockRows;
}

template <class Value>
void SeriesColumn::spread(Block& block, std::size_t rows) {
    auto& values = valuesOf<Value>(block);
    values = std::make_unique_for_overwrite<Values<Value>>();
    bytes_ += sizeof(*values);
    std::fill_n(values->rows.begin(), rows, static_cast<Value>(block.constant));
    constexpr std::size_t kFine = std::size_t{1} << kFineBits;
    for (std::size_t done = kFine; done <= rows; done += kFine) {
        completeLevels(*values, done);
    }
}

template <class Value>
void SeriesColumn::completeLevels(Values<Value>& values, std::size_t rows) {
    constexpr std::size_t kFine = std::size_t{1} << kFineBits;
    constexpr std::size_t kCoarse = std::size_t{1} << kCoarseBits;
    const auto fine = RunningExtent<Value>::of(&values.rows[rows - kFine], kFine);
    values.levels.fine[(rows >> kFineBits) - 1] = {fine.min, fine.max};
    if (rows % kCoarse == 0) {
        completeCoarse(values.levels, (rows >> kCoarseBits) - 1);
    }
}

template <class Value>
void SeriesColumn::completeCoarse(Levels<Value>& levels, std::size_t entry) {
    constexpr std::size_t kFineInCoarse = std::size_t{1} << (kCoarseBits - kFineBits);
    RunningExtent<Value> coarse;
    coarse.add(&levels.fine[entry * kFineInCoarse], kFineInCoarse);
    levels.coarse[entry] = {coarse.min, coarse.max};
}

void SeriesColumn::completeBlock(Block& block) {
    block.whole = {};
    const auto addAll = [&block](const auto& coarse) {
        for (const auto& entry : coarse) {
            block.whole.add(MinMax{static_cast<double>(entry.min), static_cast<double>(entry.max)});
        }
    };
    if (block.single) {
        addAll(block.single->levels.coarse);
    } else if (block.exact) {
        addAll(block.exact->levels.coarse);
    } else {
        block.whole.add(block.constant);
    }
}

/// begin, end  must be multiples of kSummary
template <class Value>
SeriesColumn::RunningExtent<Value> SeriesColumn::extentOf(const Levels<Value>& levels, std::size_t begin,
                                                          std::size_t end) {
    constexpr std::size_t kCoarse = std::size_t{1} << kCoarseBits;
    RunningExtent<Value> range;
    const auto addFine = [&](std::size_t from, std::size_t to) {
        range.add(&levels.fine[from >> kFineBits], (to - from) >> kFineBits);
    };
    const std::size_t firstCoarse = (begin + kCoarse - 1) & ~(kCoarse - 1);
    const std::size_t lastCoarse = end & ~(kCoarse - 1);
    if (firstCoarse >= lastCoarse) {
        addFine(begin, end);
    } else {
        addFine(begin, firstCoarse);
        range.add(&levels.coarse[firstCoarse >> kCoarseBits], (lastCoarse - firstCoarse) >> kCoarseBits);
        addFine(lastCoarse, end);
    }
    return range;
}

template <class Value>
void SeriesColumn::addRange(const Values<Value>& values, std::size_t begin, std::size_t end, MinMax& sum) {
    constexpr std::size_t kFine = std::size_t{1} << kFineBits;
    RunningExtent<Value> range;
    const auto addRows = [&](std::size_t from, std::size_t to) {
        const auto part = RunningExtent<Value>::of(&values.rows[from], to - from);
        range.add(part.min, part.max);
    };
    const std::size_t firstFine = (begin + kFine - 1) & ~(kFine - 1);
    const std::size_t lastFine = end & ~(kFine - 1);
    if (firstFine >= lastFine) {
        addRows(begin, end);
    } else {
        if (begin < firstFine) {
            addRows(begin, firstFine);
        }
        const auto whole = extentOf(values.levels, firstFine, lastFine);
        range.add(whole.min, whole.max);
        if (lastFine < end) {
            addRows(lastFine, end);
        }
    }
    sum.add(MinMax{static_cast<double>(range.min), static_cast<double>(range.max)});
}

void SeriesColumn::addOutline(const Outline& outline, std::size_t begin, std::size_t end, MinMax& sum) {
    constexpr std::size_t kFine = std::size_t{1} << kFineBits;
    const std::size_t from = begin & ~(kFine - 1);
    const std::size_t to = (end + kFine - 1) & ~(kFine - 1);
    const auto add = [&sum](const auto& range) {
        sum.add(MinMax{static_cast<double>(range.min), static_cast<double>(range.max)});
    };
    if (outline.single) {
        add(extentOf(*outline.single, from, to));
    } else if (outline.exact) {
        add(extentOf(*outline.exact, from, to));
    } else {
        constexpr auto kHalf = std::size_t(kBlockRows) / 2;
        for (std::size_t half = begin / kHalf; half <= (end - 1) / kHalf; ++half) {
            sum.add(outline.halves[half]);
        }
    }
}

void SeriesColumn::outline(std::int64_t rows) {
    blocks_.clear();
    rows_ = rows;
    bytes_ = 0;
    blocks_.reserve(static_cast<std::size_t>((rows + kBlockRows - 1) / kBlockRows));
    for (std::int64_t row = 0; row < rows; row += kBlockRows) {
        Block& block = blocks_.emplace_back();
        block.constant = kNoValue;
        block.outline = std::make_unique<Outline>();
        block.grain = kUnknown;
        bytes_ += sizeof(Block) + sizeof(Outline);
    }
}

template <class Value>
void SeriesColumn::setExtent(std::unique_ptr<Levels<Value>>& levels, std::size_t at, std::size_t rows,
                             const MinMax& extent) {
    if (!levels) {
        levels = std::make_unique_for_overwrite<Levels<Value>>();
        bytes_ += sizeof(*levels);
        const RunningExtent<Value> none;
        levels->fine.fill({none.min, none.max});
        levels->coarse.fill({none.min, none.max});
    }
    const Extent<Value> entry{static_cast<Value>(extent.min), static_cast<Value>(extent.max)};
    const std::size_t end = at + rows;
    std::fill(levels->fine.begin() + static_cast<std::ptrdiff_t>(at >> kFineBits),
              levels->fine.begin() + static_cast<std::ptrdiff_t>(end >> kFineBits), entry);
    // A coarse entry is recomputed for each of its parts, so it is complete after the last part.
    for (std::size_t coarse = at >> kCoarseBits; coarse <= (end - 1) >> kCoarseBits; ++coarse) {
        completeCoarse(*levels, coarse);
    }
}

void SeriesColumn::setExtents(std::int64_t first, std::int64_t rowsEach, std::span<const MinMax> extents) {
    // Process at most one block per step.
    const std::int64_t step = std::min(rowsEach, kBlockRows);
    const std::int64_t end = std::min(rows_, first + static_cast<std::int64_t>(extents.size()) * rowsEach);
    for (std::int64_t row = first; row < end; row += step) {
        const MinMax& extent = extents[static_cast<std::size_t>((row - first) / rowsEach)];
        Block& block = blocks_[static_cast<std::size_t>(row >> kBlockBits)];
        Outline& known = *block.outline;
        const auto at = static_cast<std::size_t>(row & (kBlockRows - 1));
        if (step >= kBlockRows / 2) {
            known.halves[at == 0 ? 0 : 1] = extent;
            known.halves[1] = step == kBlockRows ? extent : known.halves[1];
            if (block.grain != 1) {
                block.whole = {};
                block.whole.add(known.halves[0]);
                block.whole.add(known.halves[1]);
            }
        } else {
            if (precision_ == Precision::Single) {
                setExtent(known.single, at, static_cast<std::size_t>(step), extent);
            } else {
                setExtent(known.exact, at, static_cast<std::size_t>(step), extent);
            }
            if (block.grain != 1) {
                block.whole.add(extent);
            }
        }
        known.grain = std::min(known.grain, rowsEach);
        block.grain = block.grain == 1 ? 1 : known.grain;
    }
}

template <class Value>
void SeriesColumn::setRowsAs(Block& block, std::span<const double> values) {
    const std::size_t count = std::min(values.size(), std::size_t(kBlockRows));
    const auto first = static_cast<Value>(count == 0 ? kNoValue : values[0]);
    block.constant = static_cast<double>(first);
    const bool same =
        std::all_of(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count),
                    [&](double value) { return isSame(static_cast<Value>(value), block.constant); });
    if (same) {
        return;
    }
    auto& into = valuesOf<Value>(block);
    into = std::make_unique_for_overwrite<Values<Value>>();
    bytes_ += sizeof(*into);
    std::transform(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count), into->rows.begin(),
                   [](double value) { return static_cast<Value>(value); });
    constexpr std::size_t kFine = std::size_t{1} << kFineBits;
    for (std::size_t done = kFine; done <= count; done += kFine) {
        completeLevels(*into, done);
    }
}

void SeriesColumn::setRows(std::int64_t number, std::span<const double> values) {
    Block& block = blocks_[static_cast<std::size_t>(number)];
    if (block.grain == 1) {
        return;
    }
    if (precision_ == Precision::Single) {
        setRowsAs<float>(block, values);
    } else {
        setRowsAs<double>(block, values);
    }
    block.grain = 1;
    if (values.size() == std::size_t(kBlockRows)) {
        completeBlock(block);
    }
}

void SeriesColumn::forgetRows(std::int64_t number) {
    Block& block = blocks_[static_cast<std::size_t>(number)];
    if (!block.outline || block.grain != 1) {
        return;
    }
    bytes_ -= (block.single ? sizeof(*block.single) : 0) + (block.exact ? sizeof(*block.exact) : 0);
    block.single.reset();
    block.exact.reset();
    block.constant = kNoValue;
    block.grain = block.outline->grain;
}

MinMax SeriesColumn::minMax(std::int64_t begin, std::int64_t end) const {
    MinMax sum;
    std::int64_t at = std::max<std::int64_t>(begin, 0);
    const std::int64_t stop = std::min(end, rows_);
    while (at < stop) {
        const Block& block = blocks_[static_cast<std::size_t>(at >> kBlockBits)];
        const std::int64_t blockBegin = at & ~(kBlockRows - 1);
        const std::int64_t to = std::min(stop, blockBegin + kBlockRows);
        const auto from = static_cast<std::size_t>(at - blockBegin);
        const auto until = static_cast<std::size_t>(to - blockBegin);
        if (from == 0 && to - at == kBlockRows) {
            sum.add(block.whole);
        } else if (block.grain != 1) {
            addOutline(*block.outline, from, until, sum);
        } else if (block.single) {
            addRange(*block.single, from, until, sum);
        } else if (block.exact) {
            addRange(*block.exact, from, until, sum);
        } else {
            sum.add(block.constant);
        }
        at = to;
    }
    return sum;
}

template void SeriesColumn::spread<float>(Block&, std::size_t);
template void SeriesColumn::spread<double>(Block&, std::size_t);
template void SeriesColumn::completeLevels<float>(Values<float>&, std::size_t);
template void SeriesColumn::completeLevels<double>(Values<double>&, std::size_t);

}  // namespace tiller
