// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Duplicates, deletes, moves, copies and pastes the selected waypoints. Each change is one undoable edit of
// the document.

#include <QObject>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"

#include "robot/project/waypoint_list.h"

namespace tiller {

class ProjectDocument;
class WaypointTable;

class WaypointEditing : public QObject {
    Q_OBJECT

public:
    /// document, table  must outlive the object, which edits the selected rows of the table
    WaypointEditing(ProjectDocument& document, WaypointTable& table, QObject* parent = nullptr);

    void duplicate();
    void remove();
    /// by  -1: one row up, 1: one row down
    void move(int by);
    /// Copies the selected waypoints as a table for spreadsheets.
    void copy() const;
    /// Inserts the pasted waypoints after the current row. For a pose without joint positions, uses the
    /// solution nearest to the joint positions of the current row, or of the arm if no row is selected.
    void paste();
    /// Sets the current joint positions [rad] and TCP.
    void setLive(const JointPositions& q, const Pose& tcpOffset);

Q_SIGNALS:
    /// Nothing was changed. `reason` is a sentence. `details` contains the invalid numbers or lines of the
    /// text.
    void refused(const QString& reason, const QString& details);
    /// Requests the selection of this row; -1: no row.
    void rowWanted(int row);

private:
    int rowCount() const;

    ProjectDocument& document_;
    WaypointTable& table_;
    /// Typical position, used until the robot sends data.
    JointPositions liveJoints_{0, -1.57, 1.57, -1.57, -1.57, 0};
    Pose liveTcp_;
};

}  // namespace tiller
