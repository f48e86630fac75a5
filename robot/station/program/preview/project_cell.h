// SPDX-License-Identifier: MIT
#pragma once

// What a project knows about the surroundings of the arm, for checks of collisions.

#include "robot/collision/surroundings.h"
#include "robot/project/cell_geometry.h"
#include "robot/project/tooling.h"
#include "robot/project/waypoint_list.h"

namespace tiller::program {

/// In the base frame; a box or plane in a frame that is not in the project is left out.
collision::CellSurroundings cellSurroundings(const project::CellGeometry& cell,
                                             const project::FrameList& frames,
                                             const project::Tooling& tooling);

}  // namespace tiller::program
