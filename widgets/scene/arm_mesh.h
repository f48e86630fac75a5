// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Meshes of the arm: cylindrical joint housings with lids, tubes between them, and a flange, generated from the
// kinematics and proportions of each model.

#include <array>

#include "robot/core/robot_model.h"
#include "widgets/scene/mesh.h"

namespace tiller {

/// One mesh per link, in the frame of the link: 0 the base ... 6 the flange.
using ArmMesh = std::array<Mesh, 7>;

/// Threads  any. Takes about a millisecond, so the result should be cached
ArmMesh armMesh(const RobotModel& model);

}  // namespace tiller
