// SPDX-License-Identifier: MIT
#pragma once

// The latest changes of a waypoint: previous values, author and time. A value type with shared data, because
// every undo step and every autosave keeps a copy.

#include <QDateTime>
#include <QString>
#include <memory>
#include <vector>

namespace tiller::project {

struct Waypoint;
struct WaypointRevision;

class WaypointHistory {
public:
    /// Maximum number of revisions. The oldest revisions are dropped.
    static constexpr int kMaxRevisions = 20;

    int size() const { return static_cast<int>(revisions_.size()); }
    bool isEmpty() const { return revisions_.empty(); }
    /// Index 0 is the oldest. Throws std::out_of_range.
    const WaypointRevision& at(int index) const { return *revisions_.at(static_cast<std::size_t>(index)); }
    /// Adds the newest revision.
    void add(WaypointRevision revision);
    friend bool operator==(const WaypointHistory& a, const WaypointHistory& b);

private:
    std::vector<std::shared_ptr<const WaypointRevision>> revisions_;
};

}  // namespace tiller::project
