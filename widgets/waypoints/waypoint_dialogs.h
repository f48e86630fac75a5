// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Functions for waypoints that use dialogs: properties, moving a selection, patterns, history and files. Each
// change is one undoable edit of the document.

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
    /// document, table  must outlive the object, which edits the selected rows of the table
    WaypointDialogs(ProjectDocument& document, WaypointTable& table, QObject* parent = nullptr);

    void properties();
    /// Edits the actions of the selected waypoints.
    void actions();
    void moveSelection();
    /// Creates a pattern from the selected waypoints, or edits the pattern of the selected waypoint.
    void pattern();
    void dissolvePattern();
    void removePattern();
    void history();
    void importFile();
    void exportFile();
    /// Imports waypoints from a file: JSON if the name ends in .json or .tiller, otherwise CSV. Nothing is
    /// imported if the file contains an error.
    void importFrom(const QString& path);
    /// Exports the selected waypoints, or all waypoints if fewer than two are selected.
    void exportTo(const QString& path);
    /// Sets the current joint positions [rad] and TCP, which are used for poses without joint positions.
    void setLive(const JointPositions& q, const Pose& tcpOffset);

Q_SIGNALS:
    /// Nothing was changed. `reason` is a sentence. `details` contains the invalid numbers or lines of the
    /// text.
    void refused(const QString& reason, const QString& details);
    /// A change was made that is not visible in the list.
    void done(const QString& text);

private:
    std::vector<project::Waypoint> selected() const;
    QUuid patternOfCurrent() const;

    ProjectDocument& document_;
    WaypointTable& table_;
    /// Typical position, used until the robot sends data.
    JointPositions liveJoints_{0, -1.57, 1.57, -1.57, -1.57, 0};
    Pose liveTcp_;
};

}  // namespace tiller
