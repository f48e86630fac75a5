// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_feed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "robot/core/clock.h"

namespace tiller {

namespace {

/// Where nothing tells how long the silence was, the first sample behind it is put this far behind the last. [s]
constexpr double kRestartDistance = 0.1;
/// A hole of more than this many times the last distance is one, whoever counted what.
constexpr double kHole = 3.5;

}  // namespace

/// Where in a sample the plots' values are; what a layout does not have reads as NaN.
struct PlotFeed::Places {
    std::size_t timestamp = kNone;
    std::array<std::size_t, kPlotSignalCount> values{};

    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    explicit Places(const receive::SampleLayout& layout)
        : timestamp(layout.indexOfComponent("timestamp").value_or(kNone)) {
        for (int i = 0; i < kPlotSignalCount; ++i) {
            values[static_cast<std::size_t>(i)] =
                layout.indexOfComponent(plot_signals::column(static_cast<PlotSignal>(i))).value_or(kNone);
        }
    }
};

void PlotFeed::beginLink() {
    gapPending_ = any_;
    lastSequence_ = 0;
    connection_ = 0;
}

int PlotFeed::take(const SampleBatch& batch) {
    overrun_ += batch.lost;
    if (batch.samples.empty()) {
        return 0;
    }
    const Places places(*batch.samples.front().layout);
    int added = 0;
    for (const receive::Sample& sample : batch.samples) {
        added += take(sample, places) ? 1 : 0;
    }
    return added;
}

bool PlotFeed::take(const receive::Sample& sample, const Places& places) {
    const double robotTime = sample.at(places.timestamp);
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
            // The controller began its time anew, or it is the time of another one: only the clock of this
            // computer knows how long nothing came.
            const double silence =
                static_cast<double>(sample.hostTimeNs - lastHostNs_) / static_cast<double>(kNsPerSecond);
            offset_ = history_.lastTime() + std::max(kRestartDistance, silence) - robotTime;
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
    const double before = history_.lastTime();
    const auto valueOf = [&](std::size_t signal) {
        return signal < places.values.size() ? static_cast<float>(sample.at(places.values[signal]))
                                             : std::numeric_limits<float>::quiet_NaN();
    };
    if (!history_.appendEach(plotTime(robotTime), valueOf, gap)) {
        return false;
    }
    if (any_ && plotTime(robotTime) - before > kNoticeableSilence) {
        silences_.push_back({before, plotTime(robotTime)});
    }
    any_ = true;
    gapPending_ = false;
    gaps_ += gap ? 1 : 0;
    return true;
}

}  // namespace tiller
