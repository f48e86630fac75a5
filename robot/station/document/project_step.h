// SPDX-License-Identifier: MIT
#pragma once

// Describes the change made by an undo or redo.

#include <QString>
#include <QUuid>

namespace tiller {

/// The part of the project that an edit changes. Determines where the window shows the change.
enum class ProjectPart { Waypoints, Frames, Tcps, Payloads, Positions, Cell, Programs };

/// An edit that was undone or redone.
struct ProjectStep {
    bool undone = true;
    QString text;  ///< description of the edit, e.g. "Change the TCP “gripper”"
    ProjectPart part = ProjectPart::Waypoints;
    QUuid id;  ///< first changed waypoint, frame, tool, payload, position or program; null if removed
};

}  // namespace tiller
