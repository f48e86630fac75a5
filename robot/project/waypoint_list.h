// SPDX-License-Identifier: MIT
#pragma once

// The ordered waypoints of a project and their frames. Plain data, used by undo, tables and files.

#include <optional>
#include <vector>

#include "robot/project/entity_list.h"
#include "robot/project/waypoint.h"

namespace tiller::project {

class FrameList : public EntityList<Frame> {
public:
    using EntityList::EntityList;

    /// T_base_frame; the identity for the base frame (null), empty for an unknown ID.
    std::optional<Pose> pose(const QUuid& id) const;
    friend bool operator==(const FrameList&, const FrameList&) = default;
};

class WaypointList {
public:
    int size() const { return static_cast<int>(waypoints_.size()); }
    bool isEmpty() const { return waypoints_.empty(); }
    /// Throws std::out_of_range.
    const Waypoint& at(int index) const { return waypoints_.at(static_cast<std::size_t>(index)); }
    auto begin() const { return waypoints_.begin(); }
    auto end() const { return waypoints_.end(); }

    /// Returns -1 if the ID does not exist.
    int indexOf(const QUuid& id) const;
    int indexOfName(const QString& name) const;  ///< Returns -1 if the name does not exist.

    /// index  0 ... size()
    void insert(int index, Waypoint waypoint);
    void append(Waypoint waypoint) { insert(size(), std::move(waypoint)); }
    Waypoint take(int index);                    ///< Removes and returns a waypoint; later waypoints move up.
    void replace(int index, Waypoint waypoint);  ///< Replaces the waypoint at this index.
    void move(int from, int to);
    void clear() { waypoints_.clear(); }

    /// Returns `wanted` if the name is free, otherwise the name with the next free number: "pick", "pick 2",
    /// "pick 3".
    QString uniqueName(const QString& wanted) const;
    /// The next free name of the form "waypoint 1", "waypoint 2".
    /// stem  the noun in the operator's language
    QString nextName(const QString& stem) const;
    friend bool operator==(const WaypointList&, const WaypointList&) = default;

private:
    std::vector<Waypoint> waypoints_;
};

/// TCP pose of the waypoint in the base frame; empty if its frame is not in the list.
std::optional<Pose> poseInBase(const Waypoint& waypoint, const FrameList& frames);

/// Returns the waypoint taught at this position: with its pose expressed in the frame and its joint positions
/// set. Empty if the frame is not in the list.
std::optional<Waypoint> taughtAt(Waypoint waypoint, const JointPositions& q, const Pose& T_base_tcp,
                                 const Pose& tcpOffset, const FrameList& frames);

/// Expresses the same position in another frame (null: base frame). Only the frame and the stored pose
/// change.
/// Returns  empty if one of the two frames is not in the list
std::optional<Waypoint> givenIn(Waypoint waypoint, const QUuid& frame, const FrameList& frames);

/// True if the waypoint moves with the frame: its pose is the target and is expressed in this frame.
bool movesWith(const Waypoint& waypoint, const QUuid& frame);

/// Difference of two poses: distance [m] and angle [rad].
struct PoseDifference {
    double distance = 0;
    double angle = 0;
};
PoseDifference poseDifference(const Pose& a, const Pose& b);  ///< Both poses must be in the same frame.

}  // namespace tiller::project
