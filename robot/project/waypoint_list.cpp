// SPDX-License-Identifier: MIT
#include "robot/project/waypoint_list.h"

#include <QRegularExpression>
#include <algorithm>

namespace tiller::project {
namespace {

/// `wanted`, or with the next free number behind it.
template <class Taken>
QString freeName(const QString& wanted, const Taken& taken) {
    if (!taken(wanted)) {
        return wanted;
    }
    static const QRegularExpression trailingNumber(QStringLiteral(R"(^(.*\S)\s+(\d{1,6})$)"));
    const QRegularExpressionMatch match = trailingNumber.match(wanted);
    const QString stem = match.hasMatch() ? match.captured(1) : wanted;
    for (int number = match.hasMatch() ? match.captured(2).toInt() + 1 : 2;; ++number) {
        const QString name = QStringLiteral("%1 %2").arg(stem).arg(number);
        if (!taken(name)) {
            return name;
        }
    }
}

}  // namespace

void FrameList::insert(std::size_t index, Frame frame) {
    const std::size_t at = std::min(index, frames_.size());
    frames_.insert(frames_.begin() + static_cast<std::ptrdiff_t>(at), std::move(frame));
}

void FrameList::remove(std::size_t index) {
    if (index < frames_.size()) {
        frames_.erase(frames_.begin() + static_cast<std::ptrdiff_t>(index));
    }
}

QString FrameList::uniqueName(const QString& wanted) const {
    return freeName(wanted, [this](const QString& name) { return findByName(name) != nullptr; });
}

QString FrameList::nextName(const QString& stem) const {
    return uniqueName(QStringLiteral("%1 %2").arg(stem).arg(size() + 1));
}

const Frame* FrameList::find(const QUuid& id) const {
    const auto found =
        std::find_if(frames_.begin(), frames_.end(), [&](const Frame& f) { return f.id == id; });
    return found == frames_.end() ? nullptr : &*found;
}

const Frame* FrameList::findByName(const QString& name) const {
    const auto found =
        std::find_if(frames_.begin(), frames_.end(), [&](const Frame& f) { return f.name == name; });
    return found == frames_.end() ? nullptr : &*found;
}

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
        return waypoint.pose;  // digit for digit, without a way through a matrix
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
    return waypoint.ruling == Ruling::Pose && waypoint.frame == frame;
}

PoseDifference poseDifference(const Pose& a, const Pose& b) {
    return {(a.position - b.position).norm(),
            rotationVector(rotationMatrix(a.rotation).transpose() * rotationMatrix(b.rotation)).norm()};
}

}  // namespace tiller::project
