// SPDX-License-Identifier: MIT
#pragma once

// The text for the activity of the robot in the lane below the plots.

#include <QString>

#include "robot/station/history/state_lane.h"
#include "robot/station/link/session_state.h"

namespace tiller {

struct LaneEntry {
    LaneKind kind = LaneKind::NoData;
    QString label;
};

/// jogLabel  the pressed key, "X+"; empty if unknown
LaneEntry laneEntry(const SessionState& state, const QString& jogLabel);
/// For a period without data of the robot.
LaneEntry noDataEntry();

}  // namespace tiller
