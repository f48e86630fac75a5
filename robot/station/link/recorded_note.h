// SPDX-License-Identifier: MIT
#pragma once

// A line of the window's log as recordings keep it.

#include "robot/recording/recording_format.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

/// With the current time stamp.
recording::RecordedNote recordedNote(Severity severity, const QString& text, Origin origin);
/// A note of the operator about the moment `utcNs` [ns since 1970].
recording::RecordedNote operatorNote(const QString& text, std::int64_t utcNs);

}  // namespace tiller
