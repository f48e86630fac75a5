// SPDX-License-Identifier: MIT
#pragma once

// The waypoints of "Run route" in their order, and the progress along them: the next waypoint forward and
// the next one back. Indices count from 0. This class only keeps the state; it moves nothing.

#include <QUuid>
#include <QVector>
#include <optional>

namespace tiller {

class WaypointRoute {
public:
    /// Restarts before the first waypoint.
    void setWaypoints(const QVector<QUuid>& ids);
    /// After an edit of the list: keeps the next waypoint; restarts the route if it was removed.
    void follow(const QVector<QUuid>& ids);
    /// The first waypoint follows the last one.
    void setLoop(bool loop);
    bool isLoop() const { return loop_; }

    int size() const { return static_cast<int>(ids_.size()); }
    QUuid at(int place) const { return ids_.value(place); }
    /// Target of a step forward; nothing after the last.
    std::optional<int> coming() const;
    /// Target of a step back; nothing before the first.
    std::optional<int> before() const;
    /// True after a waypoint was passed, until the restart.
    bool isUnderWay() const { return underWay_; }
    /// True after the last waypoint.
    bool isDone() const { return underWay_ && !coming(); }

    /// The arm is on its way to the waypoint.
    void headOnTo(int place);
    void headBackTo(int place);
    /// The arm has reached the waypoint.
    void reach(int place);
    void restartRoute();

private:
    std::optional<int> next(int place) const;
    std::optional<int> previous(int place) const;

    QVector<QUuid> ids_;
    bool loop_ = false;
    bool underWay_ = false;
    bool cameRound_ = false;  ///< passed from the last waypoint to the first at least once
    std::optional<int> on_;
    std::optional<int> back_;
};

}  // namespace tiller
