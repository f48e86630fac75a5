// SPDX-License-Identifier: MIT
#pragma once

// Counts durations in fixed buckets to report jitter percentiles without storing every value.

#include <array>
#include <cstdint>

namespace tiller::realtime {

/// The bucket width is at most 1/16 of the value, so that percentiles are accurate to about 6 %. Covers 0 to about
/// 68 s; longer values are counted in the last bucket.
/// Threads  one. Real-time: yes (no allocation)
class Histogram {
public:
    /// ns  negative values count as 0
    void add(std::int64_t ns);
    void clear();
    void merge(const Histogram& other);  ///< Adds the counts of `other`.

    std::uint64_t count() const { return count_; }
    std::int64_t minNs() const { return count_ == 0 ? 0 : min_; }  ///< 0 when empty.
    std::int64_t maxNs() const { return max_; }                    ///< 0 when empty.
    /// 0 when empty.
    double meanNs() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }
    /// percent  0 ... 100
    /// Returns  the upper limit of the bucket of this percentile, at most maxNs(); 0 when empty
    std::int64_t percentileNs(double percent) const;
    /// Number of values above a threshold, with the resolution of the buckets.
    std::uint64_t countAbove(std::int64_t ns) const;

private:
    static constexpr int kSubBits = 4;  // 16 buckets per doubling of the value
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
