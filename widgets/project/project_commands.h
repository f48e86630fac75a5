// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The edits of a project, each with its way back: four of the list of waypoints, one of the frames.

#include <QUndoCommand>
#include <QVector>
#include <vector>

#include "robot/project/waypoint_list.h"

namespace tiller {

class ProjectDocument;

class InsertWaypoints : public QUndoCommand {
public:
    InsertWaypoints(ProjectDocument& document, int row, std::vector<project::Waypoint> waypoints,
                    const QString& text);
    void redo() override;
    void undo() override;

private:
    ProjectDocument& document_;
    int row_;
    std::vector<project::Waypoint> waypoints_;
};

class RemoveWaypoints : public QUndoCommand {
public:
    RemoveWaypoints(ProjectDocument& document, QVector<int> rows, const QString& text);
    void redo() override;
    void undo() override;

private:
    ProjectDocument& document_;
    QVector<int> rows_;  // ascending
    std::vector<project::Waypoint> taken_;
};

class ChangeWaypoint : public QUndoCommand {
public:
    ChangeWaypoint(ProjectDocument& document, int row, project::Waypoint after, const QString& text);
    void redo() override;
    void undo() override;

private:
    ProjectDocument& document_;
    project::Waypoint before_;
    project::Waypoint after_;
};

class ReorderWaypoints : public QUndoCommand {
public:
    ReorderWaypoints(ProjectDocument& document, QVector<QUuid> order, const QString& text);
    void redo() override;
    void undo() override;

private:
    ProjectDocument& document_;
    QVector<QUuid> before_;
    QVector<QUuid> after_;
};

/// There are few frames: the whole list is kept.
class EditFrames : public QUndoCommand {
public:
    EditFrames(ProjectDocument& document, project::FrameList after, const QString& text);
    void redo() override;
    void undo() override;

private:
    ProjectDocument& document_;
    project::FrameList before_;
    project::FrameList after_;
};

}  // namespace tiller
