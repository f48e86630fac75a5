// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Replay: while the page in front shows a recording, or the plots are paused, the other parts of the window show
// the time of cursor A. Recording and history continue meanwhile.

#include <QHash>
#include <QObject>
#include <cstdint>
#include <deque>

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

    /// Data up to this time on the time axis were first displayed at this time of day; used to find the log entry.
    void noteFrame(double newest, const QDateTime& now);
    void forgetBefore(double time);
    /// Time of day for a time on the time axis: of the recording on the page in front, or of the history. Invalid
    /// if unknown.
    QDateTime clockAt(double time) const;
    /// The recording of the page in front; empty: live signals.
    QString recordingInFront() const;
    /// Evaluates page, cursor and pause again, and emits a signal if the time has changed.
    void follow();
    const Replay& moment() const { return moment_; }
    /// Log lines of a recording in addition to those in its file.
    void setFurtherEvents(const QString& recording, std::vector<recording::RecordedEvent> events);

Q_SIGNALS:
    void changed(const tiller::Replay& moment);

private:
    struct Frame {
        double newest;
        std::int64_t wallMs;
    };
    Replay momentNow() const;
    std::shared_ptr<const std::vector<recording::RecordedEvent>> eventsOf(const QString& recording) const;
    QDateTime wallTimeOf(double time) const;

    const SignalStore& store_;
    const PlotPages& pages_;
    std::deque<Frame> frames_;
    Replay moment_;
    QHash<QString, std::vector<recording::RecordedEvent>> further_;  ///< events by recording
};

}  // namespace tiller
