// SPDX-License-Identifier: MIT
#pragma once

// Writes the samples of each frame to the signal history. Defines the time axis of the plots from
// the time stamps of the controller. For interruptions in which the controller may have restarted, the host
// time is used.

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

    /// Call when the next data are from another robot. The history is kept, with a gap of the actual
    /// duration.
    void beginLink();
    /// Returns  number of rows added
    int take(const SampleBatch& batch);
    /// Like take(), for additionally requested fields.
    int takeExtra(const SampleBatch& batch);

    /// Converts a time stamp of the controller to the plots' time axis [s].
    double plotTime(double robotTime) const { return robotTime + offset_; }
    /// A range of the plots' time axis with a noticeable gap in the data [s].
    struct Silence {
        double from = 0;
        double to = 0;
    };
    static constexpr double kNoticeableGap = 0.3;  ///< [s]
    /// Returns the interruptions that have ended since the last call.
    std::vector<Silence> takeDataGaps() { return std::exchange(silences_, {}); }

    /// Number of rows lost because the window did not read the ring buffer in time.
    std::uint64_t overrun() const { return overrun_; }
    /// Number of gaps in the history from any cause.
    std::uint64_t gaps() const { return gaps_; }

private:
    /// Converts the samples of each batch to rows of one history.
    struct Intake {
        std::shared_ptr<const receive::SampleLayout> layout;  ///< layout to which `places` refers
        std::vector<std::size_t> places;                      ///< index of each column in a sample
        std::size_t timestamp = 0;
        std::vector<SeriesBuffer::Row> rows;
        std::vector<const receive::Sample*> samples;  ///< samples of the rows

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
    double lastStep_ = 0;  // time between the last two samples without a gap [s]
    std::int64_t lastHostNs_ = 0;
    std::vector<Silence> silences_;
    std::uint64_t lastSequence_ = 0;
    std::uint64_t connection_ = 0;  // connection of the last sample; 0: no sample yet
    bool any_ = false;
    bool gapPending_ = false;
    std::uint64_t furtherSequence_ = 0;
    bool furtherGap_ = false;
    std::uint64_t overrun_ = 0;
    std::uint64_t gaps_ = 0;
};

}  // namespace tiller
