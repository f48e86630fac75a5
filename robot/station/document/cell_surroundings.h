// SPDX-License-Identifier: MIT
#pragma once

// The objects of the project that the arm could collide with, in the base frame.

#include "robot/collision/surroundings.h"
#include "robot/project/project_file.h"

namespace tiller {

/// Floor, enabled planes and boxes of the cell, the radius of the active tool, and the safety distance.
/// Enabled planes and boxes whose frame is not in the project are listed as unplaced.
/// Threads  any. Blocks: never
collision::CellSurroundings surroundingsOf(const project::Project& project);

}  // namespace tiller
