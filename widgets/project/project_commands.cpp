// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_commands.h"

#include "widgets/waypoints/waypoint_model.h"

namespace tiller {

InsertWaypoints::InsertWaypoints(WaypointModel& model, int row, std::vector<project::Waypoint> waypoints,
                                 const QString& text)
    : QUndoCommand(text), model_(model), row_(row), waypoints_(std::move(waypoints)) {}

void InsertWaypoints::redo() {
    int row = row_;
    for (const project::Waypoint& waypoint : waypoints_) {
        model_.insertRaw(row++, waypoint);
    }
    Q_EMIT model_.rowsAppeared(row_, row - 1);
}

void InsertWaypoints::undo() {
    for (std::size_t n = 0; n < waypoints_.size(); ++n) {
        model_.takeRaw(row_);
    }
}

RemoveWaypoints::RemoveWaypoints(WaypointModel& model, QVector<int> rows, const QString& text)
    : QUndoCommand(text), model_(model), rows_(std::move(rows)) {}

void RemoveWaypoints::redo() {
    taken_.clear();
    for (auto row = rows_.crbegin(); row != rows_.crend(); ++row) {
        taken_.push_back(model_.takeRaw(*row));
    }
}

void RemoveWaypoints::undo() {
    std::size_t n = taken_.size();
    for (const int row : rows_) {
        model_.insertRaw(row, taken_[--n]);
    }
    Q_EMIT model_.rowsAppeared(rows_.first(), rows_.first());
}

ChangeWaypoint::ChangeWaypoint(WaypointModel& model, int row, project::Waypoint after, const QString& text)
    : QUndoCommand(text), model_(model), before_(model.waypoints().at(row)), after_(std::move(after)) {}

void ChangeWaypoint::redo() {
    model_.replaceRaw(model_.waypoints().indexOf(before_.id), after_);
}

void ChangeWaypoint::undo() {
    model_.replaceRaw(model_.waypoints().indexOf(after_.id), before_);
}

ReorderWaypoints::ReorderWaypoints(WaypointModel& model, QVector<QUuid> order, const QString& text)
    : QUndoCommand(text), model_(model), after_(std::move(order)) {
    for (const project::Waypoint& waypoint : model.waypoints()) {
        before_.append(waypoint.id);
    }
}

void ReorderWaypoints::redo() {
    model_.reorderRaw(after_);
}

void ReorderWaypoints::undo() {
    model_.reorderRaw(before_);
}

}  // namespace tiller
