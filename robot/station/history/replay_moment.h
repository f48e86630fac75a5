// SPDX-License-Identifier: MIT
#pragma once

// A moment of what was, which view, inputs and outputs, and log show together: of an opened recording, or of the
// history while the plots are held still. What is live goes on beside it, and jogging knows nothing of it.

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
    QDateTime wallTime;      ///< not valid: nobody knows
    receive::Sample sample;  ///< empty: there were no data then
    double seconds = 0;      ///< since the recording's first row; 0 for the history
    /// The recording's log; null: this is the history, whose log the window has.
    std::shared_ptr<const std::vector<recording::RecordedEvent>> events;

    /// "REPLAY · 14:02:11.250 · at 12.350 s of incident_….mcap": what every part that shows it says.
    QString words() const;
};

/// Nothing: live.
using Replay = std::optional<ReplayMoment>;

}  // namespace tiller
