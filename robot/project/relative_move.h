// SPDX-License-Identifier: MIT
#pragma once

// Moves a selection of waypoints together: by an offset, a rotation or a mirror image, relative to any frame.

#include <optional>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/project/waypoint_list.h"

namespace tiller::project {

using tiller::operator<<;  // makes the enumerations below printable

struct RelativeMove {
    enum class Kind {
        Offset,  ///< translation by `offset` along the axes
        Turn,    ///< rotation by `angle` about `axis` through the origin of the frame
        Mirror,  ///< reflection in the plane through the frame's origin normal to `axis`
    };
    enum class Axes {
        Frame,  ///< axes of `frame`
        Tool,   ///< axes of each waypoint's TCP; for offsets and rotations (about the TCP)
    };
    Kind kind = Kind::Offset;
    Axes axes = Axes::Frame;
    QUuid frame;                                       ///< null: the base frame
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< [m]
    int axis = 2;                                      ///< 0 X, 1 Y, 2 Z
    double angle = 0;                                  ///< [rad]
};

/// TCP pose of a waypoint in the base frame, from its joint positions or its pose, depending on the target
/// type.
/// Returns  empty if its frame is not in the list
std::optional<Pose> placeOf(const Waypoint& waypoint, const RobotModel& model, const FrameList& frames);

/// T_base_tcp after the move. For a mirror image, Y and Z of the tool are mirrored, and X is derived from
/// them, so that the tool approaches from the mirrored side.
/// T_base_frame  frame of the move
Pose movedPose(const Pose& T_base_tcp, const RelativeMove& move, const Pose& T_base_frame);

/// The waypoints after the move, each with the joint positions nearest to the previous joint positions. An
/// unreachable pose target is kept and marked.
/// Errors   NoSolution if a waypoint with a joint target is unreachable (the context contains the names,
///          separated by commas); InvalidArgument if the frame of the move or of a waypoint is not in the
///          list
Result<std::vector<Waypoint>> movedBy(const std::vector<Waypoint>& waypoints, const RelativeMove& move,
                                      const RobotModel& model, const FrameList& frames);

}  // namespace tiller::project
