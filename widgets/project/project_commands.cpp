// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_commands.h"

#include "widgets/project/project_document.h"

namespace tiller {

InsertWaypoints::InsertWaypoints(ProjectDocument& document, int row, std::vector<project::Waypoint> waypoints,
                                 const QString& text)
    : QUndoCommand(text), document_(document), row_(row), waypoints_(std::move(waypoints)) {}

void InsertWaypoints::redo() {
    int row = row_;
    for (const project::Waypoint& waypoint : waypoints_) {
        document_.insertRaw(row++, waypoint);
    }
    Q_EMIT document_.waypointsAppeared(row_, row - 1);
}

void InsertWaypoints::undo() {
    for (std::size_t n = 0; n < waypoints_.size(); ++n) {
        document_.takeRaw(row_);
    }
}

RemoveWaypoints::RemoveWaypoints(ProjectDocument& document, QVector<int> rows, const QString& text)
    : QUndoCommand(text), document_(document), rows_(std::move(rows)) {}

void RemoveWaypoints::redo() {
    taken_.clear();
    for (auto row = rows_.crbegin(); row != rows_.crend(); ++row) {
        taken_.push_back(document_.takeRaw(*row));
    }
}

void RemoveWaypoints::undo() {
    std::size_t n = taken_.size();
    for (const int row : rows_) {
        document_.insertRaw(row, taken_[--n]);
    }
    Q_EMIT document_.waypointsAppeared(rows_.first(), rows_.first());
}

ChangeWaypoint::ChangeWaypoint(ProjectDocument& document, int row, project::Waypoint after,
                               const QString& text)
    : QUndoCommand(text)
    , document_(document)
    , before_(document.waypoints().at(row))
    , after_(std::move(after)) {}

void ChangeWaypoint::redo() {
    document_.replaceRaw(document_.waypoints().indexOf(before_.id), after_);
}

void ChangeWaypoint::undo() {
    document_.replaceRaw(document_.waypoints().indexOf(after_.id), before_);
}

ReorderWaypoints::ReorderWaypoints(ProjectDocument& document, QVector<QUuid> order, const QString& text)
    : QUndoCommand(text), document_(document), after_(std::move(order)) {
    for (const project::Waypoint& waypoint : document.waypoints()) {
        before_.append(waypoint.id);
    }
}

void ReorderWaypoints::redo() {
    document_.reorderRaw(after_);
}

void ReorderWaypoints::undo() {
    document_.reorderRaw(before_);
}

EditFrames::EditFrames(ProjectDocument& document, project::FrameList after, const QString& text)
    : QUndoCommand(text), document_(document), before_(document.frames()), after_(std::move(after)) {}

void EditFrames::redo() {
    document_.setFramesRaw(after_);
}

void EditFrames::undo() {
    document_.setFramesRaw(before_);
}

}  // namespace tiller
