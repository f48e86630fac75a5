// SPDX-License-Identifier: MIT
#pragma once

// A motion taught by hand: joint positions over time, reduced within a stated tolerance.

#include <QDateTime>
#include <QJsonObject>
#include <QString>
#include <QUuid>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"
#include "robot/project/entity_list.h"

namespace tiller::project {

struct PathPoint {
    double time = 0;   ///< since the start [s], increasing
    JointPositions q;  ///< [rad]
    friend bool operator==(const PathPoint&, const PathPoint&) = default;
};

struct RecordedPath {
    QUuid id;
    QString name;
    Pose tcpOffset;        ///< flange to TCP during the recording [m, rad]
    double tolerance = 0;  ///< maximum TCP deviation from the original motion due to the reduction [m]
    std::vector<PathPoint> points;
    QString note;
    QJsonObject extra;  ///< unknown fields of the file, preserved when saving

    double duration() const { return points.empty() ? 0 : points.back().time; }  ///< [s]
    friend bool operator==(const RecordedPath&, const RecordedPath&) = default;
};
using PathList = EntityList<RecordedPath>;

/// Limit of a path: half an hour at 500 Hz.
inline constexpr int kMaxPathPoints = 1'000'000;
inline constexpr double kMaxPathDuration = 86'400;  ///< [s]

}  // namespace tiller::project
