// SPDX-License-Identifier: MIT
#include "robot/project/pattern.h"

#include <algorithm>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller::project {
namespace {

/// Interpolation parameter between the first and the last of `count` positions.
double part(int index, int count) {
    return count > 1 ? static_cast<double>(index) / (count - 1) : 0.0;
}

}  // namespace

std::vector<PatternPlace> placesOf(const Pattern& pattern) {
    std::vector<PatternPlace> places;
    for (int layer = 0; layer < pattern.layers; ++layer) {
        for (int row = 0; row < pattern.rows; ++row) {
            const bool backwards = pattern.order == PatternOrder::Meander && row % 2 == 1;
            for (int step = 0; step < pattern.columns; ++step) {
                const int column = backwards ? pattern.columns - 1 - step : step;
                const auto& out = pattern.excluded;
                if (std::find(out.begin(), out.end(), PatternCell{column, row}) == out.end()) {
                    places.push_back({pattern.id, column, row, layer});
                }
            }
        }
    }
    return places;
}

Pose poseAt(const Pattern& pattern, const PatternPlace& place) {
    const Eigen::Vector3d& origin = pattern.first.pose.position;
    const Eigen::Vector3d away = -rotationMatrix(pattern.first.pose.rotation).col(2);
    Pose pose = pattern.first.pose;
    pose.position += part(place.column, pattern.columns) * (pattern.columnEnd - origin) +
                     part(place.row, pattern.rows) * (pattern.rowEnd - origin) +
                     place.layer * pattern.layerStep * away;
    return pose;
}

QString nameAt(const Pattern& pattern, const PatternPlace& place) {
    const QString cell = QStringLiteral("%1.%2").arg(place.row + 1).arg(place.column + 1);
    return pattern.layers > 1 ? QStringLiteral("%1 %2.%3").arg(pattern.name).arg(place.layer + 1).arg(cell)
                              : QStringLiteral("%1 %2").arg(pattern.name, cell);
}

Waypoint waypointAt(const Pattern& pattern, const PatternPlace& place, const RobotModel& model,
                    const FrameList& frames, const JointPositions& near) {
    Waypoint point = pattern.first;
    point.id = QUuid::createUuid();
    point.name = nameAt(pattern, place);
    point.priority = TargetKind::Pose;
    point.pose = poseAt(pattern, place);
    point.place = place;
    point.history = {};
    point.joints = near;
    if (const std::optional<Pose> target = poseInBase(point, frames)) {
        point.joints = kinematics::inverseNearest(model.dh, *target, point.tcpOffset, near).value_or(near);
    }
    return point;
}

std::vector<Waypoint> waypointsOf(const Pattern& pattern, const RobotModel& model, const FrameList& frames) {
    std::vector<Waypoint> points;
    JointPositions near = pattern.first.joints;
    for (const PatternPlace& place : placesOf(pattern)) {
        points.push_back(waypointAt(pattern, place, model, frames, near));
        near = points.back().joints;
    }
    return points;
}

bool isWhereLaid(const Waypoint& waypoint, const Pattern& pattern) {
    return waypoint.place.pattern == pattern.id && waypoint.priority == TargetKind::Pose &&
           waypoint.frame == pattern.first.frame && waypoint.pose == poseAt(pattern, waypoint.place);
}

}  // namespace tiller::project
