// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one scrubber: while the page in front shows a recording, or the plots are held still, cursor A is a moment that
// the other parts of the window show too. Recording and history go on meanwhile.

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
    /// Both must outlive it.
    PlotReplay(const SignalStore& store, const PlotPages& pages, QObject* parent = nullptr);

    /// Data until this moment of the plots' time axis were shown first at this time of the day: the log is found by it.
    void noteFrame(double newest, const QDateTime& now);
    void forgetBefore(double time);
    /// The time of the day of a moment on the plots' time axis: of the recording that the page in front shows, or of
    /// the history and what comes after. Not valid: nobody knows.
    QDateTime clockAt(double time) const;
    /// Looks at page, cursor and pause anew, and tells when the moment is another one.
    void follow();
    const Replay& moment() const { return moment_; }
    /// Lines that the log of a recording has besides those in its file.
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
    QHash<QString, std::vector<recording::RecordedEvent>> further_;  ///< by recordings
};

}  // namespace tiller
