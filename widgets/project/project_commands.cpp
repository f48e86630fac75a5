// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_commands.h"

#include <numeric>

namespace tiller {

InsertWaypoints::InsertWaypoints(ProjectDocument& document, int row, std::vector<project::Waypoint> waypoints,
                                 const QString& text)
    : QUndoCommand(text), document_(document), row_(row), waypoints_(std::move(waypoints)) {}

void InsertWaypoints::redo() {
    document_.insertRaw(row_, waypoints_);
    Q_EMIT document_.waypointsAppeared(row_, row_ + static_cast<int>(waypoints_.size()) - 1);
}

void InsertWaypoints::undo() {
    QVector<int> rows(static_cast<int>(waypoints_.size()));
    std::iota(rows.begin(), rows.end(), row_);
    (void)document_.takeRaw(rows);
}

RemoveWaypoints::RemoveWaypoints(ProjectDocument& document, QVector<int> rows, const QString& text)
    : QUndoCommand(text), document_(document), rows_(std::move(rows)) {}

void RemoveWaypoints::redo() {
    taken_ = document_.takeRaw(rows_);
}

void RemoveWaypoints::undo() {
    // Runs of neighbours go back together.
    for (int from = 0; from < rows_.size();) {
        int to = from + 1;
        while (to < rows_.size() && rows_[to] == rows_[to - 1] + 1) {
            ++to;
        }
        document_.insertRaw(rows_[from], {taken_.begin() + from, taken_.begin() + to});
        from = to;
    }
    Q_EMIT document_.waypointsAppeared(rows_.first(), rows_.first());
}

ChangeWaypoints::ChangeWaypoints(ProjectDocument& document, const QVector<int>& rows,
                                 std::vector<project::Waypoint> after, const QString& text)
    : QUndoCommand(text), document_(document), after_(std::move(after)) {
    for (const int row : rows) {
        before_.push_back(document.waypoints().at(row));
    }
}

void ChangeWaypoints::redo() {
    document_.replaceRaw(after_);
}

void ChangeWaypoints::undo() {
    document_.replaceRaw(before_);
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

}  // namespace tiller
