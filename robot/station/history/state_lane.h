// SPDX-License-Identifier: MIT
#pragma once

// Activity of the robot as labelled time segments, for the lane below the plots.

#include <QString>
#include <deque>
#include <vector>

namespace tiller {

enum class LaneKind {
    NoData,
    Off,
    Idle,
    Moving,
    Stopped,
    High,    ///< the bit is set
    Low,     ///< the bit is not set
    Varied,  ///< more than one state change within a pixel column
};

struct LaneSegment {
    double start = 0;  ///< [s]
    double end = 0;    ///< [s]
    LaneKind kind = LaneKind::NoData;
    QString label;
};

class StateLane {
public:
    static constexpr std::size_t kMaxSegments = 20000;

    /// Sets the state from this time on. Extends the last segment if kind and label are the same.
    void add(double time, LaneKind kind, const QString& label);
    /// Removes segments that ended before this time.
    void forgetBefore(double time);
    void clear() { segments_.clear(); }

    bool isEmpty() const { return segments_.empty(); }
    /// Time until which the state is known [s]; 0 while empty.
    double endTime() const { return segments_.empty() ? 0 : segments_.back().end; }
    /// Segments, oldest first. The last segment ends at the time of the last add().
    const std::deque<LaneSegment>& segments() const { return segments_; }
    /// The segments within t0 ... t1, clipped to this range. Segments shorter than `least` [s] are merged
    /// with the next segment.
    std::vector<LaneSegment> visible(double t0, double t1, double least) const;

private:
    std::deque<LaneSegment> segments_;
};

}  // namespace tiller
