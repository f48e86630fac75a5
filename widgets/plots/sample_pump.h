// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Brings samples from the receive thread's ring into the plots' history, once a frame. It owns the plots'
// time axis: the controller's time stamps, made to go forward also over a restart of the controller.

#include <QObject>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <memory>

#include "widgets/plots/plot_signals.h"
#include "widgets/plots/series_buffer.h"

namespace tiller {

/// Where rows come from: a subscription of the receiver, or a test.
class PlotSource {
public:
    virtual ~PlotSource() = default;
    /// Hands over every row since the last call, oldest first.
    /// Returns  how many rows were overwritten since the last call because nobody drained them in time
    virtual std::uint64_t drain(const std::function<void(const PlotRow&)>& take) = 0;
};

/// Threads  GUI
class SamplePump : public QObject {
    Q_OBJECT

public:
    explicit SamplePump(SeriesBuffer& history, QObject* parent = nullptr);
    ~SamplePump() override;

    /// Takes the rows from here from now on; null ends it. The history stays, with a gap between.
    void setSource(std::unique_ptr<PlotSource> source);

    /// Begins to fire once a frame by itself.
    void start();
    void stop();
    /// One frame: drains the source. Tests call it themselves.
    void pump();

    /// A time stamp of the controller on the plots' time axis [s].
    double plotTime(double robotTime) const { return robotTime + offset_; }
    /// Rows lost because the screen was too slow for the ring.
    std::uint64_t overrun() const { return overrun_; }
    /// Gaps in the history so far, whatever their cause.
    std::uint64_t gaps() const { return gaps_; }

    /// Between two frames [ms].
    static constexpr int kFrameMs = 25;

Q_SIGNALS:
    /// Rows were added, or a frame passed without any: time to look again.
    void frame(int addedRows);

private:
    void take(const PlotRow& row);

    SeriesBuffer& history_;
    std::unique_ptr<PlotSource> source_;
    QTimer timer_;
    double offset_ = 0;
    double lastRobotTime_ = 0;
    double lastStep_ = 0;  // between two samples without a gap [s]
    std::uint64_t lastSequence_ = 0;
    bool any_ = false;
    bool gapPending_ = false;
    int added_ = 0;
    std::uint64_t overrun_ = 0;
    std::uint64_t gaps_ = 0;
};

}  // namespace tiller
