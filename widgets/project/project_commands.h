// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The edits of a project, each with its way back: four of the list of waypoints, one of any other part.

#include <QUndoCommand>
#include <QVector>
#include <vector>

#include "widgets/project/project_document.h"

namespace tiller {

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

class ChangeWaypoints : public QUndoCommand {
public:
    /// after  as many as there are rows
    ChangeWaypoints(ProjectDocument& document, const QVector<int>& rows, std::vector<project::Waypoint> after,
                    const QString& text);
    void redo() override;
    void undo() override;

private:
    ProjectDocument& document_;
    std::vector<project::Waypoint> before_;
    std::vector<project::Waypoint> after_;
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

/// There is little of these: the whole part is kept.
template <class Part>
class EditPart : public QUndoCommand {
public:
    EditPart(ProjectDocument& document, Part project::Project::*part, Part after, const QString& text)
        : QUndoCommand(text)
        , document_(document)
        , part_(part)
        , before_(document.project().*part)
        , after_(std::move(after)) {}
    void redo() override { document_.setPartRaw(part_, after_); }
    void undo() override { document_.setPartRaw(part_, before_); }

private:
    ProjectDocument& document_;
    Part project::Project::*part_;
    Part before_;
    Part after_;
};

}  // namespace tiller
