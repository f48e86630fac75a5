// SPDX-License-Identifier: MIT
#pragma once

// Closed-form forward and inverse kinematics of the six-axis UR arm.
// Frames: `base` is the controller's base frame, `flange` is frame 6 of the DH chain, `tcp` is flange * tcpOffset.

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"

namespace tiller::kinematics {

/// Transform of one link: T(joint, joint + 1).
/// joint  0 (base) to 5 (wrist 3)
/// q      position of the joint [rad]
/// Threads  any. Real-time: yes
Eigen::Isometry3d linkTransform(const DhParameters& dh, int joint, double q);

/// T_base_i for i = 0 (base) ... 6 (flange).
/// Threads  any. Real-time: yes
std::array<Eigen::Isometry3d, 7> linkFrames(const DhParameters& dh, const JointPositions& q);

/// T_base_flange.
Eigen::Isometry3d forward(const DhParameters& dh, const JointPositions& q);

/// TCP pose in the base frame, with the TCP offset (flange -> TCP) applied.
Pose forwardTcp(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset = {});

/// Geometric Jacobian of the TCP: twist_tcp_base = J qd. Rows vx vy vz wx wy wz [m/s, rad/s].
Matrix6 jacobian(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset = {});

/// Up to 8 closed-form solutions, each joint in (-pi, pi].
struct InverseSolutions {
    std::array<JointPositions, 8> q;
    int count = 0;
    /// The valid solutions.
    std::span<const JointPositions> span() const& { return {q.data(), static_cast<std::size_t>(count)}; }
    std::span<const JointPositions> span() const&& = delete;  ///< avoids a dangling span of a temporary
};

/// Joint positions for T_base_flange. At a wrist singularity, where wrist 3 is free, `wrist3AtSingularity`
/// [rad] is used, or the nearest angle at which the pose is reachable. The closed form covers link lengths
/// and offsets. Newton steps correct the deviations of a calibrated arm; they require the frames to be placed
/// at the links, see parallel_axes.h.
/// Threads  any. Real-time: yes (no allocation)
InverseSolutions inverse(const DhParameters& dh, const Eigen::Isometry3d& T_base_flange,
                         double wrist3AtSingularity = 0.0);

/// The solution nearest to qNear (sum of squared differences), over all branches and full turns within the joint
/// range; empty if the pose is not reachable.
std::optional<JointPositions> inverseNearest(const DhParameters& dh, const Pose& tcpPose,
                                             const Pose& tcpOffset, const JointPositions& qNear,
                                             double jointLimit = kJointPositionLimit);

/// Distance of the arm from its three singularities; 0 is singular.
struct SingularityMeasure {
    double wrist = 0;     ///< |sin q5|
    double elbow = 0;     ///< |sin q3|
    double shoulder = 0;  ///< distance of the wrist centre from axis 1 in the plane of the arm [m]
};
SingularityMeasure singularityMeasure(const DhParameters& dh, const JointPositions& q);  ///< q  [rad]

}  // namespace tiller::kinematics
