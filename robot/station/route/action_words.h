// SPDX-License-Identifier: MIT
#pragma once

// Describes the actions at a waypoint in words.

#include <QCoreApplication>
#include <QStringList>

#include "robot/project/waypoint_action.h"

namespace tiller {

class ActionWords {
    Q_DECLARE_TR_FUNCTIONS(ActionWords)

public:
    /// "DO 3 on", "CO 0 on for 0.5 s", "Wait for DI 2 off, at most 10 s", "Wait 2 s", "Close the gripper"
    static QString of(const project::WaypointAction& action);
    static QStringList of(const project::WaypointActions& actions);
    /// "Set an output" ...; one entry per kind, in their order.
    static QStringList kinds();
    /// "DO 3", "TI 1": an input if the action waits for one, otherwise an output.
    static QString terminal(const project::WaypointAction& action);
};

}  // namespace tiller
