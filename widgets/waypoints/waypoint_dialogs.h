// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is done to waypoints through a question of its own: properties of many, moves of a selection, patterns, history,
// files. Every answer is one edit of the document, which can be undone.

#include <QObject>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/result.h"
#include "robot/core/spatial.h"
#include "robot/project/waypoint_list.h"

namespace tiller {

class ProjectDocument;
class WaypointTable;

class WaypointDialogs : public QObject {
    Q_OBJECT

public:
    /// document, table  must outlive it; the table's selection is what is edited
    WaypointDialogs(ProjectDocument& document, WaypointTable& table, QObject* parent = nullptr);

    void properties();
    /// What is done at the selected waypoints.
    void actions();
    void moveSelection();
    /// A new pattern at the selected waypoints; the pattern itself where the selected one is a place of it.
    void pattern();
    void dissolvePattern();
    void removePattern();
    void history();
    void importFile();
    void exportFile();
    /// Names ending in .json are JSON, all others CSV. Nothing of a file with an error is used.
    void importFrom(const QString& path);
    /// The selected waypoints, or all where none or one is selected.
    void exportTo(const QString& path);
    /// Where the arm is [rad], with which TCP: for poses that come without joints.
    void setLive(const JointPositions& q, const Pose& tcpOffset);

Q_SIGNALS:
    /// Nothing was done: a sentence that says why, and figures or rows of the text that was not understood.
    void refused(const QString& reason, const QString& details);
    /// Something was done that cannot be seen in the list.
    void done(const QString& text);

private:
    std::vector<project::Waypoint> selected() const;
    QUuid patternOfCurrent() const;

    ProjectDocument& document_;
    WaypointTable& table_;
    JointPositions liveJoints_{0,     -1.57, 1.57,
                               -1.57, -1.57, 0};  ///< until there are data: the arm bent forward
    Pose liveTcp_;
};

}  // namespace tiller
