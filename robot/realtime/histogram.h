// SPDX-License-Identifier: MIT
#pragma once

// Counts durations into fixed buckets, so that jitter can be told in percentiles at the end without keeping
// every value.

#include <array>
#include <cstdint>

namespace tiller::realtime {

/// Buckets grow with the value: 1/16 of it at most, so a percentile is right to about 6 %. Covers 0 to about
/// 68 s; longer values are counted in the last bucket.
/// Threads  one. Real-time: yes (no allocation)
class Histogram {
public:
    /// ns  negative values count as 0
    void add(std::int64_t ns);
    void clear();                        ///< Empty again.
    void merge(const Histogram& other);  ///< Adds what the other has counted.

    std::uint64_t count() const { return count_; }                 ///< Number of values.
    std::int64_t minNs() const { return count_ == 0 ? 0 : min_; }  ///< 0 when empty.
    std::int64_t maxNs() const { return max_; }                    ///< 0 when empty.
    /// 0 when empty.
    double meanNs() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }
    /// percent  0 ... 100. The upper edge of the bucket in which the value lies, never above maxNs(); 0 when
    ///          empty
    std::int64_t percentileNs(double percent) const;
    /// How many values were above a threshold, to the accuracy of the buckets.
    std::uint64_t countAbove(std::int64_t ns) const;

private:
    static constexpr int kSubBits = 4;  // 16 buckets for every doubling
    static constexpr int kSub = 1 << kSubBits;
    static constexpr int kDoublings = 33;
    static constexpr std::size_t kBuckets = (kDoublings + 1) * kSub;

    static std::size_t bucketOf(std::int64_t ns);
    static std::int64_t upperEdge(std::size_t bucket);

    std::array<std::uint64_t, kBuckets> buckets_{};
    std::uint64_t count_ = 0;
    std::int64_t min_ = 0;
    std::int64_t max_ = 0;
    double sum_ = 0;
};

}  // namespace tiller::realtime
