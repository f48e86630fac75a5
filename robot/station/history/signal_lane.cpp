// SPDX-License-Identifier: MIT
#include "robot/station/history/signal_lane.h"

#include <cmath>
#include <limits>

#include "robot/station/history/signal_store.h"

namespace tiller {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool isSame(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// State within one pixel column.
struct ColumnState {
    double first = kUnknown;
    double last = kUnknown;
    int changes = 0;  ///< number of state changes; counting ends at two
};

ColumnState stateOf(const SignalStore& store, int signal, std::int64_t begin, std::int64_t end) {
    const SeriesBuffer& history = *store.buffer(signal);
    ColumnState state;
    if (!history.hasRows(store.column(signal), begin, end)) {
        // For rows that are not in memory, only the extent is known. If minimum and maximum are equal, the
        // state is constant.
        const MinMax extent = history.minMax(store.column(signal), begin, end);
        state.changes = extent.isEmpty() || extent.min == extent.max ? 0 : 2;
        if (!extent.isEmpty() && extent.min == extent.max) {
            const int bit = store.info(signal).bit;
            state.first = state.last =
                bit < 0          ? extent.min
                : extent.min < 0 ? kUnknown
                                 : static_cast<double>(static_cast<std::uint64_t>(extent.min) >> bit & 1);
        }
        return state;
    }
    state.first = store.value(signal, begin);
    state.last = store.value(signal, end - 1);
    const MinMax extent = history.minMax(store.column(signal), begin, end);
    if (extent.min == extent.max || extent.isEmpty()) {
        state.changes = isSame(state.first, state.last) ? 0 : 1;
        return state;
    }
    double now = state.first;
    for (std::int64_t i = begin + 1; i < end && state.changes < 2; ++i) {
        const double next = store.value(signal, i);
        state.changes += isSame(now, next) ? 0 : 1;
        now = next;
    }
    return state;
}

LaneSegment segmentOf(const SignalInfo& info, double value, double start, double end) {
    if (std::isnan(value)) {
        return {start, end, LaneKind::NoData, {}};
    }
    const LaneKind kind = info.bit < 0 ? LaneKind::Idle : value != 0 ? LaneKind::High : LaneKind::Low;
    return {start, end, kind, info.stateName(value)};
}

}  // namespace

std::vector<LaneSegment> signalSegments(const SignalStore& store, int signal, const ColumnGrid& grid) {
    std::vector<LaneSegment> segments;
    const SeriesBuffer* history = store.buffer(signal);
    if (history == nullptr || grid.edges.empty()) {
        return segments;
    }
    const SignalInfo& info = store.info(signal);
    const auto add = [&segments](LaneSegment segment) {
        if (!segments.empty() && segments.back().kind == segment.kind &&
            segments.back().label == segment.label) {
            segments.back().end = segment.end;
        } else {
            segments.push_back(std::move(segment));
        }
    };
    const std::int64_t before = grid.edges.front() - 1;
    double now = before >= history->first() && history->hasRows(store.column(signal), before, before + 1)
                     ? store.value(signal, before)
                     : kUnknown;
    for (int i = 0; i < grid.columns(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const std::int64_t begin = grid.edges[at];
        const std::int64_t end = grid.edges[at + 1];
        const double start = grid.start + i * grid.width;
        if (begin == end) {
            // The last state holds between two samples, but not across a gap or after the newest sample.
            const bool holds = begin < history->end() && !history->gapBefore(begin);
            add(segmentOf(info, holds ? now : kUnknown, start, start + grid.width));
            continue;
        }
        const ColumnState state = stateOf(store, signal, begin, end);
        // A change between two columns is assigned to the later column.
        const int between = std::isnan(now) || isSame(now, state.first) ? 0 : 1;
        if (state.changes + between > 1) {
            add({start, start + grid.width, LaneKind::Varied, {}});
        } else {
            add(segmentOf(info, state.last, start, start + grid.width));
        }
        now = state.last;
    }
    return segments;
}

}  // namespace tiller
