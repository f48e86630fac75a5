// SPDX-License-Identifier: MIT
#pragma once

// A motion that was shown by hand and kept: the joints over time, thinned to a tolerance that is stated.

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
    double time = 0;   ///< since the beginning [s], rising
    JointPositions q;  ///< [rad]
    friend bool operator==(const PathPoint&, const PathPoint&) = default;
};

struct RecordedPath {
    QUuid id;
    QString name;
    Pose tcpOffset;        ///< flange to TCP while it was recorded [m, rad]
    double tolerance = 0;  ///< the TCP was nowhere farther from the path than this when it was thinned [m]
    std::vector<PathPoint> points;
    QString note;
    QJsonObject extra;  ///< fields of the file that this version does not know

    double duration() const { return points.empty() ? 0 : points.back().time; }  ///< [s]
    friend bool operator==(const RecordedPath&, const RecordedPath&) = default;
};
using PathList = EntityList<RecordedPath>;

/// More than this no path may have: half an hour at 500 Hz.
inline constexpr int kMostPathPoints = 1'000'000;
inline constexpr double kLongestPath = 86'400;  ///< [s]

}  // namespace tiller::project
