// SPDX-License-Identifier: MIT
#pragma once

// Forward and inverse kinematics of the six-axis UR arm, closed form.
// Frames: `base` is the controller's base frame, `flange` is frame 6 of the DH chain, `tcp` is flange *
// tcpOffset.

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"

namespace tiller::kinematics {

/// T(joint, joint + 1): from the frame before a joint to the one behind it.
/// joint  0 (base) to 5 (wrist 3); q  its position [rad]
/// Threads  any. Real-time: yes
Eigen::Isometry3d linkTransform(const DhParameters& dh, int joint, double q);

/// T_base_i for i = 0 (base) ... 6 (flange).
/// Threads  any. Real-time: yes
std::array<Eigen::Isometry3d, 7> linkFrames(const DhParameters& dh, const JointPositions& q);

/// T_base_flange.
Eigen::Isometry3d forward(const DhParameters& dh, const JointPositions& q);

/// TCP pose in the base frame, with the TCP offset (flange -> TCP) applied.
Pose forwardTcp(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset = {});

/// The geometric Jacobian of the TCP: twist_tcp_base = J qd. Rows vx vy vz wx wy wz [m/s, rad/s].
Matrix6 jacobian(const DhParameters& dh, const JointPositions& q, const Pose& tcpOffset = {});

/// All closed-form solutions (0 to 8), each joint in (-pi, pi].
struct InverseSolutions {
    std::array<JointPositions, 8> q;
    int count = 0;
    /// Those there are.
    std::span<const JointPositions> span() const& { return {q.data(), static_cast<std::size_t>(count)}; }
    std::span<const JointPositions> span() const&& = delete;  ///< a loop would go over what is gone
};

/// T_base_flange to joints. At a wrist singularity, where wrist 3 is free, `wrist3AtSingularity` is used
/// [rad], or the angle nearest to it with which the arm gets there. Closed form on lengths and offsets; what a
/// calibration adds to them is met by Newton steps, once parallel_axes.h has put the frames at their links.
/// Threads  any. Real-time: yes (no allocation)
InverseSolutions inverse(const DhParameters& dh, const Eigen::Isometry3d& T_base_flange,
                         double wrist3AtSingularity = 0.0);

/// The solution nearest to qNear (sum of squared differences) over all branches and their turns inside the
/// joint range; nothing if the pose cannot be reached.
std::optional<JointPositions> inverseNearest(const DhParameters& dh, const Pose& tcpPose,
                                             const Pose& tcpOffset, const JointPositions& qNear,
                                             double jointLimit = kJointPositionLimit);

/// How near the arm is to each of its three singularities; 0 is in it.
struct SingularityMeasure {
    double wrist = 0;     ///< |sin q5|
    double elbow = 0;     ///< |sin q3|
    double shoulder = 0;  ///< how far, along the arm's plane, the wrist centre is from axis 1 [m]
};
SingularityMeasure singularityMeasure(const DhParameters& dh, const JointPositions& q);  ///< q  [rad]

}  // namespace tiller::kinematics
