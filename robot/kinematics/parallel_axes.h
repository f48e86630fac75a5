// SPDX-License-Identifier: MIT
#pragma once

// A calibrated arm, described with its frames where its links are.
//
// Shoulder, elbow and wrist 1 turn about axes that are parallel but for some thousandths of a radian. By the rule of
// Denavit and Hartenberg a frame stands where two axes are nearest to each other, which for such axes may be
// hundreds of metres away: a robot tells d = 439 m, -446 m and 7 m, and an upper arm of 19 mm. The flange comes
// out right, yet the elbow is none of the frames, and no length is that of a link.
// Source: S. Hayati, "Robot arm geometric link parameter estimation", 1983; the parameters of a real arm in the
// documentation of ur_calibration, Universal Robots ROS 2 driver.

#include "robot/core/robot_model.h"

namespace tiller::kinematics {

/// The same arm, flange and axes alike, with d = 0 at the shoulder and the elbow as in every model, the links'
/// true lengths in a, and beta for what is missing to parallel. As told where it is no such arm: axes 2, 3
/// and 4 are far from parallel, or a number is not finite.
/// told  as KinematicsInfo has it
/// Threads  any. Real-time: yes
DhParameters resolveParallelAxes(const DhParameters& told);

/// The other way round: without beta, as a controller tells it.
/// Threads  any. Real-time: yes
DhParameters asDenavitHartenberg(const DhParameters& arm);

/// The arm by its own calibration, frames at its links; the model's where what is told is no arm: a number is not
/// finite, some link is longer than 3 m, or upper arm or forearm are shorter than 50 mm.
/// Threads  any. Real-time: yes
DhParameters calibrated(const RobotModel& model, const DhParameters& told);

}  // namespace tiller::kinematics
