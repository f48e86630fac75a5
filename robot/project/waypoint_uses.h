// SPDX-License-Identifier: MIT
#pragma once

// What in a project refers to a waypoint.

#include <QVector>

#include "robot/project/project_file.h"

namespace tiller::project {

struct WaypointUse {
    enum class Kind {
        PatternPlace,   ///< it is a place of the pattern `name`
        PatternCorner,  ///< the pattern `name` was taught at it, and follows it
        Home,           ///< the position `name`, which is Home, is where it is
        Position,       ///< the position `name` is where it is
    };
    Kind kind = Kind::PatternPlace;
    QString name;
    friend bool operator==(const WaypointUse&, const WaypointUse&) = default;
};

/// Patterns and positions of the document that refer to the waypoint; empty: none.
QVector<WaypointUse> usesOf(const Project& document, const Waypoint& waypoint);

}  // namespace tiller::project
