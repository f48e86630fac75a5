// SPDX-License-Identifier: MIT
#pragma once

// A past point in time that view, inputs and outputs, and log show together: of an opened recording, or of
// the history while the plots are paused. Live data continue in the background, and jogging is not affected.

#include <QDateTime>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "robot/receive/sample.h"
#include "robot/recording/recording.h"

namespace tiller {

struct ReplayMoment {
    QString source;          ///< name of the recording; empty: the history
    double time = 0;         ///< on the plots' time axis [s]
    QDateTime wallTime;      ///< invalid: unknown
    receive::Sample sample;  ///< empty: no data at that time
    double seconds = 0;      ///< since the recording's first row; 0 for the history
    /// The recording's log; null for the history, whose log is that of the window.
    std::shared_ptr<const std::vector<recording::RecordedEvent>> events;

    /// "REPLAY · 14:02:11.250 · at 12.350 s of incident_….mcap": label shown by every view in replay.
    QString words() const;
};

/// Empty: live data.
using Replay = std::optional<ReplayMoment>;

}  // namespace tiller
