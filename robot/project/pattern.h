// SPDX-License-Identifier: MIT
#pragma once

// A tray, a rack or a stack: n x m places between three taught corners, in layers. It stays a pattern, which can
// be changed later, and yields ordinary waypoints, which everything else works with.

#include <array>
#include <vector>

#include "robot/core/robot_model.h"
#include "robot/project/waypoint_list.h"

namespace tiller::project {

using tiller::operator<<;  // for the enumerations below

/// In which order the places of a layer follow each other; layers follow from the first one on.
enum class PatternOrder {
    Rows,     ///< every row from its first place on
    Meander,  ///< every second row backwards: the shortest way
};

struct PatternCell {
    int column = 0;
    int row = 0;
    friend bool operator==(const PatternCell&, const PatternCell&) = default;
};

inline constexpr int kMostPatternSteps = 200;    ///< columns, rows or layers
inline constexpr int kMostPatternPlaces = 5000;  ///< all of them

struct Pattern {
    QUuid id;
    QString name;
    /// The place at column 0, row 0, layer 0: what the others copy, but for their position. Its pose rules, and
    /// its frame is the pattern's.
    Waypoint first;
    Eigen::Vector3d columnEnd = Eigen::Vector3d::Zero();  ///< last place of the first row, in that frame [m]
    Eigen::Vector3d rowEnd = Eigen::Vector3d::Zero();     ///< first place of the last row, in that frame [m]
    int columns = 1;                                      ///< places of a row
    int rows = 1;
    int layers = 1;
    /// From one layer to the next, against the tool's direction (-Z of the TCP at `first`) [m]; below 0: along.
    double layerStep = 0;
    PatternOrder order = PatternOrder::Rows;
    std::vector<PatternCell> excluded;  ///< left out in every layer
    /// The waypoints the corners were taken from (first, column end, row end); null: taught with the arm.
    std::array<QUuid, 3> corners;
    QString note;
    QJsonObject extra;  ///< fields of the file that this version does not know

    friend bool operator==(const Pattern&, const Pattern&) = default;
};
using PatternList = EntityList<Pattern>;

/// The places of a pattern in their order, without those left out.
/// Threads  any. Blocks: never
std::vector<PatternPlace> placesOf(const Pattern& pattern);

/// Where a place is: T_frame_tcp.
Pose poseAt(const Pattern& pattern, const PatternPlace& place);

/// What a pattern's place is called: "tray 2.3", row before column; with layers "tray 1.2.3", layer first.
QString nameAt(const Pattern& pattern, const PatternPlace& place);

/// The waypoint at a place. Its joints are the posture nearest to `near` [rad]; `near` itself where the arm
/// cannot get there: it is kept, and marked like any waypoint out of reach.
/// Returns  with a new id and no history
Waypoint waypointAt(const Pattern& pattern, const PatternPlace& place, const RobotModel& model,
                    const FrameList& frames, const JointPositions& near);

/// All its waypoints in their order, each in the posture nearest to the one before.
std::vector<Waypoint> waypointsOf(const Pattern& pattern, const RobotModel& model, const FrameList& frames);

/// True when the waypoint stands where the pattern puts it; false for one that was moved by hand since.
bool isWhereLaid(const Waypoint& waypoint, const Pattern& pattern);

}  // namespace tiller::project
