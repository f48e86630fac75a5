// SPDX-License-Identifier: MIT
#include "robot/station/route/waypoint_route.h"

namespace tiller {

void WaypointRoute::setWaypoints(const QVector<QUuid>& ids) {
    ids_ = ids;
    restartRoute();
}

void WaypointRoute::follow(const QVector<QUuid>& ids) {
    if (ids == ids_) {
        return;
    }
    const QUuid coming = on_ ? at(*on_) : QUuid();
    const auto place = ids.indexOf(coming);
    ids_ = ids;
    if (!underWay_ || coming.isNull() || place < 0) {
        restartRoute();
    } else {
        headOnTo(static_cast<int>(place));
    }
}

void WaypointRoute::setLoop(bool loop) {
    loop_ = loop;
    if (loop_ && underWay_ && !on_) {
        on_ = 0;
        cameRound_ = true;
    }
}

void WaypointRoute::restartRoute() {
    underWay_ = false;
    cameRound_ = false;
    on_ = ids_.isEmpty() ? std::nullopt : std::optional(0);
    back_ = std::nullopt;
}

std::optional<int> WaypointRoute::coming() const {
    return on_;
}

std::optional<int> WaypointRoute::before() const {
    return back_;
}

std::optional<int> WaypointRoute::next(int place) const {
    if (place + 1 < size()) {
        return place + 1;
    }
    return loop_ ? std::optional(0) : std::nullopt;
}

std::optional<int> WaypointRoute::previous(int place) const {
    if (place > 0) {
        return place - 1;
    }
    // In the first round of a loop, no waypoint precedes the first waypoint.
    return loop_ && cameRound_ ? std::optional(size() - 1) : std::nullopt;
}

void WaypointRoute::headOnTo(int place) {
    underWay_ = true;
    on_ = place;
    back_ = previous(place);
}

void WaypointRoute::headBackTo(int place) {
    underWay_ = true;
    back_ = place;
    on_ = next(place);
}

void WaypointRoute::reach(int place) {
    underWay_ = true;
    on_ = next(place);
    cameRound_ = cameRound_ || on_ == 0;
    back_ = previous(place);
}

}  // namespace tiller
