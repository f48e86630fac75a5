// SPDX-License-Identifier: MIT
#include "robot/station/link/detail/link_history.h"

namespace tiller {
namespace {

constexpr std::int64_t kStepNs = LinkHistory::kSpanNs / 40;

}  // namespace

PacketCounts LinkHistory::add(std::int64_t nowNs, const PacketCounts& now) {
    if (!points_.empty() && now.packets < points_.back().counts.packets) {
        points_.clear();  // the counters were reset
    }
    if (points_.empty() || nowNs - points_.back().ns >= kStepNs) {
        points_.push_back({nowNs, now});
    }
    // Keep the last point before the time span, because the result is the increase since that point.
    while (points_.size() > 1 && nowNs - points_[1].ns >= kSpanNs) {
        points_.pop_front();
    }
    const PacketCounts& then = points_.front().counts;
    return {now.packets - then.packets, now.late - then.late, now.lost - then.lost};
}

}  // namespace tiller
