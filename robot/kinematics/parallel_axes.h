// SPDX-License-Identifier: MIT
#pragma once

// Kinematic parameters of a calibrated arm, with the frames placed at its links.
//
// The axes of shoulder, elbow and wrist 1 are parallel to within a few thousandths of a radian.
// Denavit-Hartenberg frames are placed where two axes are nearest to each other. For such axes, this point
// may be hundreds of metres away: one robot reports d = 439 m, -446 m and 7 m, and an upper arm of 19 mm. The
// flange pose is correct, but no frame is at the elbow, and no parameter is the length of a link.
//
// Source: S. Hayati, "Robot arm geometric link parameter estimation", 1983; the parameters of a real arm in
// the documentation of ur_calibration, Universal Robots ROS 2 driver.

#include "robot/core/robot_model.h"

namespace tiller::kinematics {

/// Converts to an equivalent arm with d = 0 at shoulder and elbow as in the nominal model, the link lengths
/// in a, and the remaining deviation from parallel axes in beta. Returns `reported` unchanged if axes 2, 3
/// and 4 are far from parallel, or a number is not finite.
/// reported     parameters as in KinematicsInfo
/// Threads  any. Real-time: yes
DhParameters resolveParallelAxes(const DhParameters& reported);

/// Inverse of resolveParallelAxes(): returns parameters without beta, as reported by a controller.
/// Threads  any. Real-time: yes
DhParameters asDenavitHartenberg(const DhParameters& arm);

/// Parameters of the calibrated arm with the frames at the links. Returns the model's parameters if the reported
/// ones are implausible: a number is not finite, a link is longer than 3 m, or the upper arm or forearm is shorter
/// than 50 mm.
/// Threads  any. Real-time: yes
DhParameters calibrated(const RobotModel& model, const DhParameters& reported);

}  // namespace tiller::kinematics
