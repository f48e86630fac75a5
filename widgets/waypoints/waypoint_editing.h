// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Edits the selected waypoints other than by teaching: duplicate, delete, move, copy and paste. Each is one
// undoable edit of the document.

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
    /// document, table  must outlive the object; the selection of the table is edited
    WaypointEditing(ProjectDocument& document, WaypointTable& table, QObject* parent = nullptr);

    void duplicate();
    void remove();
    /// by  -1: one row up, 1: one row down
    void move(int by);
    /// Copies the selected waypoints as a table for spreadsheets.
    void copy() const;
    /// Inserts after the current row. A pose without joint positions gets those nearest to the current row, or to
    /// the arm.
    void paste();
    /// Current joint positions [rad] and TCP.
    void setLive(const JointPositions& q, const Pose& tcpOffset);

Q_SIGNALS:
    /// No change was made: a sentence with the reason, and the invalid numbers or lines of the text.
    void refused(const QString& reason, const QString& details);
    /// This row should be selected; -1: none.
    void rowWanted(int row);

private:
    int rowCount() const;

    ProjectDocument& document_;
    WaypointTable& table_;
    JointPositions liveJoints_{0, -1.57, 1.57, -1.57, -1.57, 0};  ///< a typical position until data arrive
    Pose liveTcp_;
};

}  // namespace tiller
