// SPDX-License-Identifier: MIT
#pragma once

// The log lines and notes that belong to a part of a recording.

#include <vector>

#include "robot/recording/export.h"

namespace tiller::recording {

struct ExportedEvent {
    std::uint64_t row = 0;  ///< last exported row at or before the event, otherwise the first exported row
    RecordedEvent event;
};

/// Returns the events in the time range of the export, in chronological order. Events before the first row of
/// the recording are assigned to this row.
/// rows  range of the exported rows
Result<std::vector<ExportedEvent>> exportedEvents(const Recording& recording, const ExportChoice& choice,
                                                  const RowRange& rows);

}  // namespace tiller::recording
