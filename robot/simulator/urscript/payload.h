// SPDX-License-Identifier: MIT
#pragma once

// The payload of the arm as set by a script.

#include <Eigen/Core>

#include "robot/core/spatial.h"

namespace tiller::simulator::urscript {

struct Payload {
    double mass = 0;                                            ///< [kg]
    Eigen::Vector3d centreOfGravity = Eigen::Vector3d::Zero();  ///< [m], flange frame
    Vector6 inertia = Vector6::Zero();  ///< Ixx Iyy Izz Ixy Ixz Iyz [kg m2] about the centre of gravity
};

}  // namespace tiller::simulator::urscript
