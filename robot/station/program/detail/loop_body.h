// SPDX-License-Identifier: MIT
#pragma once

// Code shared by the loop steps. Private to robot/station/program.

#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

/// Writes the steps of a loop. If an iteration may take no time, the loop waits for the next control period.
/// mayNotEnd  iterations are not counted, so a loop that never waits is an error
void writeLoopBody(StepWriter& writer, bool mayNotEnd);

/// Writes a loop that assigns the poses to the step's `variable` in turn.
/// key  field with the poses
void writePlaceLoop(StepWriter& writer, const std::vector<project::Waypoint>& places, const char* key);

}  // namespace tiller::program
