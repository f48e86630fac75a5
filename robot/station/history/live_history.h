// SPDX-License-Identifier: MIT
#pragma once

// The history of one robot: the values of its signals and its activity since the start of the program. It
// reads all samples from the session and requests the additional fields that views display. It does not
// depend on a view, so the history continues while no view exists.

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "robot/station/history/history_feed.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/history/state_lane.h"
#include "robot/station/link/session_state.h"

namespace tiller {

class RobotSession;

/// Threads  GUI
class LiveHistory : public QObject {
    Q_OBJECT

public:
    /// session  must outlive the object
    explicit LiveHistory(RobotSession& session, QObject* parent = nullptr);

    SignalStore& store() { return store_; }
    const SignalStore& store() const { return store_; }
    /// Activity of the robot on the plots' time axis.
    const StateLane& lane() const { return lane_; }
    /// Converts a time stamp of the controller to the plots' time axis [s].
    double plotTime(double robotTime) const { return feed_.plotTime(robotTime); }

    /// Sets the text in the lane for the held jog button, e.g. "X+" or "Wrist 2−". Empty if no button is
    /// held.
    void setJogLabel(const QString& label) { jogLabel_ = label; }
    /// Sets the text in the lane for the running step of a program. Empty if no program runs.
    void setStepLabel(const QString& label) { stepLabel_ = label; }

Q_SIGNALS:
    /// Marks the time at which the robot changed. Later samples belong to a different robot than earlier
    /// samples.
    /// time   [s]
    /// robot  name and address
    void robotChanged(double time, const QString& robot);

private:
    void take(const SampleBatch& batch);
    void follow(const SessionState& state);
    void markRobotChange();

    SignalStore store_;
    HistoryFeed feed_{store_};
    StateLane lane_;
    QString robot_;                             ///< name and address
    std::optional<std::int64_t> markedChange_;  ///< sample of the last robotChanged()
    QString jogLabel_;
    QString stepLabel_;
    std::optional<double> backAt_;  ///< time at which data arrived again, not yet added to the lane [s]
};

}  // namespace tiller
