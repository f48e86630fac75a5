// SPDX-License-Identifier: MIT
#pragma once

// The word for what the robot is doing, as the lane under the plots shows it.

#include <QString>

#include "robot/station/history/state_lane.h"
#include "robot/station/link/session_state.h"

namespace tiller {

struct LaneEntry {
    LaneKind kind = LaneKind::NoData;
    QString label;
};

/// jogLabel  the held key, "X+"; empty when not known
LaneEntry laneEntry(const SessionState& state, const QString& jogLabel);
/// For a stretch in which the robot told nothing.
LaneEntry noDataEntry();

}  // namespace tiller
