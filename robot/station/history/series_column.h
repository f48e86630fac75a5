// SPDX-License-Identifier: MIT
#pragma once

// The values of one signal in blocks, with levels of minima and maxima within each block. A block with a
// constant value stores only that value, so registers, modes and bit fields need very little memory.
//
// For a column stored in a file, only extents of several rows may be known. Queries for rows that are not in
// memory use these extents. The result then covers at least the requested rows, and possibly more.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "robot/station/history/min_max.h"

namespace tiller {

enum class Precision : std::uint8_t {
    Single,  ///< stored as float; for measured values
    Exact,   ///< stored as double; for integers and bit fields
};

/// Rows are counted from the oldest row kept.
/// Threads  one
class SeriesColumn {
public:
    static constexpr int kBlockBits = 12;
    static constexpr std::int64_t kBlockRows = std::int64_t{1} << kBlockBits;
    /// Row ranges that begin and end at multiples of this value are evaluated from summaries only.
    static constexpr std::int64_t kSummary = 32;
    /// Like kSummary, with an eighth of the summaries to read.
    static constexpr std::int64_t kCoarseSummary = 256;
    /// Resolution of a block without extents. Exceeds the number of rows of any extent.
    static constexpr std::int64_t kUnknown = std::int64_t{1} << 40;

    /// rowsBefore  number of rows that the other columns already have; this column has no values for them
    explicit SeriesColumn(Precision precision, std::int64_t rowsBefore = 0);

    Precision precision() const { return precision_; }
    std::int64_t rows() const { return rows_; }
    /// Memory of the values and their levels [bytes].
    std::size_t bytes() const { return bytes_; }

    /// Appends `count` rows. source(row) returns each value; NaN: no value.
    template <class Source>
    void add(std::size_t count, Source source) {
        if (precision_ == Precision::Single) {
            addAs<float>(count, source);
        } else {
            addAs<double>(count, source);
        }
    }
    /// Drops the oldest block.
    void dropBlock();

    // The following functions are for a column stored in a file.

    /// Adds rows that are stored in the file and whose values are not known yet. The column must not have any
    /// other rows.
    void outline(std::int64_t rows);
    /// Sets extents of `rowsEach` rows each, starting at a multiple of rowsEach. An empty extent has no
    /// values.
    /// rowsEach  a multiple of kSummary that divides the block size, or a multiple of the block size
    void setExtents(std::int64_t first, std::int64_t rowsEach, std::span<const MinMax> extents);
    void setRows(std::int64_t block, std::span<const double> values);
    /// Releases the values of a block and restores the state before setRows().
    void forgetRows(std::int64_t block);
    /// Rows per known extent of this block: initially kUnknown; 1 if its rows are in memory.
    std::int64_t resolutionOf(std::int64_t block) const {
        return blocks_[static_cast<std::size_t>(block)].grain;
    }

    double value(std::int64_t row) const {
        const Block& block = blocks_[static_cast<std::size_t>(row >> kBlockBits)];
        const auto at = static_cast<std::size_t>(row & (kBlockRows - 1));
        return block.single  ? static_cast<double>(block.single->rows[at])
               : block.exact ? block.exact->rows[at]
                             : block.constant;
    }
    /// Prefetches the memory that minMax() reads for this row. Otherwise, each access to distant rows waits
    /// for a cache miss.
    void fetchAhead(std::int64_t row) const {
#if defined(__GNUC__)
        if (row < 0 || row >= rows_) {
            return;
        }
        const Block& block = blocks_[static_cast<std::size_t>(row >> kBlockBits)];
        const auto at = static_cast<std::size_t>(row & (kBlockRows - 1));
        if (block.single) {
            if (at % std::size_t(kSummary) != 0) {
                const std::size_t fine = at & ~(std::size_t(kSummary) - 1);
                __builtin_prefetch(&block.single->rows[fine]);
                __builtin_prefetch(&block.single->rows[fine + std::size_t(kSummary) / 2]);
            }
            if (at % std::size_t(kCoarseSummary) != 0) {
                __builtin_prefetch(&block.single->levels.fine[at >> kFineBits]);
            }
            __builtin_prefetch(&block.single->levels.coarse[at >> kCoarseBits]);
        }
#endif
    }
    /// Exact minimum and maximum over the rows begin ... end - 1.
    MinMax minMax(std::int64_t begin, std::int64_t end) const;

private:
    // log2 of the rows per entry of the first level. Eight of these entries form one entry of the second
    // level.
    static constexpr int kFineBits = 5;
    static_assert(std::int64_t{1} << kFineBits == kSummary);
    static constexpr int kCoarseBits = 8;
    static_assert(std::int64_t{1} << kCoarseBits == kCoarseSummary);
    static constexpr std::size_t kFineEntries = std::size_t(kBlockRows >> kFineBits);
    static constexpr std::size_t kCoarseEntries = std::size_t(kBlockRows >> kCoarseBits);

