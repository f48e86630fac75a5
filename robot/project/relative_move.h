// SPDX-License-Identifier: MIT
#pragma once

// A selection of waypoints moved together: by an offset, a turn or a mirror image, in the axes of any frame.

#include <optional>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/project/waypoint_list.h"

namespace tiller::project {

using tiller::operator<<;  // for the enumerations below

struct RelativeMove {
    enum class Kind {
        Offset,  ///< by `offset` along the axes
        Turn,    ///< by `angle` about `axis`, through the frame's origin
        Mirror,  ///< at the plane through the frame's origin that `axis` stands upon
    };
    enum class Axes {
        Frame,  ///< those of `frame`
        Tool,   ///< of each waypoint's own TCP; for offsets and turns (about the TCP)
    };
    Kind kind = Kind::Offset;
    Axes axes = Axes::Frame;
    QUuid frame;                                       ///< null: the base frame
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< [m]
    int axis = 2;                                      ///< 0 X, 1 Y, 2 Z
    double angle = 0;                                  ///< [rad]
};

/// Where the TCP of a waypoint is, in the base frame: by its joints or its pose, whichever rules.
/// Returns  nothing when its frame is not in the list
std::optional<Pose> placeOf(const Waypoint& waypoint, const RobotModel& model, const FrameList& frames);

/// T_base_tcp after the move. In a mirror image the tool's Y and Z are mirrored, and its X is what belongs to them: the
/// tool approaches from the mirrored side.
/// T_base_frame  of the move's frame
Pose movedPose(const Pose& T_base_tcp, const RelativeMove& move, const Pose& T_base_frame);

/// The waypoints after the move, each in the posture nearest to the one it had. A place out of reach is kept, and marked,
/// where the pose rules.
/// Errors   NoSolution where the joints rule and the arm cannot get there: the names are the context, comma separated;
///          InvalidArgument where the frame of the move or of a waypoint is not in the list
Result<std::vector<Waypoint>> movedBy(const std::vector<Waypoint>& waypoints, const RelativeMove& move,
                                      const RobotModel& model, const FrameList& frames);

}  // namespace tiller::project
