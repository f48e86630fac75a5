// SPDX-License-Identifier: MIT
#pragma once

// A past point in time that the 3D view, the inputs and outputs, and the log show. It refers to an opened
// recording, or to the history while the plots are paused. Live data continue in the background, and jogging
// is not affected.

#include <QDateTime>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "robot/core/robot_model.h"
#include "robot/receive/sample.h"
#include "robot/recording/recording.h"

namespace tiller {

struct ReplayMoment {
    QString source;          ///< name of the recording; empty: the history
    double time = 0;         ///< on the plots' time axis [s]
    QDateTime wallTime;      ///< invalid if unknown
    receive::Sample sample;  ///< empty: no data at that time
    /// Name of the robot if the history also contains data from a later robot; otherwise empty.
    QString robot;
    std::optional<RobotModelId> model;  ///< empty: unknown
    double seconds = 0;                 ///< since the first row of the recording; 0 for the history
    /// The log of the recording; null for the history, which uses the log of the window.
    std::shared_ptr<const std::vector<recording::RecordedEvent>> events;

    /// Label in every view during replay, e.g. "REPLAY · 14:02:11.250 · at 12.350 s in incident_….mcap".
    QString words() const;
};

/// The displayed past moment; empty while live data are shown.
using Replay = std::optional<ReplayMoment>;

}  // namespace tiller
