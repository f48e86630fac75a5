// SPDX-License-Identifier: MIT
#include "robot/recording/detail/exported_events.h"

#include <algorithm>

namespace tiller::recording {

Result<std::vector<ExportedEvent>> exportedEvents(const Recording& recording, const ExportChoice& choice,
                                                  const RowRange& rows) {
    std::vector<ExportedEvent> exported;
    for (const RecordedEvent& event : recording.events()) {
        const double time = std::max(event.seconds, 0.0);
        if (time < choice.from || time > choice.until) {
            continue;
        }
        const auto row = recording.rowAt(time);
        if (!row) {
            return row.error();
        }
        const std::uint64_t after = std::max(*row, rows.first) - rows.first;
        exported.push_back({std::min(after, std::max<std::uint64_t>(rows.count, 1) - 1), event});
    }
    return exported;
}

}  // namespace tiller::recording
