// SPDX-License-Identifier: MIT
#pragma once

// An entry of the window's log as stored in recordings.

#include "robot/recording/recording_format.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

/// Returns the entry with the current time stamp.
recording::RecordedNote recordedNote(Severity severity, const QString& text, Origin origin);
/// A note by the operator for the time `utcNs` [ns since 1970].
recording::RecordedNote operatorNote(const QString& text, std::int64_t utcNs);
/// The beginning of a step of a program, with the current time stamp.
recording::RecordedNote stepNote(const QString& text);

}  // namespace tiller
