// SPDX-License-Identifier: MIT
#pragma once

// A bit or a mode over time, as stretches of one state each.

#include <vector>

#include "robot/station/history/series_buffer.h"
#include "robot/station/history/state_lane.h"

namespace tiller {

class SignalStore;

/// What the columns of a grid show of a state. A column in which the state changes more than once is Varied: no
/// change is lost, however far it is zoomed out.
std::vector<LaneSegment> signalSegments(const SignalStore& store, int signal, const ColumnGrid& grid);

}  // namespace tiller