    template <class Value>
    struct Extent {
        Value min, max;
    };
    static constexpr std::size_t kCacheLine = 64;
    /// Allocates memory aligned to a cache line with the ordinary allocator. The aligned allocation of glibc
    /// rarely reuses freed memory, so the memory use of a history that drops and adds blocks would grow for
    /// days.
    struct OnCacheLine {
        static void* operator new(std::size_t size, std::align_val_t);
        static void operator delete(void* at, std::align_val_t);
    };
    /// The fine entries of one coarse entry fill one cache line.
    template <class Value>
    struct alignas(kCacheLine) Levels : OnCacheLine {
        std::array<Extent<Value>, kFineEntries> fine;
        std::array<Extent<Value>, kCoarseEntries> coarse;
    };
    template <class Value>
    struct Values : OnCacheLine {
        std::array<Value, std::size_t(kBlockRows)> rows;
        Levels<Value> levels;
    };
    template <class Value>
    struct RunningExtent;
    /// Summary of a block stored in a file, used while its rows are not in memory.
    struct Outline {
        /// Extents of the two halves of the block, used if there are no levels.
        std::array<MinMax, 2> halves;
        std::unique_ptr<Levels<float>> single;
        std::unique_ptr<Levels<double>> exact;
        std::int64_t grain = kUnknown;
    };
    struct Block {
        double constant = 0;  ///< value of every row if `single` and `exact` are null
        std::unique_ptr<Values<float>> single;
        std::unique_ptr<Values<double>> exact;
        MinMax whole;                      ///< range of a full block
        std::unique_ptr<Outline> outline;  ///< for a block stored in a file
        std::int64_t grain = 1;
    };

    template <class Value>
    static std::unique_ptr<Values<Value>>& valuesOf(Block& block) {
        if constexpr (sizeof(Value) == sizeof(float)) {
            return block.single;
        } else {
            return block.exact;
        }
    }
    template <class Value>
    static bool isSame(Value a, double b) {
        return static_cast<double>(a) == b || (std::isnan(a) && std::isnan(b));
    }
    template <class Value, class Source>
    void addAs(std::size_t count, Source source) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto at = static_cast<std::size_t>(rows_ & (kBlockRows - 1));
            if (at == 0) {
                beginBlock();
            }
            Block& block = blocks_.back();
            auto& values = valuesOf<Value>(block);
            const auto value = static_cast<Value>(source(i));
            if (!values && at == 0) {
                block.constant = static_cast<double>(value);
            } else if (!values && !isSame(value, block.constant)) {
                spread<Value>(block, at);
            }
            ++rows_;
            if (values) {
                values->rows[at] = value;
                if ((rows_ & ((std::int64_t{1} << kFineBits) - 1)) == 0) {
                    completeLevels(*values, at + 1);
                }
            }
            if ((rows_ & (kBlockRows - 1)) == 0) {
                completeBlock(block);
            }
        }
    }
    void beginBlock();
    /// Allocates individual values for a block that is no longer constant.
    template <class Value>
    void spread(Block& block, std::size_t rows);
    template <class Value>
    static void completeLevels(Values<Value>& values, std::size_t rows);
    template <class Value>
    static void completeCoarse(Levels<Value>& levels, std::size_t entry);
    static void completeBlock(Block& block);
    template <class Value>
    static void addRange(const Values<Value>& values, std::size_t begin, std::size_t end, MinMax& sum);
    template <class Value>
    static RunningExtent<Value> extentOf(const Levels<Value>& levels, std::size_t begin, std::size_t end);
    static void addOutline(const Outline& outline, std::size_t begin, std::size_t end, MinMax& sum);
    template <class Value>
    void setExtent(std::unique_ptr<Levels<Value>>& levels, std::size_t at, std::size_t rows,
                   const MinMax& extent);
    template <class Value>
    void setRowsAs(Block& block, std::span<const double> values);

    Precision precision_;
    std::int64_t rows_ = 0;
    std::size_t bytes_ = 0;
    std::vector<Block> blocks_;
};

}  // namespace tiller
