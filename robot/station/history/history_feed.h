// SPDX-License-Identifier: MIT
#pragma once

// Writes the samples of each frame into the signals' history. It owns the plots' time axis: the controller's time
// stamps, and over a silence in which the controller may have begun its time anew, the time of this computer.

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robot/station/history/signal_store.h"
#include "robot/station/link/sample_batch.h"

namespace tiller {

/// Threads  GUI
class HistoryFeed {
public:
    explicit HistoryFeed(SignalStore& store) : store_(store) {}

    /// What comes from now on is another robot's. The history stays, with a gap between as long as it lasted.
    void beginLink();
    /// Returns  how many rows were added
    int take(const SampleBatch& batch);
    /// The same for what the robot was asked for besides.
    int takeExtra(const SampleBatch& batch);

    /// A time stamp of the controller on the plots' time axis [s].
    double plotTime(double robotTime) const { return robotTime + offset_; }
    /// A stretch of the plots' time axis without data that the eye can see [s].
    struct Silence {
        double from = 0;
        double to = 0;
    };
    static constexpr double kNoticeableSilence = 0.3;  ///< [s]
    /// Those that ended since the last call.
    std::vector<Silence> takeSilences() { return std::exchange(silences_, {}); }

    /// Rows lost because the screen was too slow for the ring.
    std::uint64_t overrun() const { return overrun_; }
    /// Gaps in the history so far, whatever their cause.
    std::uint64_t gaps() const { return gaps_; }

private:
    /// What a history gets of each batch.
    struct Intake {
        std::shared_ptr<const receive::SampleLayout> layout;  ///< that `places` is for
        std::vector<std::size_t> places;                      ///< of each column in a sample
        std::size_t timestamp = 0;
        std::vector<SeriesBuffer::Row> rows;
        std::vector<const receive::Sample*> samples;  ///< of the rows

        void follow(const std::shared_ptr<const receive::SampleLayout>& now,
                    const std::vector<std::string>& columns);
        double value(std::size_t column, std::size_t row) const {
            return column < places.size() ? samples[row]->at(places[column]) : receive::kAbsent;
        }
    };
    bool place(const receive::Sample& sample, double robotTime, double newest);

    SignalStore& store_;
    Intake live_;
    Intake further_;
    double offset_ = 0;
    double lastRobotTime_ = 0;
    double lastStep_ = 0;  // between two samples without a gap [s]
    std::int64_t lastHostNs_ = 0;
    std::vector<Silence> silences_;
    std::uint64_t lastSequence_ = 0;
    std::uint64_t connection_ = 0;  // of the last sample; 0: none yet of this link
    bool any_ = false;
    bool gapPending_ = false;
    std::uint64_t furtherSequence_ = 0;
    bool furtherGap_ = false;
    std::uint64_t overrun_ = 0;
    std::uint64_t gaps_ = 0;
};

}  // namespace tiller
