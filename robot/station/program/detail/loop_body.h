// SPDX-License-Identifier: MIT
#pragma once

// What the loops share. Private to robot/station/program.

#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

/// The steps of a loop. A pass that may take no time is made to wait for the next control period.
/// mayNotEnd  nothing counts the passes, so a loop that never waits is an error
void writeLoopBody(StepWriter& writer, bool mayNotEnd);

/// A loop with the pose of one place after the other in the step's `variable`.  key  of the field with the places
void writePlaceLoop(StepWriter& writer, const std::vector<project::Waypoint>& places, const char* key);

}  // namespace tiller::program
