// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The four things that can be done to the list of waypoints, each with its way back.

#include <QUndoCommand>
#include <QVector>
#include <vector>

#include "robot/project/waypoint.h"

namespace tiller {

class WaypointModel;

class InsertWaypoints : public QUndoCommand {
public:
    InsertWaypoints(WaypointModel& model, int row, std::vector<project::Waypoint> waypoints,
                    const QString& text);
    void redo() override;
    void undo() override;

private:
    WaypointModel& model_;
    int row_;
    std::vector<project::Waypoint> waypoints_;
};

class RemoveWaypoints : public QUndoCommand {
public:
    RemoveWaypoints(WaypointModel& model, QVector<int> rows, const QString& text);
    void redo() override;
    void undo() override;

private:
    WaypointModel& model_;
    QVector<int> rows_;  // ascending
    std::vector<project::Waypoint> taken_;
};

class ChangeWaypoint : public QUndoCommand {
public:
    ChangeWaypoint(WaypointModel& model, int row, project::Waypoint after, const QString& text);
    void redo() override;
    void undo() override;

private:
    WaypointModel& model_;
    project::Waypoint before_;
    project::Waypoint after_;
};

class ReorderWaypoints : public QUndoCommand {
public:
    ReorderWaypoints(WaypointModel& model, QVector<QUuid> order, const QString& text);
    void redo() override;
    void undo() override;

private:
    WaypointModel& model_;
    QVector<QUuid> before_;
    QVector<QUuid> after_;
};

}  // namespace tiller
