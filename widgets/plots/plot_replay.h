// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Replay: while the current page shows a recording or the plots are paused, the rest of the window shows the
// data at the time of cursor A. Recording and history continue in the background.

#include <QHash>
#include <QObject>
#include <cstdint>
#include <deque>
#include <optional>

#include "robot/station/history/replay_moment.h"

namespace tiller {

class PlotPages;
class PlotView;
class SignalStore;

/// Threads  GUI
class PlotReplay : public QObject {
    Q_OBJECT

public:
    /// Both arguments must outlive the object.
    PlotReplay(const SignalStore& store, const PlotPages& pages, QObject* parent = nullptr);

    /// Stores that data up to the time `newest` on the time axis were first displayed at the time of day
    /// `now`, for finding the log entry of a time.
    void noteFrame(double newest, const QDateTime& now);
    void forgetBefore(double time);
    /// Returns the time of day for a time on the time axis of the current page, i.e. of its recording or of
    /// the history. Invalid if unknown.
    QDateTime clockAt(double time) const;
    /// The time of a note about live samples: the time of day as if the system clock had always had its current
    /// setting, because the clock may have been set since then. The current time if there are no data.
    /// Returns  [ns since 1970, UTC]
    std::int64_t noteUtcNs(double time) const;
    /// Inverse of clockAt(): the first time on the time axis whose data were displayed at this time of day.
    /// Empty if unknown.
    std::optional<double> timeAt(const QDateTime& clock) const;
    /// The recording of the current page; empty for live signals.
    QString recordingInFront() const;
    /// Updates moment() from page, cursor and pause state. Emits changed() if the replayed time has changed.
    void follow();
    const Replay& moment() const { return moment_; }
    /// Adds log entries to those in the file of a recording. Replaces earlier additions.
    void setFurtherEvents(const QString& recording, std::vector<recording::RecordedEvent> events);

Q_SIGNALS:
    void changed(const tiller::Replay& moment);

private:
    struct Frame {
        double newest;
        std::int64_t wallMs;
        std::int64_t steadyNs;  ///< time of SteadyClock
    };
    /// The first frame that contains this time on the time axis, or the last frame. There must be frames.
    const Frame& frameAt(double time) const;
    Replay momentNow() const;
    std::shared_ptr<const std::vector<recording::RecordedEvent>> eventsOf(const QString& recording) const;
    QDateTime wallTimeOf(double time) const;

    const SignalStore& store_;
    const PlotPages& pages_;
    std::deque<Frame> frames_;
    Replay moment_;
    QHash<QString, std::vector<recording::RecordedEvent>> further_;  ///< additional events by recording
};

}  // namespace tiller
