// SPDX-License-Identifier: MIT
#pragma once

// Where the move steps go, and how fast. Private to robot/station/program.

#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

enum class MoveCommand { J, L, P };

/// Waypoint or pose, distance before it, speed, acceleration, blend and actions, as the move has them.
std::vector<StepField> moveFields(MoveCommand command);

/// A target as URScript.
struct MoveTarget {
    QString joints;             ///< where the joints are the target; else empty
    QString pose;               ///< of the TCP in the base frame
    QString near;               ///< joints that choose the posture; may be empty
    std::optional<Pose> known;  ///< `pose`, where it does not depend on the run
    /// For movel and the like, which take both.
    QString either() const { return joints.isEmpty() ? pose : joints; }
    /// For movej.
    QString asJoints() const;
};

/// before  distance along -Z of the tool [m].  key  the field that problems are reported at
std::optional<MoveTarget> targetAt(StepWriter& writer, const project::Waypoint& waypoint, double before,
                                   const char* key);

/// The whole step: the move to its target and the actions there.
void writeMove(StepWriter& writer, MoveCommand command);
/// A move to one waypoint with its own speed and blend, or those of the step.
void writeMoveTo(StepWriter& writer, MoveCommand command, const project::Waypoint& waypoint, bool stops);

/// The waypoint of a field; the field has been checked.
const project::Waypoint& waypointOf(StepWriter& writer, const char* key);

}  // namespace tiller::program
