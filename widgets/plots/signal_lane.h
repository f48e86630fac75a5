// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A bit or a mode over time, as stretches of one state each.

#include <vector>

#include "widgets/plots/state_lane.h"
#include "widgets/signals/series_buffer.h"

namespace tiller {

class SignalStore;

/// What the columns of a grid show of a state. A column in which the state changes more than once is Varied: no
/// change is lost, however far it is zoomed out.
std::vector<LaneSegment> signalSegments(const SignalStore& store, int signal, const ColumnGrid& grid);

}  // namespace tiller
