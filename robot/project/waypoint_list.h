// SPDX-License-Identifier: MIT
#pragma once

// The waypoints of a project in the operator's order, and the frames they are given in. Plain data: undo,
// tables and files are built around it.

#include <optional>
#include <vector>

#include "robot/project/entity_list.h"
#include "robot/project/waypoint.h"

namespace tiller::project {

class FrameList : public EntityList<Frame> {
public:
    using EntityList::EntityList;

    /// T_base_frame; the identity for the base frame, nothing for an id that is not here.
    std::optional<Pose> pose(const QUuid& id) const;
    friend bool operator==(const FrameList&, const FrameList&) = default;
};

class WaypointList {
public:
    int size() const { return static_cast<int>(waypoints_.size()); }  ///< Number of waypoints.
    bool isEmpty() const { return waypoints_.empty(); }               ///< No waypoint at all.
    /// Throws std::out_of_range.
    const Waypoint& at(int index) const { return waypoints_.at(static_cast<std::size_t>(index)); }
    auto begin() const { return waypoints_.begin(); }
    auto end() const { return waypoints_.end(); }

    /// -1 when there is none.
    int indexOf(const QUuid& id) const;
    int indexOfName(const QString& name) const;  ///< -1 when there is none.

    /// index  0 ... size(); the new one stands there afterwards
    void insert(int index, Waypoint waypoint);
    void append(Waypoint waypoint) { insert(size(), std::move(waypoint)); }  ///< At the end.
    Waypoint take(int index);                    ///< Out of the list; those behind move up.
    void replace(int index, Waypoint waypoint);  ///< Its place stays.
    /// Afterwards the waypoint that was at `from` is at `to`.
    void move(int from, int to);
    void clear() { waypoints_.clear(); }  ///< All go.

    /// `wanted` if nobody has that name, else with the next free number: "pick", "pick 2", "pick 3".
    QString uniqueName(const QString& wanted) const;
    /// "waypoint 1", "waypoint 2": the next free one. stem  the word in the operator's language
    QString nextName(const QString& stem) const;
    friend bool operator==(const WaypointList&, const WaypointList&) = default;

private:
    std::vector<Waypoint> waypoints_;
};

/// The waypoint's TCP pose in the base frame; nothing when its frame is not in the list.
std::optional<Pose> poseInBase(const Waypoint& waypoint, const FrameList& frames);

/// As taught: its pose is expressed in the frame, its joints kept.
/// Returns  nothing when the frame is not in the list
std::optional<Waypoint> taughtAt(Waypoint waypoint, const JointPositions& q, const Pose& T_base_tcp,
                                 const Pose& tcpOffset, const FrameList& frames);

/// The same place given in another frame (null: the base): only the axes of its pose are others.
/// Returns  nothing when one of the two frames is not in the list
std::optional<Waypoint> givenIn(Waypoint waypoint, const QUuid& frame, const FrameList& frames);

/// True when the waypoint moves with the frame: its pose rules, and is given in it.
bool movesWith(const Waypoint& waypoint, const QUuid& frame);

/// How far apart two poses are: distance [m] and angle [rad].
struct PoseDifference {
    double distance = 0;
    double angle = 0;
};
PoseDifference poseDifference(const Pose& a, const Pose& b);  ///< In whichever frame both are.

}  // namespace tiller::project
