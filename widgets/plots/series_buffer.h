// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The history behind the plots: one column of times and one column of values per signal, in rings of a fixed
// size, with levels of minima and maxima above them. Whatever is asked of it costs as much as there are pixel
// columns in the answer, not as there are samples in the history. The oldest samples fall out.

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace tiller {

/// Which samples belong to which pixel column. Column i holds the samples edges[i] ... edges[i + 1] - 1,
/// those with start + i * width <= time < start + (i + 1) * width. Made once a frame and shared by all
/// curves.
struct ColumnGrid {
    double start = 0;  ///< time of the left edge of column 0 [s]
    double width = 0;  ///< of a column [s]
    std::vector<std::int64_t> edges;
    std::vector<std::uint8_t> gapBefore;  ///< samples were lost right before one of this column's samples

    std::int64_t first = 0;  ///< of the history when the grid was cut
    std::int64_t end = 0;

    int columns() const { return static_cast<int>(gapBefore.size()); }
    bool empty() const { return edges.empty() || edges.front() == edges.back(); }
};

/// Smallest and largest value of one column; min > max when the column has no value.
struct MinMax {
    float min = std::numeric_limits<float>::infinity();
    float max = -std::numeric_limits<float>::infinity();

    bool isEmpty() const { return !(min <= max); }
    void add(const MinMax& other) {
        min = other.min < min ? other.min : min;
        max = other.max > max ? other.max : max;
    }
    void add(float value) {
        min = value < min ? value : min;
        max = value > max ? value : max;
    }
    friend bool operator==(const MinMax&, const MinMax&) = default;
};

/// Threads  one (GUI)
class SeriesBuffer {
public:
    /// 35 minutes at 500 Hz.
    static constexpr std::int64_t kDefaultCapacity = std::int64_t{1} << 20;

    /// capacity  samples kept, rounded up to a power of two of at least 4096
    explicit SeriesBuffer(int signalCount, std::int64_t capacity = kDefaultCapacity);

    int signalCount() const { return static_cast<int>(signals_.size()); }
    std::int64_t capacity() const { return mask_ + 1; }
    /// All the memory the buffer will ever use [bytes].
    std::size_t memoryBytes() const;

    /// One row. NaN: this signal has no value at this time.
    /// time       [s], later than that of the row before
    /// gapBefore  samples between this row and the one before were lost
    /// Returns    false, and keeps nothing, if the time does not go forward or is not finite
    bool append(double time, std::span<const float> values, bool gapBefore = false) {
        return appendEach(
            time,
            [&](std::size_t i) {
                return i < values.size() ? values[i] : std::numeric_limits<float>::quiet_NaN();
            },
            gapBefore);
    }
    /// The same, straight from where the values are: source(signal) gives each of them.
    template <class Source>
    bool appendEach(double time, Source source, bool gapBefore) {
        if (!std::isfinite(time) || (end_ > 0 && time <= lastTime())) {
            return false;
        }
        const std::size_t at = slot(end_);
        times_[at] = time;
        gaps_[at] = gapBefore ? 1 : 0;
        for (std::size_t i = 0; i < signals_.size(); ++i) {
            signals_[i].values[at] = source(i);
        }
        ++end_;
        completeLevels();
        return true;
    }

    /// Samples are numbered from the first one ever appended: first() is the oldest still kept, end() the
    /// next one to come.
    std::int64_t first() const { return end_ > capacity() ? end_ - capacity() : 0; }
    std::int64_t end() const { return end_; }
    bool isEmpty() const { return end_ == 0; }
    double firstTime() const { return isEmpty() ? 0 : time(first()); }
    double lastTime() const { return isEmpty() ? 0 : time(end_ - 1); }

    double time(std::int64_t sample) const { return times_[slot(sample)]; }
    float value(int signal, std::int64_t sample) const {
        return signals_[static_cast<std::size_t>(signal)].values[slot(sample)];
    }
    bool gapBefore(std::int64_t sample) const { return gaps_[slot(sample)] != 0; }
    /// The first sample at or after this time; end() if there is none.
    std::int64_t lowerBound(double time) const;
    /// The sample nearest to this time, or -1 if none is within `tolerance` [s].
    std::int64_t nearest(double time, double tolerance) const;

    /// Cuts start ... start + columns * width into columns. A grid that was cut from this history before and
    /// lies on the same raster of time keeps what has not changed: a moving view costs only its new columns.
    void cut(double start, double width, int columns, ColumnGrid& grid) const;
    /// Minimum and maximum per column of the grid, exactly.
    void envelope(int signal, const ColumnGrid& grid, std::vector<MinMax>& out) const;
    std::vector<MinMax> envelope(int signal, double t0, double t1, int columns) const;
    /// Over the samples begin ... end - 1.
    MinMax minMax(int signal, std::int64_t begin, std::int64_t end) const;
    /// True when samples were lost right before one of the samples begin ... end - 1.
    bool hasGap(std::int64_t begin, std::int64_t end) const;

private:
    static constexpr int kFanoutBits = 3;  // eight entries of one level make one of the next

    struct Signal {
        std::unique_ptr<float[]> values;
        std::vector<std::unique_ptr<MinMax[]>> levels;  // levels[k]: 8^(k + 1) samples an entry
    };

    std::size_t slot(std::int64_t sample) const { return static_cast<std::size_t>(sample & mask_); }
    std::size_t levelSlot(int level, std::int64_t entry) const {
        return static_cast<std::size_t>(entry & (mask_ >> (kFanoutBits * (level + 1))));
    }
    void completeLevels();
    /// The level of the widest entry that begins at `at` and ends before `stop`; 0: the sample itself.
    int widestLevel(std::int64_t at, std::int64_t stop) const;
    /// First sample >= time, looking outwards from a guess.
    std::int64_t lowerBoundNear(double time, std::int64_t guess) const;

    std::int64_t mask_;
    int levelCount_;
    std::int64_t end_ = 0;
    std::unique_ptr<double[]> times_;
    std::unique_ptr<std::uint8_t[]> gaps_;
    std::vector<std::unique_ptr<std::uint8_t[]>> gapLevels_;
    std::vector<Signal> signals_;
};

}  // namespace tiller
