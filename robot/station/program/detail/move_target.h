// SPDX-License-Identifier: MIT
#pragma once

// Targets and speeds of the move steps. Private to robot/station/program.

#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

enum class MoveCommand { J, L, P };

/// Fields for waypoint or pose, approach distance, speed, acceleration, blend and actions, depending on the
/// command.
std::vector<StepField> moveFields(MoveCommand command);

/// A target as URScript.
struct MoveTarget {
    QString joints;             ///< joint positions if the target is in joint space; otherwise empty
    QString pose;               ///< TCP pose in the base frame
    QString near;               ///< joint positions near the solution to use; may be empty
    std::optional<Pose> known;  ///< value of `pose`, if known before the run
    /// Target for movel and similar commands, which accept joint positions and poses.
    QString either() const { return joints.isEmpty() ? pose : joints; }
    /// Target for movej: joint positions, or a call that computes them from the pose.
    QString asJoints() const;
};

/// before  distance from the target along -Z of the tool [m]
/// key     field for reporting problems
std::optional<MoveTarget> targetAt(StepWriter& writer, const project::Waypoint& waypoint, double before,
                                   const char* key);

/// Writes the whole step: the move to its target and the actions there.
void writeMove(StepWriter& writer, MoveCommand command);
/// Writes a move to one waypoint with the speed and blend of the step or, if they are not set, of the
/// waypoint.
void writeMoveTo(StepWriter& writer, MoveCommand command, const project::Waypoint& waypoint, bool stops);

/// The waypoint in a field that has already been checked.
const project::Waypoint& waypointOf(StepWriter& writer, const char* key);

}  // namespace tiller::program
