// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Samples like those of a receiver. A test creates them and passes them on frame by frame.

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robot/station/link/sample_batch.h"

namespace tiller::test {

struct SampleStream {
    std::shared_ptr<const receive::SampleLayout> layout =
        std::make_shared<const receive::SampleLayout>(std::vector<std::string>{
            "timestamp", "actual_TCP_force", "actual_current", "standard_analog_input0"});
    std::vector<receive::Sample> samples;
    std::uint64_t lost = 0;

    /// time      controller time stamp [s]
    /// sequence  packet number, from 1
    receive::Sample& add(double time, std::uint64_t sequence) {
        receive::Sample& sample = samples.emplace_back(layout);
        sample.sequence = sequence;
        sample.connection = 1;
        set(sample, "timestamp", time);
        return sample;
    }
    /// component  name as in recordings, e.g. "actual_current_0"
    void set(receive::Sample& sample, const char* component, double value) const {
        sample.values.at(layout->indexOfComponent(component).value()) = value;
    }
    /// Passes the samples since the last frame to `take` and discards them afterwards.
    template <class Take>
    auto frame(Take take) {
        const std::vector<receive::Sample> gone = std::exchange(samples, {});
        return take(SampleBatch{gone, std::exchange(lost, 0)});
    }
};

}  // namespace tiller::test
