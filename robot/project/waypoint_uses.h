// SPDX-License-Identifier: MIT
#pragma once

// References to a waypoint within a project.

#include <QVector>

#include "robot/project/project_file.h"

namespace tiller::project {

struct WaypointUse {
    enum class Kind {
        PatternPlace,   ///< the waypoint is a position of the pattern `name`
        PatternCorner,  ///< the pattern `name` uses the waypoint as a corner
        Home,           ///< the position `name`, which is the Home position, is equal to the waypoint
        Position,       ///< the position `name` is equal to the waypoint
    };
    Kind kind = Kind::PatternPlace;
    QString name;
    friend bool operator==(const WaypointUse&, const WaypointUse&) = default;
};

/// Patterns and positions of the document that refer to the waypoint. May be empty.
QVector<WaypointUse> usesOf(const Project& document, const Waypoint& waypoint);

}  // namespace tiller::project
