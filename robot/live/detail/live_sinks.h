// SPDX-License-Identifier: MIT
#pragma once

// The sinks of live output, one row each. Private to this module.

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "robot/core/text.h"
#include "robot/live/live_output.h"
#include "robot/publish/sample_sink.h"

namespace tiller::live {

/// Values that the sinks report. Threads: any
struct LiveCounters {
    std::atomic<std::uint16_t> port{0};
    std::atomic<int> viewers{0};
    std::atomic<std::uint64_t> messages{0};
    std::atomic<std::uint64_t> dropped{0};
    std::atomic<std::uint64_t> datagrams{0};
    std::atomic<std::uint64_t> disconnected{0};
    std::atomic<std::uint64_t> refused{0};
    std::mutex mutex;
    Text refusedOrigin{};  ///< protected by the mutex
};

/// Options and shared objects of a sink.
struct LiveSinkContext {
    LiveOptions options;           ///< options; `fields` contains the names of all published fields
    std::int64_t steadyToUtc = 0;  ///< [ns]
    std::shared_ptr<LiveCounters> counters;
};

/// One kind of live output.
struct LiveSinkKind {
    /// Null if the options do not select this kind.
    std::shared_ptr<publish::SampleSink> (*make)(const LiveSinkContext& context);
};

/// All kinds, one row each.
const std::vector<LiveSinkKind>& liveSinkKinds();

std::shared_ptr<publish::SampleSink> foxgloveSink(const LiveSinkContext& context);
std::shared_ptr<publish::SampleSink> udpSink(const LiveSinkContext& context);

}  // namespace tiller::live
