// SPDX-License-Identifier: MIT
#pragma once

// An event of the journal as stored in recordings.

#include <optional>

#include "robot/recording/recording_format.h"
#include "robot/station/journal/journal_event.h"

namespace tiller {

/// Returns the entry of a recording; empty for messages about recordings.
std::optional<recording::RecordedNote> recordedNote(const JournalEvent& event);
/// A note by the operator for the time `utcNs` [ns since 1970].
recording::RecordedNote operatorNote(const QString& text, std::int64_t utcNs);

}  // namespace tiller
