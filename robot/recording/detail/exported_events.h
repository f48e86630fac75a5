// SPDX-License-Identifier: MIT
#pragma once

// The log lines and notes that belong to a part of a recording.

#include <vector>

#include "robot/recording/export.h"

namespace tiller::recording {

struct ExportedEvent {
    std::uint64_t row = 0;  ///< of the exported rows: the last one at or before the event, or the first one
    RecordedEvent event;
};

/// The events in the time range of the export, in time order. Events before the first row of the recording belong to
/// its start.
/// rows  the exported rows
Result<std::vector<ExportedEvent>> exportedEvents(const Recording& recording, const ExportChoice& choice,
                                                  const RowRange& rows);

}  // namespace tiller::recording
