// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes the samples of each frame into the plots' history. It owns the plots' time axis: the controller's time
// stamps, made to go forward also over a restart of the controller.

#include <cstdint>

#include "widgets/plots/plot_signals.h"
#include "widgets/plots/series_buffer.h"
#include "widgets/session/sample_batch.h"

namespace tiller {

/// Threads  GUI
class PlotFeed {
public:
    explicit PlotFeed(SeriesBuffer& history) : history_(history) {}

    /// What comes from now on is another robot's. The history stays, with a gap between.
    void beginLink();
    /// Returns  how many rows were added
    int take(const SampleBatch& batch);

    /// A time stamp of the controller on the plots' time axis [s].
    double plotTime(double robotTime) const { return robotTime + offset_; }
    /// Rows lost because the screen was too slow for the ring.
    std::uint64_t overrun() const { return overrun_; }
    /// Gaps in the history so far, whatever their cause.
    std::uint64_t gaps() const { return gaps_; }

private:
    struct Places;
    bool take(const receive::Sample& sample, const Places& places);

    SeriesBuffer& history_;
    double offset_ = 0;
    double lastRobotTime_ = 0;
    double lastStep_ = 0;  // between two samples without a gap [s]
    std::uint64_t lastSequence_ = 0;
    std::uint64_t connection_ = 0;  // of the last sample; 0: none yet of this link
    bool any_ = false;
    bool gapPending_ = false;
    std::uint64_t overrun_ = 0;
    std::uint64_t gaps_ = 0;
};

}  // namespace tiller
