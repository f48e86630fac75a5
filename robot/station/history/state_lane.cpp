// SPDX-License-Identifier: MIT
#include "robot/station/history/state_lane.h"

#include <algorithm>

namespace tiller {

void StateLane::add(double time, LaneKind kind, const QString& label) {
    if (!segments_.empty()) {
        LaneSegment& last = segments_.back();
        if (time < last.end) {
            return;
        }
        last.end = time;
        if (last.kind == kind && last.label == label) {
            return;
        }
    }
    segments_.push_back({time, time, kind, label});
    if (segments_.size() > kMaxSegments) {
        segments_.pop_front();
    }
}

void StateLane::forgetBefore(double time) {
    while (segments_.size() > 1 && segments_.front().end < time) {
        segments_.pop_front();
    }
}

std::vector<LaneSegment> StateLane::visible(double t0, double t1, double least) const {
    std::vector<LaneSegment> out;
    auto it = std::lower_bound(segments_.begin(), segments_.end(), t0,
                               [](const LaneSegment& s, double t) { return s.end < t; });
    double from = t0;
    for (; it != segments_.end() && it->start < t1; ++it) {
        LaneSegment cut = *it;
        cut.start = std::max(out.empty() ? std::max(it->start, t0) : from, t0);
        cut.end = std::min(it->end, t1);
        from = cut.end;
        const bool last = std::next(it) == segments_.end();
        if (cut.end <= cut.start || (!last && cut.end - cut.start < least)) {
            from = cut.start;
            continue;
        }
        out.push_back(std::move(cut));
    }
    return out;
}

}  // namespace tiller
