// SPDX-License-Identifier: MIT
#include "robot/station/history/history_feed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/core/clock.h"

namespace tiller {

namespace {

/// Minimum time between the last sample and the first sample after an interruption [s].
constexpr double kRestartDistance = 0.1;
/// A step that exceeds the previous sample interval by more than this factor is a gap, independently of
/// lost-packet counts.
constexpr double kHole = 3.5;

}  // namespace

constexpr std::size_t kNoPlace = std::numeric_limits<std::size_t>::max();

void HistoryFeed::Intake::follow(const std::shared_ptr<const receive::SampleLayout>& now,
                                 const std::vector<std::string>& columns) {
    rows.clear();
    samples.clear();
    if (now == layout && places.size() == columns.size()) {
        return;
    }
    layout = now;
    timestamp = now->indexOfComponent("timestamp").value_or(kNoPlace);
    places.clear();
    for (const std::string& column : columns) {
        places.push_back(now->indexOfComponent(column).value_or(kNoPlace));
    }
}

void HistoryFeed::beginLink() {
    gapPending_ = any_;
    furtherGap_ = true;
    lastSequence_ = 0;
    connection_ = 0;
}

int HistoryFeed::take(const SampleBatch& batch) {
    overrun_ += batch.lost;
    if (batch.samples.empty()) {
        return 0;
    }
    const SeriesBuffer& history = store_.live();
    live_.follow(batch.samples.front().layout, store_.liveColumns());
    double newest = history.lastTime();
    for (const receive::Sample& sample : batch.samples) {
        const double robotTime = sample.at(live_.timestamp);
        if (place(sample, robotTime, newest)) {
            newest = live_.rows.back().time;
            live_.samples.push_back(&sample);
        }
    }
    store_.appendLive(live_.rows,
                      [this](std::size_t column, std::size_t row) { return live_.value(column, row); });
    return static_cast<int>(live_.rows.size());
}

bool HistoryFeed::place(const receive::Sample& sample, double robotTime, double newest) {
    bool gap = gapPending_ || sample.lostBefore > 0 || (connection_ != 0 && sample.connection != connection_);
    connection_ = sample.connection;
    if (!std::isfinite(robotTime)) {
        return false;
    }
    if (any_) {
        gap = gap || (lastSequence_ != 0 && sample.sequence != lastSequence_ + 1);
        const double forward = robotTime - lastRobotTime_;
        if (forward <= 0 && sample.sequence == lastSequence_) {
            return false;
        }
        if (forward <= 0 || gapPending_) {
            // The controller has restarted its clock, or another controller is connected. Only the host clock
            // measures the duration of the interruption.
            const double silence =
                static_cast<double>(sample.hostTimeNs - lastHostNs_) / static_cast<double>(kNsPerSecond);
            offset_ = newest + std::max(kRestartDistance, silence) - robotTime;
            store_.beginClock(plotTime(robotTime), offset_);
            gap = true;
        } else if (lastStep_ > 0 && forward > kHole * lastStep_) {
            gap = true;
        }
        if (forward > 0 && !gap) {
            lastStep_ = forward;
        }
    }
    lastRobotTime_ = robotTime;
    lastSequence_ = sample.sequence;
    lastHostNs_ = sample.hostTimeNs;
    const double time = plotTime(robotTime);
    if (any_ && !(time > newest)) {
        return false;
    }
    live_.rows.push_back({time, gap});
    if (any_ && time - newest > kNoticeableGap) {
        silences_.push_back({newest, time});
    }
    any_ = true;
    gapPending_ = false;
    gaps_ += gap ? 1 : 0;
    return true;
}

int HistoryFeed::takeExtra(const SampleBatch& batch) {
    // The standard stream defines the time axis, so extra samples can be added only after the stream has
    // started.
    if (batch.samples.empty() || !any_ || gapPending_) {
        return 0;
    }
    const SeriesBuffer& history = store_.further();
    further_.follow(batch.samples.front().layout, store_.furtherColumns());
    double newest = history.lastTime();
    bool any = !history.isEmpty();
    for (const receive::Sample& sample : batch.samples) {
        const double time = plotTime(sample.at(further_.timestamp));
        if (!std::isfinite(time) || (any && !(time > newest))) {
            continue;
        }
        const bool hole = any && lastStep_ > 0 && time - newest > kHole * lastStep_;
        const bool gap = furtherGap_ || hole || sample.lostBefore > 0 ||
                         (furtherSequence_ != 0 && sample.sequence != furtherSequence_ + 1);
        further_.rows.push_back({time, gap});
        further_.samples.push_back(&sample);
        furtherSequence_ = sample.sequence;
        furtherGap_ = false;
        newest = time;
        any = true;
    }
    store_.appendFurther(further_.rows,
                         [this](std::size_t column, std::size_t row) { return further_.value(column, row); });
    return static_cast<int>(further_.rows.size());
}

}  // namespace tiller
