// SPDX-License-Identifier: MIT
#pragma once

// The waypoints that "Go through" goes through, in their order, and how far it has come: which one is the coming one,
// and which one is a step back. Places count from 0; nothing here moves anything.

#include <QUuid>
#include <QVector>
#include <optional>

namespace tiller {

class WaypointRoute {
public:
    /// Begins anew, before the first.
    void setWaypoints(const QVector<QUuid>& ids);
    /// After an edit of the list: the coming one stays the coming one; where it has gone the route begins anew.
    void follow(const QVector<QUuid>& ids);
    /// After the last comes the first again.
    void setLoop(bool loop);
    bool isLoop() const { return loop_; }

    int size() const { return static_cast<int>(ids_.size()); }
    QUuid at(int place) const { return ids_.value(place); }
    /// Where a step on leads; nothing behind the last.
    std::optional<int> coming() const;
    /// Where a step back leads; nothing before the first.
    std::optional<int> before() const;
    /// True once something was gone, until it begins anew.
    bool isUnderWay() const { return underWay_; }
    /// True behind the last.
    bool isDone() const { return underWay_ && !coming(); }

    /// The arm is on its way there.
    void headOnTo(int place);
    void headBackTo(int place);
    /// The arm has come there.
    void reach(int place);
    void beginAnew();

private:
    std::optional<int> next(int place) const;
    std::optional<int> previous(int place) const;

    QVector<QUuid> ids_;
    bool loop_ = false;
    bool underWay_ = false;
    bool cameRound_ = false;  ///< from the last to the first at least once
    std::optional<int> on_;
    std::optional<int> back_;
};

}  // namespace tiller
