// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The arm's housings: drums where joints turn, with a lid on their free end, tubes between them, a flange. Made from
// the kinematics and the proportions of each model.

#include <array>

#include "robot/core/robot_model.h"
#include "widgets/scene/mesh.h"

namespace tiller {

/// One mesh a link, in the link's own frame: 0 the base ... 6 the flange.
using ArmMesh = std::array<Mesh, 7>;

/// Threads  any. Takes about a millisecond: keep it
ArmMesh armMesh(const RobotModel& model);

}  // namespace tiller
