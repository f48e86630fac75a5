// SPDX-License-Identifier: MIT
#pragma once

// Texts for the actions at a waypoint.

#include <QCoreApplication>
#include <QStringList>

#include "robot/project/waypoint_action.h"

namespace tiller {

class ActionWords {
    Q_DECLARE_TR_FUNCTIONS(ActionWords)

public:
    /// Examples: "DO 3 on", "CO 0 on for 0.5 s", "Wait until DI 2 is off (max. 10 s)", "Wait 2 s", "Close the
    /// gripper".
    static QString of(const project::WaypointAction& action);
    static QStringList of(const project::WaypointActions& actions);
    /// One text per kind of action, in the order of the kinds, e.g. "Set an output".
    static QStringList kinds();
    /// Label of the terminal, e.g. "DO 3", "TI 1": the input for which the action waits, or the output.
    static QString terminal(const project::WaypointAction& action);
};

}  // namespace tiller
