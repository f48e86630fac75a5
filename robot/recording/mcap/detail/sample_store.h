// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "robot/receive/sample.h"

namespace tiller::recording {

/// Stores the samples of the last minute in preallocated memory.
class SampleStore {
public:
    SampleStore(std::size_t capacity, const std::shared_ptr<const receive::SampleLayout>& layout)
        : samples_(capacity, receive::Sample(layout)), missing_(capacity, 0) {}

    /// Returns the slot for the next sample. If all slots are in use, this is the slot of the oldest sample.
    receive::Sample& next() { return samples_[(first_ + count_) % samples_.size()]; }
    void keepNext(std::uint64_t missing) {
        missing_[(first_ + count_) % samples_.size()] = missing;
        ++count_;
        if (count_ == samples_.size()) {
            dropOldest();
        }
    }
    void dropOldest() {
        first_ = (first_ + 1) % samples_.size();
        --count_;
    }
    std::size_t count() const { return count_; }
    const receive::Sample& at(std::size_t i) const { return samples_[(first_ + i) % samples_.size()]; }
    std::uint64_t missingBefore(std::size_t i) const { return missing_[(first_ + i) % samples_.size()]; }

private:
    std::vector<receive::Sample> samples_;
    std::vector<std::uint64_t> missing_;
    std::size_t first_ = 0;
    std::size_t count_ = 0;
};

}  // namespace tiller::recording
