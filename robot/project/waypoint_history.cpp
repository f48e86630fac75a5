// SPDX-License-Identifier: MIT
#include "robot/project/waypoint_history.h"

#include <algorithm>

#include "robot/project/waypoint_revision.h"

namespace tiller::project {

void WaypointHistory::add(WaypointRevision revision) {
    revision.before.history = {};
    if (size() == kMaxRevisions) {
        revisions_.erase(revisions_.begin());
    }
    revisions_.push_back(std::make_shared<const WaypointRevision>(std::move(revision)));
}

bool operator==(const WaypointHistory& a, const WaypointHistory& b) {
    return std::equal(a.revisions_.begin(), a.revisions_.end(), b.revisions_.begin(), b.revisions_.end(),
                      [](const auto& one, const auto& other) { return one == other || *one == *other; });
}

Waypoint withRevision(Waypoint after, const Waypoint& before, const QDateTime& at, const QString& who,
                      const QString& what) {
    after.history = before.history;
    after.history.add({QDateTime::fromSecsSinceEpoch(at.toSecsSinceEpoch()).toUTC(), who, what, before, {}});
    return after;
}

}  // namespace tiller::project
