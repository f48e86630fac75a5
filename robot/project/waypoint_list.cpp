// SPDX-License-Identifier: MIT
#include "robot/project/waypoint_list.h"

#include <algorithm>

namespace tiller::project {
std::optional<Pose> FrameList::pose(const QUuid& id) const {
    if (id.isNull()) {
        return Pose();
    }
    const Frame* frame = find(id);
    return frame == nullptr ? std::nullopt : std::optional(frame->T_base_frame);
}

int WaypointList::indexOf(const QUuid& id) const {
    for (int i = 0; i < size(); ++i) {
        if (at(i).id == id) {
            return i;
        }
    }
    return -1;
}

int WaypointList::indexOfName(const QString& name) const {
    for (int i = 0; i < size(); ++i) {
        if (at(i).name == name) {
            return i;
        }
    }
    return -1;
}

void WaypointList::insert(int index, Waypoint waypoint) {
    waypoints_.insert(waypoints_.begin() + std::clamp(index, 0, size()), std::move(waypoint));
}

Waypoint WaypointList::take(int index) {
    Waypoint taken = at(index);
    waypoints_.erase(waypoints_.begin() + index);
    return taken;
}

void WaypointList::replace(int index, Waypoint waypoint) {
    waypoints_.at(static_cast<std::size_t>(index)) = std::move(waypoint);
}

void WaypointList::move(int from, int to) {
    insert(to, take(from));
}

QString WaypointList::uniqueName(const QString& wanted) const {
    return freeName(wanted, [this](const QString& name) { return indexOfName(name) >= 0; });
}

QString WaypointList::nextName(const QString& stem) const {
    return uniqueName(QStringLiteral("%1 %2").arg(stem).arg(size() + 1));
}

std::optional<Pose> poseInBase(const Waypoint& waypoint, const FrameList& frames) {
    const std::optional<Pose> frame = frames.pose(waypoint.frame);
    if (!frame) {
        return std::nullopt;
    }
    if (waypoint.frame.isNull()) {
        return waypoint.pose;  // exactly equal, without matrix conversion
    }
    return Pose(frame->transform() * waypoint.pose.transform());
}

std::optional<Waypoint> taughtAt(Waypoint waypoint, const JointPositions& q, const Pose& T_base_tcp,
                                 const Pose& tcpOffset, const FrameList& frames) {
    const std::optional<Pose> frame = frames.pose(waypoint.frame);
    if (!frame) {
        return std::nullopt;
    }
    waypoint.joints = q;
    waypoint.tcpOffset = tcpOffset;
    waypoint.pose = waypoint.frame.isNull()
                        ? T_base_tcp
                        : Pose(frame->transform().inverse(Eigen::Isometry) * T_base_tcp.transform());
    return waypoint;
}

std::optional<Waypoint> givenIn(Waypoint waypoint, const QUuid& frame, const FrameList& frames) {
    const std::optional<Pose> place = poseInBase(waypoint, frames);
    if (!place) {
        return std::nullopt;
    }
    waypoint.frame = frame;
    return taughtAt(waypoint, waypoint.joints, *place, waypoint.tcpOffset, frames);
}

bool movesWith(const Waypoint& waypoint, const QUuid& frame) {
    return waypoint.priority == TargetKind::Pose && waypoint.frame == frame;
}

PoseDifference poseDifference(const Pose& a, const Pose& b) {
    return {(a.position - b.position).norm(),
            rotationVector(rotationMatrix(a.rotation).transpose() * rotationMatrix(b.rotation)).norm()};
}

}  // namespace tiller::project
