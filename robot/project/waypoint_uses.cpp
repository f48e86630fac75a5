// SPDX-License-Identifier: MIT
#include "robot/project/waypoint_uses.h"

#include <algorithm>

namespace tiller::project {

QVector<WaypointUse> usesOf(const Project& document, const Waypoint& waypoint) {
    constexpr double kSame = 1e-6;  // [rad]
    QVector<WaypointUse> uses;
    for (const Pattern& pattern : document.patterns) {
        if (pattern.id == waypoint.place.pattern) {
            uses.append({WaypointUse::Kind::PatternPlace, pattern.name});
        }
        if (std::find(pattern.corners.begin(), pattern.corners.end(), waypoint.id) != pattern.corners.end()) {
            uses.append({WaypointUse::Kind::PatternCorner, pattern.name});
        }
    }
    for (const NamedPosition& position : document.positions.list) {
        if ((position.joints.values - waypoint.joints.values).cwiseAbs().maxCoeff() < kSame) {
            uses.append({position.id == document.positions.home ? WaypointUse::Kind::Home
                                                                : WaypointUse::Kind::Position,
                         position.name});
        }
    }
    return uses;
}

}  // namespace tiller::project
