// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_feed.h"

#include <array>
#include <cmath>
#include <limits>

namespace tiller {

namespace {

/// A controller that starts again begins its time anew; its first sample is put this far behind the last. [s]
constexpr double kRestartDistance = 0.1;
/// A hole of more than this many times the last distance is one, whoever counted what.
constexpr double kHole = 3.5;

/// Where in a sample the plots' values are; what a layout does not have reads as NaN.
struct Places {
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

    PlotRow rowOf(const receive::Sample& sample) const {
        PlotRow row;
        row.robotTime = sample.at(timestamp);
        row.sequence = sample.sequence;
        row.gapBefore = sample.lostBefore > 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            row.values[i] = static_cast<float>(sample.at(values[i]));
        }
        return row;
    }
};

}  // namespace

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
        PlotRow row = places.rowOf(sample);
        row.gapBefore = row.gapBefore || (connection_ != 0 && sample.connection != connection_);
        connection_ = sample.connection;
        added += take(row) ? 1 : 0;
    }
    return added;
}

bool PlotFeed::take(const PlotRow& row) {
    if (!std::isfinite(row.robotTime)) {
        return false;
    }
    bool gap = row.gapBefore || gapPending_;
    if (any_) {
        gap = gap || (lastSequence_ != 0 && row.sequence != lastSequence_ + 1);
        const double forward = row.robotTime - lastRobotTime_;
        if (forward <= 0) {
            if (row.sequence == lastSequence_) {
                return false;
            }
            // The controller began its time anew.
            offset_ = history_.lastTime() + kRestartDistance - row.robotTime;
            gap = true;
        } else if (lastStep_ > 0 && forward > kHole * lastStep_) {
            gap = true;
        }
        if (forward > 0 && !gap) {
            lastStep_ = forward;
        }
    }
    lastRobotTime_ = row.robotTime;
    lastSequence_ = row.sequence;
    if (!history_.append(plotTime(row.robotTime), row.values, gap)) {
        return false;
    }
    any_ = true;
    gapPending_ = false;
    gaps_ += gap ? 1 : 0;
    return true;
}

}  // namespace tiller
