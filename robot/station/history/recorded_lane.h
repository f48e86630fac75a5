// SPDX-License-Identifier: MIT
#pragma once

// State lane of a recording, from its robot mode, safety mode and speeds.

#include <QString>
#include <vector>

#include "robot/station/history/series_buffer.h"
#include "robot/station/history/state_lane.h"

namespace tiller {

class SignalStore;

/// The signals needed for the state lane of a recording. Empty if the recording does not contain the robot
/// mode and the safety mode.
std::vector<int> recordedLaneSignals(const SignalStore& store, const QString& recording);

/// Segments for the columns of a grid. A stop shorter than a column is shown for the whole column. There are
/// no segments before the first and after the last sample, and none unless the signals of
/// recordedLaneSignals() are loaded.
std::vector<LaneSegment> recordedLane(const SignalStore& store, const QString& recording,
                                      const ColumnGrid& grid);

}  // namespace tiller
