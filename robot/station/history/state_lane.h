// SPDX-License-Identifier: MIT
#pragma once

// Activity of the robot as time segments with one word each: the data of the strip below the plots.

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
    High,    ///< a bit that is set
    Low,     ///< one that is not
    Varied,  ///< more than one state within a pixel
};

struct LaneSegment {
    double start = 0;  ///< [s]
    double end = 0;    ///< [s]
    LaneKind kind = LaneKind::NoData;
    QString label;
};

class StateLane {
public:
    static constexpr std::size_t kMostSegments = 20000;

    /// From this moment on it was so. The same kind and label prolong the last segment.
    void add(double time, LaneKind kind, const QString& label);
    /// Removes segments that ended before this time.
    void forgetBefore(double time);
    void clear() { segments_.clear(); }

    bool isEmpty() const { return segments_.empty(); }
    /// Time until which the state is known [s]; 0 while empty.
    double endTime() const { return segments_.empty() ? 0 : segments_.back().end; }
    /// Whole segments, from oldest to newest; the last one ends where it was last confirmed.
    const std::deque<LaneSegment>& segments() const { return segments_; }
    /// The segments inside t0 ... t1, cut to it. Those narrower than `least` [s] are joined to their
    /// successor.
    std::vector<LaneSegment> visible(double t0, double t1, double least) const;

private:
    std::deque<LaneSegment> segments_;
};

}  // namespace tiller
