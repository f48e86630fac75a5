// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The project that is open: its waypoints and frames, the arm they are for, and the one history of every
// edit. Tables show it, the store writes it. All of it belongs to the GUI thread.

#include <QObject>
#include <QUndoStack>
#include <vector>

#include "robot/core/robot_model.h"
#include "robot/project/project_file.h"
#include "robot/project/reachability.h"

namespace tiller {

class ProjectDocument : public QObject {
    Q_OBJECT

public:
    explicit ProjectDocument(QObject* parent = nullptr);

    const project::Project& project() const { return project_; }
    const project::WaypointList& waypoints() const { return project_.waypoints; }
    const project::FrameList& frames() const { return project_.frames; }
    const RobotModel& robot() const { return *robot_; }
    /// Reach depends on the arm.
    void setRobot(RobotModelId robot);
    const project::Reach& reach(int row) const { return reach_.at(static_cast<std::size_t>(row)); }
    QUndoStack& undoStack() { return undo_; }

    /// Another project; the history is empty afterwards.
    void setProject(project::Project project);

    // Edits by hand: one undo step each, named `text`. Rows count from 0.
    void insertWaypoints(int row, const std::vector<project::Waypoint>& waypoints, const QString& text);
    void removeWaypoints(QList<int> rows);
    /// Does nothing when `waypoint` is as it was.
    void changeWaypoint(int row, const project::Waypoint& waypoint, const QString& text);
    /// Moves the waypoints at `rows`, in their order, in front of the one at `before`.
    void moveWaypointsBefore(const QList<int>& rows, int before);
    void insertFrame(int row, const project::Frame& frame, const QString& text);
    /// Does nothing when `frame` is as it was.
    void changeFrame(int row, const project::Frame& frame, const QString& text);
    /// Waypoints that were given in it stay where they are, given in Base.
    void removeFrame(int row);

    // For the undo commands.
    void insertRaw(int row, const project::Waypoint& waypoint);
    project::Waypoint takeRaw(int row);
    void replaceRaw(int row, const project::Waypoint& waypoint);
    void reorderRaw(const QVector<QUuid>& order);
    /// Every waypoint's frame must be among them.
    void setFramesRaw(const project::FrameList& frames);

Q_SIGNALS:
    /// Anything in the project is different now.
    void documentChanged();
    /// The frames are others, or stand elsewhere.
    void framesChanged();
    /// Waypoints that were added or put back, to select them.
    void waypointsAppeared(int first, int last);

    // For tables, each around or after one change of the list of waypoints.
    void projectAboutToBeReplaced();
    void projectReplaced();
    void waypointAboutToBeInserted(int row);
    void waypointInserted(int row);
    void waypointAboutToBeRemoved(int row);
    void waypointRemoved(int row);
    /// Also when only their reach is another one.
    void waypointsChanged(int first, int last);
    void orderAboutToChange();
    void orderChanged();

private:
    void refreshReach();
    void tellAllChanged();
    void pushFrames(const project::FrameList& after, const QString& text);

    project::Project project_;
    std::vector<project::Reach> reach_;  ///< of the waypoints, in their order
    const RobotModel* robot_;
    QUndoStack undo_;
};

}  // namespace tiller
