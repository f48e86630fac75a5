// SPDX-License-Identifier: MIT
#pragma once

// Which steps depend on a waypoint, and which steps an edit outside of the programs has changed.

#include <QSet>
#include <QUuid>

#include "robot/project/project_file.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

/// Number of steps in all programs that refer to the waypoint or to its group.
int countUses(const project::Project& project, const project::Waypoint& waypoint);

/// The steps contained in both scripts whose lines differ. For two scripts of the same steps, these are the
/// steps that depend on the changed waypoint, frame or tool.
QSet<QUuid> changedSteps(const ProgramScript& before, const ProgramScript& after);

}  // namespace tiller::program
