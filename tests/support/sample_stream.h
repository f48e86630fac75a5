// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Samples as a receiver would have them, made by a test: as many as it likes, handed over frame by frame.

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

    /// time  the controller's time stamp [s]; sequence  counts packets from 1
    receive::Sample& add(double time, std::uint64_t sequence) {
        receive::Sample& sample = samples.emplace_back(layout);
        sample.sequence = sequence;
        sample.connection = 1;
        set(sample, "timestamp", time);
        return sample;
    }
    /// component  by the name recordings use: "actual_current_0"
    void set(receive::Sample& sample, const char* component, double value) const {
        sample.values.at(layout->indexOfComponent(component).value()) = value;
    }
    /// What was added since the last frame goes to `take`, and is gone.
    template <class Take>
    auto frame(Take take) {
        const std::vector<receive::Sample> gone = std::exchange(samples, {});
        return take(SampleBatch{gone, std::exchange(lost, 0)});
    }
};

}  // namespace tiller::test
