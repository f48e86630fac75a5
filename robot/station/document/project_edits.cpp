// SPDX-License-Identifier: MIT
#include "robot/station/document/project_edits.h"

#include <numeric>

namespace tiller {

InsertWaypoints::InsertWaypoints(int row, std::vector<project::Waypoint> waypoints, const QString& text)
    : ProjectEdit(text), row_(row), waypoints_(std::move(waypoints)) {}

void InsertWaypoints::apply(ProjectDocument& document) {
    document.insertRaw(row_, waypoints_);
    Q_EMIT document.waypointsAppeared(row_, row_ + static_cast<int>(waypoints_.size()) - 1);
}

void InsertWaypoints::revert(ProjectDocument& document) {
    QVector<int> rows(static_cast<int>(waypoints_.size()));
    std::iota(rows.begin(), rows.end(), row_);
    (void)document.takeRaw(rows);
}

RemoveWaypoints::RemoveWaypoints(QVector<int> rows, const QString& text)
    : ProjectEdit(text), rows_(std::move(rows)) {}

void RemoveWaypoints::apply(ProjectDocument& document) {
    taken_ = document.takeRaw(rows_);
}

void RemoveWaypoints::revert(ProjectDocument& document) {
    // Insert adjacent rows together.
    for (int from = 0; from < rows_.size();) {
        int to = from + 1;
        while (to < rows_.size() && rows_[to] == rows_[to - 1] + 1) {
            ++to;
        }
        document.insertRaw(rows_[from], {taken_.begin() + from, taken_.begin() + to});
        from = to;
    }
    Q_EMIT document.waypointsAppeared(rows_.first(), rows_.first());
}

ChangeWaypoints::ChangeWaypoints(std::vector<project::Waypoint> before, std::vector<project::Waypoint> after,
                                 const QString& text)
    : ProjectEdit(text), before_(std::move(before)), after_(std::move(after)) {}

void ChangeWaypoints::apply(ProjectDocument& document) {
    document.replaceRaw(after_);
}

void ChangeWaypoints::revert(ProjectDocument& document) {
    document.replaceRaw(before_);
}

ReorderWaypoints::ReorderWaypoints(QVector<QUuid> before, QVector<QUuid> after, const QString& text)
    : ProjectEdit(text), before_(std::move(before)), after_(std::move(after)) {}

void ReorderWaypoints::apply(ProjectDocument& document) {
    document.reorderRaw(after_);
}

void ReorderWaypoints::revert(ProjectDocument& document) {
    document.reorderRaw(before_);
}

}  // namespace tiller
