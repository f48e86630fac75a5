// SPDX-License-Identifier: MIT
#pragma once

// A pattern such as a tray, rack or stack: columns x rows between three taught corners, in layers. The
// pattern stays editable and creates ordinary waypoints.

#include <array>
#include <vector>

#include "robot/core/robot_model.h"
#include "robot/project/waypoint_list.h"

namespace tiller::project {

using tiller::operator<<;  // makes the enumerations below printable

/// Order of the positions within a layer. Layers follow in ascending order.
enum class PatternOrder {
    Rows,     ///< every row starts at the first column
    Meander,  ///< every second row in reverse, for the shortest path
};

struct PatternCell {
    int column = 0;
    int row = 0;
    friend bool operator==(const PatternCell&, const PatternCell&) = default;
};

inline constexpr int kMaxPatternSteps = 200;       ///< limit for columns, rows and layers
inline constexpr int kMaxPatternPositions = 5000;  ///< limit for the product of columns, rows and layers

struct Pattern {
    QUuid id;
    QString name;
    /// The waypoint at column 0, row 0, layer 0. Except for the position, it is the template of all
    /// waypoints. Its pose is the target, and its frame is the frame of the pattern.
    Waypoint first;
    Eigen::Vector3d columnEnd =
        Eigen::Vector3d::Zero();  ///< position at the end of the first row, in the frame of the pattern [m]
    Eigen::Vector3d rowEnd =
        Eigen::Vector3d::Zero();  ///< position at the start of the last row, in the frame of the pattern [m]
    int columns = 1;              ///< positions per row
    int rows = 1;
    int layers = 1;
    /// Distance between layers along -Z of the TCP at `first`, i.e. against the tool direction [m]; negative:
    /// in the tool direction.
    double layerStep = 0;
    PatternOrder order = PatternOrder::Rows;
    std::vector<PatternCell> excluded;  ///< skipped in every layer
    /// Waypoints used as corners (first, column end, row end); null: taught with the arm.
    std::array<QUuid, 3> corners;
    QString note;
    QJsonObject extra;  ///< unknown fields of the file, preserved when saving

    friend bool operator==(const Pattern&, const Pattern&) = default;
};
using PatternList = EntityList<Pattern>;

/// The positions of a pattern in order, without the excluded cells.
/// Threads  any. Blocks: never
std::vector<PatternPlace> placesOf(const Pattern& pattern);

/// T_frame_tcp of a position.
Pose poseAt(const Pattern& pattern, const PatternPlace& place);

/// Name of a position: "tray 2.3" (row, column), or "tray 1.2.3" (layer, row, column) with several layers.
QString nameAt(const Pattern& pattern, const PatternPlace& place);

/// The waypoint for a position. Its joint positions are the solution nearest to `near` [rad]. If the position
/// is unreachable, they are `near`, and the waypoint is marked as unreachable.
/// Returns  a waypoint with a new ID and without history
Waypoint waypointAt(const Pattern& pattern, const PatternPlace& place, const RobotModel& model,
                    const FrameList& frames, const JointPositions& near);

/// All waypoints in order. The joint positions of each waypoint are the solution nearest to those of the
/// previous waypoint.
std::vector<Waypoint> waypointsOf(const Pattern& pattern, const RobotModel& model, const FrameList& frames);

/// True if the waypoint has the pose defined by the pattern; false if it was changed manually.
bool isWhereLaid(const Waypoint& waypoint, const Pattern& pattern);

}  // namespace tiller::project
