// SPDX-License-Identifier: MIT
#pragma once

// What a waypoint was before each of its latest changes, who made the change, and when. A value: copies share
// what they have in common, since every undo step and every autosave keeps one.

#include <QDateTime>
#include <QString>
#include <memory>
#include <vector>

namespace tiller::project {

struct Waypoint;
struct WaypointRevision;

class WaypointHistory {
public:
    /// Older ones go.
    static constexpr int kMostRevisions = 20;

    int size() const { return static_cast<int>(revisions_.size()); }  ///< Number of revisions.
    bool isEmpty() const { return revisions_.empty(); }               ///< Never changed.
    /// The oldest is 0. Throws std::out_of_range.
    const WaypointRevision& at(int index) const { return *revisions_.at(static_cast<std::size_t>(index)); }
    /// As the newest one.
    void add(WaypointRevision revision);
    friend bool operator==(const WaypointHistory& a, const WaypointHistory& b);

private:
    std::vector<std::shared_ptr<const WaypointRevision>> revisions_;
};

}  // namespace tiller::project
