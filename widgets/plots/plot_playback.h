// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Moves cursor A through a recording or a paused history, so that the replay runs like a film.

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <array>
#include <utility>

namespace tiller {

class PlotPages;
class SignalStore;

/// Threads  GUI
class PlotPlayback : public QObject {
    Q_OBJECT

public:
    static constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0};

    /// Both arguments must outlive the object.
    PlotPlayback(const SignalStore& store, PlotPages& pages, QObject* parent = nullptr);

    /// Starts at cursor A if it is visible, otherwise at the start of the visible range, and ends at the sample that is
    /// the newest now. At the end of the data, starts again at the first sample. Pauses a page with live signals.
    /// speed  recorded time per real time; positive
    /// Returns  false, without changes, if there are no samples
    bool start(double speed);
    void stop();
    bool isRunning() const { return timer_.isActive(); }
    double speed() const { return speed_; }

private:
    /// First and last time of the current page [s]; first >= last if there are no samples.
    std::pair<double, double> range() const;
    void step();

    const SignalStore& store_;
    PlotPages& pages_;
    QTimer timer_;
    QElapsedTimer clock_;
    double speed_ = 1;
    QString source_;  ///< recording that is played; empty for live signals
    double end_ = 0;  ///< last time when the playback started; live data continue to arrive [s]
};

}  // namespace tiller
