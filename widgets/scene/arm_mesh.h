// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Meshes of the arm, generated from the kinematics and proportions of each model: cylindrical joint housings
// with lids, tubes between the housings, and a flange.

#include <array>

#include "robot/core/robot_model.h"
#include "widgets/scene/mesh.h"

namespace tiller {

/// A mesh for each link from 0 (base) to 6 (flange), in the frame of the link.
using ArmMesh = std::array<Mesh, 7>;

/// Takes about a millisecond, so callers should cache the result.
/// Threads  any
ArmMesh armMesh(const RobotModel& model);

}  // namespace tiller
