// SPDX-License-Identifier: MIT
#pragma once

// One change of a waypoint, with what it was before.

#include "robot/project/waypoint.h"

namespace tiller::project {

struct WaypointRevision {
    QDateTime at;       ///< of the change, UTC, whole seconds
    QString who;        ///< who changed it; may be empty
    QString what;       ///< the edit in words: "Touch up"
    Waypoint before;    ///< without its history
    QJsonObject extra;  ///< fields of the file that this version does not know
    friend bool operator==(const WaypointRevision&, const WaypointRevision&) = default;
};

/// `after` with its earlier self in the history: what changeWaypoint keeps.
/// at  taken as UTC, whole seconds
Waypoint withRevision(Waypoint after, const Waypoint& before, const QDateTime& at, const QString& who,
                      const QString& what);

}  // namespace tiller::project
