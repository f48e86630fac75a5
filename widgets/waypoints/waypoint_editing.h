// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is done to the selected waypoints apart from teaching: duplicate, delete, move, copy and paste. Every
// step is one edit of the document, which can be undone.

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
    /// document, table  must outlive it; the table's selection is what is edited
    WaypointEditing(ProjectDocument& document, WaypointTable& table, QObject* parent = nullptr);

    void duplicate();
    void remove();
    /// by  -1: one row up, 1: one row down
    void move(int by);
    /// As a table that a spreadsheet takes, too.
    void copy() const;
    /// After the current row. A pose that comes without joints gets the posture nearest to the current row's, or
    /// else to the arm's.
    void paste();
    /// Where the arm is [rad], with which TCP.
    void setLive(const JointPositions& q, const Pose& tcpOffset);

Q_SIGNALS:
    /// Nothing was done: a sentence that says why, and figures or rows of the text that was not understood.
    void refused(const QString& reason, const QString& details);
    /// The row to be selected now; -1 for none.
    void rowWanted(int row);

private:
    int rowCount() const;

    ProjectDocument& document_;
    WaypointTable& table_;
    JointPositions liveJoints_{0,     -1.57, 1.57,
                               -1.57, -1.57, 0};  ///< until there are data: the arm bent forward
    Pose liveTcp_;
};

}  // namespace tiller
