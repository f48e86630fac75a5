// SPDX-License-Identifier: MIT
#pragma once

// Packet statistics of the last ten seconds, because totals since the start do not show the current quality
// of the connection. Private to robot/station/link.

#include <deque>

#include "robot/receive/receiver.h"
#include "robot/station/link/session_state.h"

namespace tiller {

/// Threads  GUI
class LinkHistory {
public:
    static constexpr std::int64_t kSpanNs = 10'000'000'000;

    /// Adds the current counters.
    /// Returns  their increase within the last kSpanNs
    PacketCounts add(std::int64_t nowNs, const PacketCounts& now);
    void clear() { points_.clear(); }

private:
    struct Point {
        std::int64_t ns = 0;
        PacketCounts counts;
    };
    std::deque<Point> points_;  ///< several points per second
};

}  // namespace tiller
