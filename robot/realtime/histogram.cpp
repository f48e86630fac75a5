// SPDX-License-Identifier: MIT
#include "robot/realtime/histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tiller::realtime {

// Values below 16 have one bucket each. For larger values, the five most significant bits select the bucket.
std::size_t Histogram::bucketOf(std::int64_t ns) {
    const auto value = static_cast<std::uint64_t>(std::max<std::int64_t>(ns, 0));
    if (value < kSub) {
        return value;
    }
    const int doubling = static_cast<int>(std::bit_width(value)) - 1 - kSubBits;
    const std::size_t sub = (value >> doubling) & (kSub - 1);
    return std::min(static_cast<std::size_t>(doubling + 1) * kSub + sub, kBuckets - 1);
}

std::int64_t Histogram::upperEdge(std::size_t bucket) {
    if (bucket < kSub) {
        return static_cast<std::int64_t>(bucket);
    }
    const auto doubling = static_cast<int>(bucket / kSub) - 1;
    const auto sub = static_cast<std::int64_t>(bucket % kSub);
    return ((kSub + sub + 1) << doubling) - 1;
}

void Histogram::add(std::int64_t ns) {
    ns = std::max<std::int64_t>(ns, 0);
    ++buckets_[bucketOf(ns)];
    min_ = count_ == 0 ? ns : std::min(min_, ns);
    max_ = std::max(max_, ns);
    sum_ += static_cast<double>(ns);
    ++count_;
}

void Histogram::clear() {
    *this = Histogram();
}

void Histogram::merge(const Histogram& other) {
    if (other.count_ == 0) {
        return;
    }
    for (std::size_t i = 0; i < kBuckets; ++i) {
        buckets_[i] += other.buckets_[i];
    }
    min_ = count_ == 0 ? other.min_ : std::min(min_, other.min_);
    max_ = std::max(max_, other.max_);
    sum_ += other.sum_;
    count_ += other.count_;
}

std::int64_t Histogram::percentileNs(double percent) const {
    if (count_ == 0) {
        return 0;
    }
    const double share = std::clamp(percent, 0.0, 100.0) / 100.0;
    const auto wanted = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_))));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < kBuckets; ++i) {
        seen += buckets_[i];
        if (seen >= wanted) {
            return i == kBuckets - 1 ? max_ : std::min(upperEdge(i), max_);
        }
    }
    return max_;
}

std::uint64_t Histogram::countAbove(std::int64_t ns) const {
    std::uint64_t above = 0;
    for (std::size_t i = bucketOf(ns) + 1; i < kBuckets; ++i) {
        above += buckets_[i];
    }
    return above;
}

}  // namespace tiller::realtime
