// SPDX-License-Identifier: MIT
#pragma once

// Text for the activity of the robot in the lane below the plots.

#include <QString>
#include <optional>

#include "robot/station/history/state_lane.h"
#include "robot/station/link/session_state.h"

namespace tiller {

struct LaneEntry {
    LaneKind kind = LaneKind::NoData;
    QString label;
};

/// jogLabel   label of the pressed jog button, e.g. "X+"; empty if unknown
/// stepLabel  running step of a program; empty if no program runs
LaneEntry laneEntry(const SessionState& state, const QString& jogLabel, const QString& stepLabel = {});
/// Entry for a mode in which the arm cannot move; empty if the arm can move.
std::optional<LaneEntry> hinderedEntry(RobotMode robotMode, SafetyMode safetyMode);
/// Entry for an arm that can move, whether Tiller or another client controls it.
LaneEntry motionEntry(bool moving);
LaneEntry noDataEntry();

}  // namespace tiller
