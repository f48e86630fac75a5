// SPDX-License-Identifier: MIT
#pragma once

// A bit or a mode over time, as segments of constant state.

#include <vector>

#include "robot/station/history/series_buffer.h"
#include "robot/station/history/state_lane.h"

namespace tiller {

class SignalStore;

/// Segments for the columns of a grid. A column with more than one change of the state is Varied, so that
/// changes are visible at any zoom level.
std::vector<LaneSegment> signalSegments(const SignalStore& store, int signal, const ColumnGrid& grid);

}  // namespace tiller
