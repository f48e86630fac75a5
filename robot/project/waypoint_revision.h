// SPDX-License-Identifier: MIT
#pragma once

// One change of a waypoint, with its previous values.

#include "robot/project/waypoint.h"

namespace tiller::project {

struct WaypointRevision {
    QDateTime at;       ///< time of the change (UTC, whole seconds)
    QString who;        ///< author of the change; may be empty
    QString what;       ///< description of the change, e.g. "Touch up"
    Waypoint before;    ///< previous waypoint, without its history
    QJsonObject extra;  ///< unknown fields of the file, preserved when saving
    friend bool operator==(const WaypointRevision&, const WaypointRevision&) = default;
};

/// Returns `after` with `before` added to its history, as stored by changeWaypoint.
/// at  converted to UTC, whole seconds
Waypoint withRevision(Waypoint after, const Waypoint& before, const QDateTime& at, const QString& who,
                      const QString& what);

}  // namespace tiller::project
