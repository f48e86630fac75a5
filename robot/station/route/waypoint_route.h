// SPDX-License-Identifier: MIT
#pragma once

// The waypoints of "Run route" in their order, and the progress: the next waypoint forward and back. Indices
// count from 0. This class only keeps the state and does not move the arm.

#include <QUuid>
#include <QVector>
#include <optional>

namespace tiller {

class WaypointRoute {
public:
    /// Sets the waypoints and restarts the route.
    void setWaypoints(const QVector<QUuid>& ids);
    /// Call after an edit of the list. Keeps the next waypoint if it still exists and the route has begun.
    /// Otherwise, restarts the route.
    void follow(const QVector<QUuid>& ids);
    /// If true, the first waypoint follows the last waypoint.
    void setLoop(bool loop);
    bool isLoop() const { return loop_; }

    int size() const { return static_cast<int>(ids_.size()); }
    QUuid at(int place) const { return ids_.value(place); }
    /// Next waypoint in forward direction; empty after the last waypoint.
    std::optional<int> coming() const;
    /// Next waypoint in backward direction; empty before the first waypoint.
    std::optional<int> before() const;
    /// True from the first move or reached waypoint until a restart.
    bool isUnderWay() const { return underWay_; }
    /// True after the last waypoint.
    bool isDone() const { return underWay_ && !coming(); }

    /// Call when the arm starts to move to the waypoint.
    void headOnTo(int place);
    void headBackTo(int place);
    /// Call when the arm has reached the waypoint.
    void reach(int place);
    void restartRoute();

private:
    std::optional<int> next(int place) const;
    std::optional<int> previous(int place) const;

    QVector<QUuid> ids_;
    bool loop_ = false;
    bool underWay_ = false;
    bool cameRound_ = false;  ///< the loop has continued from the last waypoint to the first
    std::optional<int> on_;
    std::optional<int> back_;
};

}  // namespace tiller
